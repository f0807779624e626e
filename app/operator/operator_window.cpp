#include "app/operator/operator_window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/window/window_gui.hpp"
#include "operator_panel.hpp"

namespace deixis::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr float panel_width = 340.0F;  // in units of the content scale
constexpr WindowSize min_window{480, 420};
// A little under 1/15 s and 1/30 s, so that a frame that comes a moment early is not put off by a whole
// period.
constexpr double between_pictures_s = 0.059;
constexpr double while_used_s = 0.026;
constexpr double used_for_s = 0.5;     // after a key or the mouse
constexpr double longest_share = 0.1;  // of all time that pictures may take
constexpr double longest_pause_s = 0.5;

// The letters of what the session tells, in any language.
void requireLetters(WindowGui& gui, const OperatorView& view, OperatorControls& controls) {
    for (const std::string* text : {&view.feed.participant, &view.status.part, &view.status.remark,
                                    &view.device, &view.feed.progress.trial})
        gui.require(*text);
    for (const auto& stage : view.feed.progress.stages) gui.require(stage.name);
    for (const auto& warning : view.warnings) gui.require(warning);
    for (const auto& event : view.feed.events) gui.require(event.detail);
    for (const OperatorControls::Text* text : {&controls.note(), &controls.reason()})
        gui.require(text->data());
}

}  // namespace

CurrentContext::CurrentContext(GLFWwindow* window)
    : before_(glfwGetCurrentContext()), changed_(before_ != window) {
    if (changed_) glfwMakeContextCurrent(window);
}

CurrentContext::~CurrentContext() {
    if (changed_) glfwMakeContextCurrent(before_);
}

struct OperatorWindow::Impl {
    explicit Impl(GlWindow& in) : window(in) {
        GLFWwindow* handle = window.handle();
        glfwSetWindowUserPointer(handle, this);
        glfwSetKeyCallback(handle, [](GLFWwindow* from, int key, int, int action, int) {
            self(from).used();
            if (action != GLFW_PRESS) return;
            self(from).tapped.push_back(key);
            self(from).onKey(key);
        });
        glfwSetCharCallback(handle, [](GLFWwindow* from, unsigned int) { self(from).used(); });
        glfwSetMouseButtonCallback(handle, [](GLFWwindow* from, int, int, int) { self(from).used(); });
        glfwSetScrollCallback(handle, [](GLFWwindow* from, double, double) { self(from).used(); });
        glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* from, int width, int height) {
            self(from).size = {width, height};
        });
        glfwSetWindowIconifyCallback(handle, [](GLFWwindow* from, int is_iconified) {
            self(from).iconified = is_iconified == GLFW_TRUE;
        });
        gui.emplace(handle);  // after the callbacks, to which it passes on
        const auto scaled = [this](int length) {
            return static_cast<int>(std::lround(static_cast<float>(length) * gui->scale()));
        };
        glfwSetWindowSizeLimits(handle, scaled(min_window.width), scaled(min_window.height), GLFW_DONT_CARE,
                                GLFW_DONT_CARE);
        glfwSwapInterval(0);
    }
    ~Impl() {
        GLFWwindow* handle = window.handle();
        const CurrentContext current(handle);
        gui.reset();
        glfwSetKeyCallback(handle, nullptr);
        glfwSetCharCallback(handle, nullptr);
        glfwSetMouseButtonCallback(handle, nullptr);
        glfwSetScrollCallback(handle, nullptr);
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
    double cost_s = 0.0;  // of a picture, lately
    double used_at_s = -1.0;
    std::vector<int> tapped;  // keys that went down since the last picture
    bool paused = false;      // as last told
    OperatorControls controls;

    static Impl& self(GLFWwindow* from) { return *static_cast<Impl*>(glfwGetWindowUserPointer(from)); }
    [[nodiscard]] double now_s() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
    void used() { used_at_s = now_s(); }

    void onKey(int key) {
        const bool asks = controls.question() != OperatorControls::Question::none;
        if (key == GLFW_KEY_ESCAPE && asks)
            controls.leaveQuestion();
        else if (controls.typing() || asks)
            return;
        else if (key == GLFW_KEY_R)
            controls.recentre();
        else if (key == GLFW_KEY_P && paused)
            controls.resume();
        else if (key == GLFW_KEY_P || key == GLFW_KEY_ESCAPE)
            controls.pause();
    }

    [[nodiscard]] int panelWidth() const {
        return std::min(static_cast<int>(std::lround(panel_width * gui->scale())), size.width / 2);
    }

    [[nodiscard]] WindowSize mirrorSize() const {
        return {std::max(1, size.width - panelWidth()), std::max(1, size.height)};
    }

    // As large as it fits, in the middle, behind all that the text library draws.
    void drawMirror(const MirrorTexture& mirror) const {
        const WindowSize room = mirrorSize();
        const auto width = static_cast<float>(mirror.size.width);
        const auto height = static_cast<float>(mirror.size.height);
        const auto across = static_cast<float>(room.width);
        const auto down = static_cast<float>(room.height);
        const float scale = std::min(across / width, down / height);
        const ImVec2 low{0.5F * (across - scale * width), 0.5F * (down - scale * height)};
        // NOLINTNEXTLINE(performance-no-int-to-ptr): the library's own way to name a texture
        auto* const id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(mirror.texture));
        ImGui::GetBackgroundDrawList()->AddImage(id, low, {low.x + scale * width, low.y + scale * height},
                                                 {0.0F, 1.0F}, {1.0F, 0.0F});
    }

    // The text library's older versions look only at the keys that are down in a picture, and would miss
    // those that have gone up since the last one.
    void holdTapped(bool hold) {
#if IMGUI_VERSION_NUM < 18700
        gui->makeCurrent();
        for (const int key : tapped)
            if (key >= 0)
                ImGui::GetIO().KeysDown[key] = hold || glfwGetKey(window.handle(), key) == GLFW_PRESS;
#endif
        if (!hold) tapped.clear();
    }

    void show(const OperatorView& view, const MirrorPicture* mirror) {
        const double begun_s = now_s();
        const CurrentContext current(window.handle());
        const auto panel = static_cast<float>(panelWidth());
        paused = view.paused;
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDisable(GL_FRAMEBUFFER_SRGB);
        requireLetters(*gui, view, controls);
        holdTapped(true);
        gui->beginFrame();
        if (mirror != nullptr) {
            glViewport(0, 0, size.width, size.height);
            glClearColor(0.05F, 0.06F, 0.08F, 1.0F);
            glClear(GL_COLOR_BUFFER_BIT);
            if (const MirrorTexture kept = mirror->texture(); kept.texture != 0) drawMirror(kept);
        }
        drawOperatorPanel(*gui, {static_cast<float>(size.width) - panel, 0.0F},
                          {panel, static_cast<float>(size.height)}, view, controls, begun_s);
        gui->endFrame();
        holdTapped(false);
        glfwSwapBuffers(window.handle());
        shown_s = now_s();
        cost_s += 0.2 * (shown_s - begun_s - cost_s);
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
        impl_->used();
        impl_->controls.end(impl_->now_s());
    }
    return impl_->controls.take();
}

bool OperatorWindow::visible() const {
    return impl_->size.width > 0 && impl_->size.height > 0 && !impl_->iconified;
}

bool OperatorWindow::due() const {
    if (!visible()) return false;
    const double now_s = impl_->now_s();
    const double since_s = now_s - impl_->shown_s;
    if (now_s - impl_->used_at_s < used_for_s) return since_s >= while_used_s;
    return since_s >= std::max(between_pictures_s, std::min(impl_->cost_s / longest_share, longest_pause_s));
}

WindowSize OperatorWindow::mirrorSize() const {
    return impl_->mirrorSize();
}

void OperatorWindow::show(const OperatorView& view) {
    impl_->show(view, nullptr);
}

void OperatorWindow::show(const OperatorView& view, const MirrorPicture& mirror) {
    impl_->show(view, &mirror);
}

}  // namespace deixis::app
