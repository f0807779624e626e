#include "operator_window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "operator_panel.hpp"
#include "operator_words.hpp"

namespace deixis::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr float panel_width = 340.0F;  // in units of the content scale
constexpr WindowSize least_window{480, 360};
// A little under 1/30 s, so that a frame that comes a moment early is not put off by a whole period.
constexpr double between_pictures_s = 0.026;

}  // namespace

struct OperatorWindow::Impl {
    explicit Impl(GlWindow& in) : window(in) {
        GLFWwindow* handle = window.handle();
        glfwSetWindowUserPointer(handle, this);
        glfwSetKeyCallback(handle, [](GLFWwindow* from, int key, int, int action, int) {
            if (action == GLFW_PRESS) static_cast<Impl*>(glfwGetWindowUserPointer(from))->onKey(key);
        });
        glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* from, int width, int height) {
            static_cast<Impl*>(glfwGetWindowUserPointer(from))->size = {width, height};
        });
        glfwSetWindowIconifyCallback(handle, [](GLFWwindow* from, int is_iconified) {
            static_cast<Impl*>(glfwGetWindowUserPointer(from))->iconified = is_iconified == GLFW_TRUE;
        });
        gui.emplace(handle);  // after the key callback, to which it passes on
        const auto scaled = [this](int length) {
            return static_cast<int>(std::lround(static_cast<float>(length) * gui->scale()));
        };
        glfwSetWindowSizeLimits(handle, scaled(least_window.width), scaled(least_window.height),
                                GLFW_DONT_CARE, GLFW_DONT_CARE);
        glfwSwapInterval(0);
    }
    ~Impl() {
        gui.reset();
        GLFWwindow* handle = window.handle();
        glfwSetKeyCallback(handle, nullptr);
        glfwSetFramebufferSizeCallback(handle, nullptr);
        glfwSetWindowIconifyCallback(handle, nullptr);
        glfwSetWindowUserPointer(handle, nullptr);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    GlWindow& window;
    // Kept from the window's events: asking the window system in each frame could hold the frame up.
    WindowSize size = window.framebufferSize();
    bool iconified = glfwGetWindowAttrib(window.handle(), GLFW_ICONIFIED) == GLFW_TRUE;
    std::optional<WindowGui> gui;
    Clock::time_point start = Clock::now();
    double shown_s = -1.0;
    AskTwice end;
    OperatorRequest asked;

    [[nodiscard]] double now_s() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

    void onKey(int key) {
        if (key == GLFW_KEY_R) asked.recentre = true;
        if (key == GLFW_KEY_P || key == GLFW_KEY_ESCAPE) asked.pause = true;
    }

    void askToEnd() {
        if (end.ask(now_s())) asked.end = true;
    }

    [[nodiscard]] int panelWidth() const {
        return std::min(static_cast<int>(std::lround(panel_width * gui->scale())), size.width / 2);
    }
};

OperatorWindow::OperatorWindow(GlWindow& window) : impl_(std::make_unique<Impl>(window)) {}
OperatorWindow::~OperatorWindow() = default;

OperatorRequest OperatorWindow::poll() {
    impl_->gui->makeCurrent();  // its callbacks look for it
    glfwPollEvents();
    GLFWwindow* handle = impl_->window.handle();
    if (glfwWindowShouldClose(handle) == GLFW_TRUE) {
        glfwSetWindowShouldClose(handle, GLFW_FALSE);
        impl_->askToEnd();
    }
    return std::exchange(impl_->asked, {});
}

bool OperatorWindow::visible() const {
    return impl_->size.width > 0 && impl_->size.height > 0 && !impl_->iconified;
}

bool OperatorWindow::due() const {
    return visible() && impl_->now_s() - impl_->shown_s >= between_pictures_s;
}

WindowSize OperatorWindow::mirrorSize() const {
    return {std::max(1, impl_->size.width - impl_->panelWidth()), std::max(1, impl_->size.height)};
}

void OperatorWindow::show(const OperatorView& view) {
    Impl& my = *impl_;
    const auto panel = static_cast<float>(my.panelWidth());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    my.gui->beginFrame();
    const PanelClicks clicks =
        drawOperatorPanel(*my.gui, {static_cast<float>(my.size.width) - panel, 0.0F},
                          {panel, static_cast<float>(my.size.height)}, view, my.end.left(my.now_s()));
    my.gui->endFrame();
    if (clicks.pause) my.asked.pause = true;
    if (clicks.recentre) my.asked.recentre = true;
    if (clicks.end) my.askToEnd();
    my.shown_s = my.now_s();
    glfwSwapBuffers(my.window.handle());
}

}  // namespace deixis::app
