// X11 with GLX. Its macros (None, Bool, Status, ...) stay in this file: it is included last.
#include <array>

#include "xr_graphics_binding.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/glx.h>
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

namespace deixis::app {

namespace {

class XlibBinding : public XrGraphicsBinding {
  public:
    explicit XlibBinding(const XrGraphicsBindingOpenGLXlibKHR& binding) : binding_(binding) {}
    [[nodiscard]] const void* next() const override { return &binding_; }

  private:
    XrGraphicsBindingOpenGLXlibKHR binding_;
};

/// The framebuffer configuration that the context was made with; null where GLX does not tell.
GLXFBConfig configOf(Display* display, GLXContext context) {
    int id = 0;
    if (glXQueryContext(display, context, GLX_FBCONFIG_ID, &id) != Success) return nullptr;
    const std::array wanted{GLX_FBCONFIG_ID, id, static_cast<int>(None)};
    int count = 0;
    GLXFBConfig* found = glXChooseFBConfig(display, DefaultScreen(display), wanted.data(), &count);
    if (found == nullptr) return nullptr;
    GLXFBConfig config = count > 0 ? found[0] : nullptr;
    XFree(found);
    return config;
}

}  // namespace

Result<std::unique_ptr<XrGraphicsBinding>> bindGraphics(const GlWindow& window) {
    glfwMakeContextCurrent(window.handle());
    Display* display = glXGetCurrentDisplay();
    const GLXContext context = glXGetCurrentContext();  // none where GLFW took Wayland or EGL
    if (display == nullptr || context == nullptr)
        return fail(
            "headset", "the window is no X11 window with GLX, which OpenXR runtimes need",
            "On a Wayland desktop set XDG_SESSION_TYPE=x11 for this program, so that it uses XWayland");
    const GLXFBConfig config = configOf(display, context);
    if (config == nullptr)
        return fail("headset", "GLX does not tell the configuration of the window's context",
                    "Update the graphics driver");

    auto binding = typed<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
    binding.xDisplay = display;
    binding.glxFBConfig = config;
    binding.glxDrawable = glXGetCurrentDrawable();
    binding.glxContext = context;
    if (XVisualInfo* visual = glXGetVisualFromFBConfig(display, config); visual != nullptr) {
        binding.visualid = static_cast<std::uint32_t>(visual->visualid);
        XFree(visual);
    }
    return std::make_unique<XlibBinding>(binding);
}

}  // namespace deixis::app
