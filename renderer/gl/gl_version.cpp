#include "renderer/gl/gl_version.hpp"

#include <fmt/format.h>

#include "renderer/gl/gl.hpp"

namespace deixis::renderer {
namespace {

const char* words(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text != nullptr ? text : "unknown";
}

}  // namespace

Result<void> requireGlVersion(const char* where) {
    const int found = epoxy_is_desktop_gl() ? epoxy_gl_version() : 0;
    if (found >= needed_gl_major * 10 + needed_gl_minor) return {};
    return fail(
        where,
        fmt::format("OpenGL {}.{} core is needed, found \"{}\" from driver \"{}\" ({})", needed_gl_major,
                    needed_gl_minor, words(GL_VERSION), words(GL_RENDERER), words(GL_VENDOR)),
        "Update the graphics driver, or unset MESA_GL_VERSION_OVERRIDE; LIBGL_ALWAYS_SOFTWARE=1 "
        "draws on the processor instead");
}

}  // namespace deixis::renderer
