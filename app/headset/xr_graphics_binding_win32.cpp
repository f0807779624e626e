// Windows with WGL. Not tried yet: nobody has compiled or run this file.
#include "xr_graphics_binding.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#define GLFW_EXPOSE_NATIVE_WIN32
#define GLFW_EXPOSE_NATIVE_WGL
#include <GLFW/glfw3native.h>
#include <unknwn.h>
#define XR_USE_PLATFORM_WIN32
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

namespace deixis::app {

namespace {

class Win32Binding : public XrGraphicsBinding {
  public:
    Win32Binding(HWND window, HGLRC context) : window_(window) {
        binding_.hDC = GetDC(window);
        binding_.hGLRC = context;
    }
    ~Win32Binding() override { ReleaseDC(window_, binding_.hDC); }
    Win32Binding(const Win32Binding&) = delete;
    Win32Binding& operator=(const Win32Binding&) = delete;
    [[nodiscard]] const void* next() const override { return &binding_; }

  private:
    HWND window_;
    XrGraphicsBindingOpenGLWin32KHR binding_ =
        typed<XrGraphicsBindingOpenGLWin32KHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_WIN32_KHR);
};

}  // namespace

Result<std::unique_ptr<XrGraphicsBinding>> bindGraphics(const GlWindow& window) {
    const HWND handle = glfwGetWin32Window(window.handle());
    const HGLRC context = glfwGetWGLContext(window.handle());
    if (handle == nullptr || context == nullptr)
        return fail("headset", "the window has no WGL context, which OpenXR runtimes need",
                    "Update the graphics driver");
    return std::make_unique<Win32Binding>(handle, context);
}

}  // namespace deixis::app
