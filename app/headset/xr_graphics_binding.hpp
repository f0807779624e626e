// What ties an OpenXR session to the window's OpenGL context: the one place that knows the platform.
#pragma once

#include <openxr/openxr.h>

#include <memory>

#include "app/window/gl_window.hpp"
#include "xr_runtime.hpp"

namespace deixis::app {

/// A structure for XrSessionCreateInfo::next; owns it. xr_graphics_binding_xlib.cpp, or _win32.cpp.
class XrGraphicsBinding {
  public:
    virtual ~XrGraphicsBinding() = default;
    [[nodiscard]] virtual const void* next() const = 0;
};

/// For the window's context. Fails where the window system gives no such handle (a Wayland window).
[[nodiscard]] Result<std::unique_ptr<XrGraphicsBinding>> bindGraphics(const GlWindow& window);

/// Asks the runtime which OpenGL it needs, which the specification wants done before a session is made; fails
/// where 4.5 is not within it.
[[nodiscard]] Result<void> requireOpenGl(const XrRuntime& runtime);

}  // namespace deixis::app
