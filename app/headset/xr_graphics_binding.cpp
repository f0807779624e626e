#include "xr_graphics_binding.hpp"

#define XR_USE_GRAPHICS_API_OPENGL
#include <fmt/format.h>
#include <openxr/openxr_platform.h>

namespace deixis::app {

Result<void> requireOpenGl(const XrRuntime& runtime) {
    const auto requirementsOf =
        runtime.function<PFN_xrGetOpenGLGraphicsRequirementsKHR>("xrGetOpenGLGraphicsRequirementsKHR");
    auto need = typed<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    check(requirementsOf == nullptr ? XR_ERROR_FUNCTION_UNSUPPORTED
                                    : requirementsOf(runtime.instance(), runtime.system(), &need),
          "xrGetOpenGLGraphicsRequirementsKHR");
    constexpr XrVersion ours = XR_MAKE_VERSION(4, 5, 0);
    if (need.minApiVersionSupported <= ours && ours <= need.maxApiVersionSupported) return {};
    return fail("headset",
                fmt::format("{} {} takes OpenGL {}.{} to {}.{}; OpenGL 4.5 is needed", runtime.name(),
                            runtime.version(), XR_VERSION_MAJOR(need.minApiVersionSupported),
                            XR_VERSION_MINOR(need.minApiVersionSupported),
                            XR_VERSION_MAJOR(need.maxApiVersionSupported),
                            XR_VERSION_MINOR(need.maxApiVersionSupported)),
                "Update the runtime, or use another");
}

}  // namespace deixis::app
