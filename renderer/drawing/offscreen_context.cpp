// EGL without a window. A graphics card's own device comes first, since Mesa's surfaceless platform would
// draw on the processor on a machine whose card is not Mesa's; then surfaceless, then what is left.
#include <epoxy/egl.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "renderer/drawing/renderer.hpp"
#include "renderer/gl/gl_version.hpp"

namespace deixis::renderer {
namespace {

constexpr const char* where = "off-screen drawing";

struct Candidate {
    std::string name;
    EGLDisplay display = EGL_NO_DISPLAY;
};

std::vector<Candidate> candidates() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Candidate> cards;
    std::vector<Candidate> software;
    if (epoxy_extension_in_string(client, "EGL_EXT_platform_base") &&
        epoxy_extension_in_string(client, "EGL_EXT_platform_device") &&
        epoxy_extension_in_string(client, "EGL_EXT_device_enumeration") &&
        epoxy_extension_in_string(client, "EGL_EXT_device_query")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE)
            for (int i = 0; i < count; ++i) {
                EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
                const bool is_software = epoxy_extension_in_string(
                    eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
                (is_software ? software : cards)
                    .push_back({fmt::format("EGL device {}", i),
                                eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr)});
            }
    }
    std::vector<Candidate> all = std::move(cards);
    if (epoxy_extension_in_string(client, "EGL_EXT_platform_base") &&
        epoxy_extension_in_string(client, "EGL_MESA_platform_surfaceless"))
        all.push_back({"EGL surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                                   EGL_DEFAULT_DISPLAY, nullptr)});
    all.insert(all.end(), software.begin(), software.end());
    all.push_back({"EGL default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
    return all;
}

EGLContext makeContext(EGLDisplay display, bool needed_version) {
#ifdef NDEBUG
    constexpr EGLint debug = EGL_FALSE;
#else
    constexpr EGLint debug = EGL_TRUE;
#endif
    const std::array<EGLint, 9> needed{EGL_CONTEXT_MAJOR_VERSION,
                                       needed_gl_major,
                                       EGL_CONTEXT_MINOR_VERSION,
                                       needed_gl_minor,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                       EGL_CONTEXT_OPENGL_DEBUG,
                                       debug,
                                       EGL_NONE};
    const std::array<EGLint, 1> any{EGL_NONE};
    const std::array<EGLint, 3> config_attributes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    // Every surface type will do, but the default asks for windows, which surfaceless displays have none of.
    const std::array<EGLint, 5> surfaceless{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                            EGL_NONE};
    if (eglChooseConfig(display, surfaceless.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        if (eglChooseConfig(display, config_attributes.data(), &config, 1, &count) == EGL_FALSE || count == 0)
            config = EGL_NO_CONFIG_KHR;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, needed_version ? needed.data() : any.data());
}

}  // namespace

struct OffscreenContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (context == EGL_NO_CONTEXT) return;
        if (eglGetCurrentContext() == context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
        // The display stays initialised: it is one per process and other contexts may live on it.
    }
};

namespace {

/// Makes a context on the display current, or says why not.
template <typename Impl>
Result<void> tryDisplay(const Candidate& candidate, Impl& impl) {
    if (candidate.display == EGL_NO_DISPLAY ||
        eglInitialize(candidate.display, nullptr, nullptr) == EGL_FALSE)
        return fail(candidate.name, fmt::format("eglInitialize failed ({:#x})", eglGetError()));
    const char* extensions = eglQueryString(candidate.display, EGL_EXTENSIONS);
    if (!epoxy_extension_in_string(extensions, "EGL_KHR_create_context") ||
        !epoxy_extension_in_string(extensions, "EGL_KHR_surfaceless_context"))
        return fail(candidate.name, "no OpenGL contexts without a surface");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return fail(candidate.name, "no desktop OpenGL");
    impl.display = candidate.display;
    impl.context = makeContext(candidate.display, true);
    const EGLint error = impl.context == EGL_NO_CONTEXT ? eglGetError() : EGL_SUCCESS;
    // An older context, made only to tell which version there is.
    if (impl.context == EGL_NO_CONTEXT) impl.context = makeContext(candidate.display, false);
    if (impl.context == EGL_NO_CONTEXT)
        return fail(candidate.name, fmt::format("eglCreateContext failed ({:#x})", error));
    if (eglMakeCurrent(candidate.display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl.context) == EGL_FALSE)
        return fail(candidate.name, fmt::format("eglMakeCurrent failed ({:#x})", eglGetError()));
    return requireGlVersion(candidate.name.c_str());
}

}  // namespace

OffscreenContext::OffscreenContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;
OffscreenContext::~OffscreenContext() = default;

Result<OffscreenContext> OffscreenContext::create() {
    if (!epoxy_has_egl())
        return fail(where, "EGL is needed, but libEGL.so.1 is not on this machine",
                    "Install it (Debian: apt install libegl1 libgl1-mesa-dri)");
    std::string reasons;
    std::string hint;
    for (const Candidate& candidate : candidates()) {
        auto impl = std::make_unique<Impl>();
        const Result<void> made = tryDisplay(candidate, *impl);
        if (made) return OffscreenContext(std::move(impl));
        reasons +=
            fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", made.error().where, made.error().message);
        if (hint.empty()) hint = made.error().hint;
    }
    return fail(where, fmt::format("no OpenGL {}.{} context: {}", needed_gl_major, needed_gl_minor, reasons),
                hint.empty() ? "Install a driver (Debian: apt install libegl1 libgl1-mesa-dri)" : hint);
}

}  // namespace deixis::renderer
