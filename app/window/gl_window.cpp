#include "app/window/gl_window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/number.hpp"

namespace deixis::app {

namespace {

std::string lastGlfwError() {
    const char* words = nullptr;
    if (glfwGetError(&words) == GLFW_NO_ERROR || words == nullptr) return "no reason given";
    return words;
}

void hintContext() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer has its own depth buffer
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

}  // namespace

Result<WindowSize> parseWindowSize(const std::string& text) {
    const auto cross = std::min(text.find('x'), text.size());
    const auto width = naturalNumber(text.substr(0, cross));
    const auto height = naturalNumber(text.substr(std::min(cross + 1, text.size())));
    if (width && height && *width >= 64 && *width <= 8192 && *height >= 64 && *height <= 8192)
        return WindowSize{static_cast<int>(*width), static_cast<int>(*height)};
    return fail(
        "--size",
        fmt::format("'{}' is not a size; expected WIDTHxHEIGHT, each 64 to 8192, such as 1280x720", text));
}

Result<std::unique_ptr<GlWindow>> GlWindow::open(const std::string& title, WindowSize size, bool fullscreen) {
    if (glfwInit() == GLFW_FALSE)
        return fail("window", "the window system cannot be reached: " + lastGlfwError(),
                    "A window needs a display; without one use --station simulated, or --screenshot");
    hintContext();
    GLFWmonitor* monitor = fullscreen ? glfwGetPrimaryMonitor() : nullptr;
    if (monitor != nullptr) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        size = {mode->width, mode->height};
    }
    GLFWwindow* window = glfwCreateWindow(size.width, size.height, title.c_str(), monitor, nullptr);
    if (window == nullptr) {
        const std::string why = lastGlfwError();
        glfwTerminate();
        return fail("window", "no window with OpenGL 4.5 core could be opened: " + why,
                    "Update the graphics driver, or use a machine that has OpenGL 4.5");
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return std::unique_ptr<GlWindow>(new GlWindow(window, true));
}

Result<std::unique_ptr<GlWindow>> GlWindow::openSecond(const GlWindow& first, const std::string& title,
                                                       WindowSize size) {
    hintContext();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_FOCUSED, GLFW_FALSE);
    glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, first.handle());
    if (window == nullptr) return fail("window", "no second window could be opened: " + lastGlfwError());
    return std::unique_ptr<GlWindow>(new GlWindow(window, false));
}

GlWindow::~GlWindow() {
    glfwDestroyWindow(window_);
    if (owns_glfw_) glfwTerminate();
}

WindowSize GlWindow::framebufferSize() const {
    WindowSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
}

double GlWindow::refreshRate_hz() const {
    GLFWmonitor* monitor = glfwGetWindowMonitor(window_);
    if (monitor == nullptr) monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    return mode != nullptr && mode->refreshRate > 0 ? mode->refreshRate : 60.0;
}

}  // namespace deixis::app
