#include "app/desktop/desktop_station.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <thread>
#include <tuple>
#include <utility>

#include "app/operator/desktop_operator.hpp"
#include "app/window/frame_scene.hpp"
#include "core/utc.hpp"
#include "desktop_view.hpp"
#include "typed_text.hpp"

namespace deixis::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double look_rad_per_pixel = radiansFromDegrees(0.07);
constexpr double max_pitch_rad = radiansFromDegrees(80.0);
constexpr double max_lean_m = 0.25;
constexpr double farther_step_m = 0.05;  // a notch of the wheel, or a page key
constexpr double lean_speed_per_s = 4.0;
constexpr double settles_after_focus_s = 0.3;
constexpr double longest_gap_s = 3600.0;  // between frames, for counting those dropped

bool typing(const studies::PresentedFrame& frame) {
    return frame.panel && std::any_of(frame.panel->fields.begin(), frame.panel->fields.end(),
                                      [](const studies::PanelField& field) { return field.active; });
}

studies::TrackedPose tracked(const Pose& pose) {
    return {pose, true, true, true};
}

}  // namespace

struct DesktopStation::State {
    DesktopOptions options;
    std::unique_ptr<GlWindow> window;
    std::unique_ptr<renderer::Renderer> renderer;
    std::unique_ptr<DesktopOperator> operators;  // none: no window for the experimenter
    Clock::time_point start = Clock::now();
    double utc_offset_s = 0.0;
    double period_s = 1.0 / 60.0;
    double last_time_s = 0.0;
    double last_swap_s = 0.0;
    double last_begin_s = 0.0;
    std::optional<double> last_shown_s;  // when the last frame with a picture was
    Pose told_head{};                    // with the frame begun last
    Ray told_ray{};
    double focused_at_s = 0.0;
    bool in_front = true;  // has the mouse and the keyboard

    Look look{};
    Vec3 lean_m{0.0};
    double cursor_x = 0.0, cursor_y = 0.0;      // on the window, in its own units
    double reported_x = 0.0, reported_y = 0.0;  // the same; while the view is turned, elsewhere
    bool turning = false;                       // the button that turns the view is down
    // Moved after a press, within one frame.
    double later_right_px = 0.0, later_down_px = 0.0;
    std::optional<std::pair<double, double>> later_cursor;

    studies::InputFrame pending{};  // what has happened since the last frame
    TypedText typed;
    bool held = false;                    // the button that selects is down, and meant
    studies::PresentedFrame presented{};  // what is on the screen
    std::size_t missing_told = 0;         // bytes of the renderer's missing characters
    int windowed_x = 0, windowed_y = 0;
    WindowSize windowed{};

    [[nodiscard]] double now_s() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

    void onKey(int key);
    [[nodiscard]] OperatorRequest pollEvents();
    void onFocus(bool focused);
    void onCursor(double x, double y);
    void onWindowMoved();
    void onSelect(bool down);
    void onTurning(bool down);
    void turn(double right_px, double down_px);
    void moveOn();
    void toggleFullscreen();
    void updateLean(double elapsed_s);
    [[nodiscard]] Pose head() const;
    [[nodiscard]] Ray cursorRay(const Pose& stage_from_head) const;
    [[nodiscard]] double aspect() const;
    [[nodiscard]] int droppedFrames() const;
    [[nodiscard]] studies::TrackingSample sample(std::uint64_t number, bool rendered) const;
    void noteMissingCharacters();
    void connectCallbacks();
};

void DesktopStation::State::onKey(int key) {
    // While a text is typed, digits and the space are part of it.
    if (!typing(presented)) {
        if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) pending.digit = key - GLFW_KEY_0;
        if (key >= GLFW_KEY_KP_1 && key <= GLFW_KEY_KP_9) pending.digit = key - GLFW_KEY_KP_0;
        if (key == GLFW_KEY_SPACE) pending.confirm = true;
    }
    if (key == GLFW_KEY_PAGE_UP) pending.farther_m += farther_step_m;
    if (key == GLFW_KEY_PAGE_DOWN) pending.farther_m -= farther_step_m;
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) pending.confirm = true;
    if (key == GLFW_KEY_ESCAPE) {
        pending.pause = true;
        pending.pause_reason = studies::PauseReason::escape;
    }
    if (key == GLFW_KEY_F11) toggleFullscreen();
    if (key == GLFW_KEY_F10 && operators) operators->focus();
}

// Of both windows.
OperatorRequest DesktopStation::State::pollEvents() {
    if (!operators) {
        glfwPollEvents();
        return {};
    }
    OperatorRequest asked = operators->poll();
    if (pending.pause && !in_front && operators->focused())
        pending.pause_reason = studies::PauseReason::experimenter;
    return asked;
}

void DesktopStation::State::onFocus(bool focused) {
    held = false;
    onTurning(false);
    in_front = focused;
    if (focused) {
        focused_at_s = now_s();
        return;
    }
    pending.pause = true;
    pending.pause_reason = studies::PauseReason::focus_lost;
}

void DesktopStation::State::onCursor(double x, double y) {
    const double right_px = x - std::exchange(reported_x, x);
    const double down_px = y - std::exchange(reported_y, y);
    // What is selected is what the mouse was on when the button went down, also where it has gone on since,
    // in a slow frame far: that counts in the next one.
    if (turning && pending.select) {
        later_right_px += right_px;
        later_down_px += down_px;
    } else if (turning) {
        turn(right_px, down_px);
    } else if (pending.select) {
        later_cursor = {x, y};
    } else {
        cursor_x = x;
        cursor_y = y;
    }
}

// The window has moved under the cursor.
void DesktopStation::State::onWindowMoved() {
    if (turning) return;
    glfwGetCursorPos(window->handle(), &cursor_x, &cursor_y);
    reported_x = cursor_x;
    reported_y = cursor_y;
}

void DesktopStation::State::onSelect(bool down) {
    // The click that brings the window back is no answer.
    const bool meant = now_s() - focused_at_s > settles_after_focus_s;
    held = down && meant;
    if (held) pending.select = true;
}

// While it is down the mouse turns the view, as far as it likes; the cursor is then where it was.
void DesktopStation::State::onTurning(bool down) {
    if (down == turning || (down && !in_front)) return;
    turning = down;
    glfwSetInputMode(window->handle(), GLFW_CURSOR, down ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    glfwGetCursorPos(window->handle(), &reported_x, &reported_y);
}

void DesktopStation::State::turn(double right_px, double down_px) {
    look.yaw_rad -= right_px * look_rad_per_pixel;
    look.pitch_rad = std::clamp(look.pitch_rad - down_px * look_rad_per_pixel, -max_pitch_rad, max_pitch_rad);
}

void DesktopStation::State::moveOn() {
    turn(std::exchange(later_right_px, 0.0), std::exchange(later_down_px, 0.0));
    if (later_cursor) std::tie(cursor_x, cursor_y) = *std::exchange(later_cursor, std::nullopt);
}

void DesktopStation::State::toggleFullscreen() {
    GLFWwindow* w = window->handle();
    if (glfwGetWindowMonitor(w) != nullptr) {
        glfwSetWindowMonitor(w, nullptr, windowed_x, windowed_y, windowed.width, windowed.height,
                             GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return;
    glfwGetWindowPos(w, &windowed_x, &windowed_y);
    glfwGetWindowSize(w, &windowed.width, &windowed.height);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(w, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void DesktopStation::State::updateLean(double elapsed_s) {
    GLFWwindow* w = window->handle();
    const bool letters = !typing(presented);
    const auto down = [&](int letter, int arrow) {
        const bool pressed =
            (letters && glfwGetKey(w, letter) == GLFW_PRESS) || glfwGetKey(w, arrow) == GLFW_PRESS;
        return pressed ? 1.0 : 0.0;
    };
    const Vec3 wanted =
        max_lean_m * Vec3(down(GLFW_KEY_D, GLFW_KEY_RIGHT) - down(GLFW_KEY_A, GLFW_KEY_LEFT), 0.0,
                          down(GLFW_KEY_S, GLFW_KEY_DOWN) - down(GLFW_KEY_W, GLFW_KEY_UP));
    lean_m += (wanted - lean_m) * std::min(1.0, lean_speed_per_s * elapsed_s);
}

Pose DesktopStation::State::head() const {
    const Quat yaw = yawRotation(look.yaw_rad);
    const Quat pitch = glm::angleAxis(look.pitch_rad, Vec3(1, 0, 0));
    return presented.stage_from_viewer *
           Pose{Vec3(0.0, options.eye_height_m, 0.0) + yaw * lean_m, yaw * pitch};
}

double DesktopStation::State::aspect() const {
    const WindowSize size = window->framebufferSize();
    return size.width > 0 && size.height > 0 ? static_cast<double>(size.width) / size.height : 1.0;
}

// From the eye through the cursor: what the person clicks on is what the ray meets.
Ray DesktopStation::State::cursorRay(const Pose& stage_from_head) const {
    WindowSize size;
    glfwGetWindowSize(window->handle(), &size.width, &size.height);
    // Of a pixel its middle; a cursor that has left the window stays at its edge.
    const auto along = [](double pixel, int pixels) {
        return pixels > 0 ? std::clamp(2.0 * (pixel + 0.5) / pixels - 1.0, -1.0, 1.0) : 0.0;
    };
    return rayThrough(stage_from_head, verticalView_rad(presented, aspect()), aspect(),
                      {along(cursor_x, size.width), -along(cursor_y, size.height)});
}

// Display periods that passed without a new picture since the last one.
int DesktopStation::State::droppedFrames() const {
    if (!last_shown_s) return 0;
    const double gap_s = std::clamp(last_swap_s - *last_shown_s, 0.0, longest_gap_s);
    return std::max(0, static_cast<int>(std::lround(gap_s / period_s)) - 1);
}

// The mouse in the place of a tracked head and a right hand, which points from the eye.
studies::TrackingSample DesktopStation::State::sample(std::uint64_t number, bool rendered) const {
    constexpr auto right = static_cast<std::size_t>(studies::Hand::right);
    studies::TrackingSample out;
    out.frame = number;
    out.display_time_s = last_time_s;
    out.begun_s = last_begin_s;
    out.submitted_s = last_swap_s;
    out.dropped_frames = rendered ? droppedFrames() : 0;
    out.rendered = rendered;
    out.head = tracked(told_head);
    out.aim[right] = tracked({told_ray.origin, glm::quatLookAt(told_ray.direction, up)});
    return out;
}

void DesktopStation::State::noteMissingCharacters() {
    const std::string& missing = renderer->missingCharacters();
    if (missing.size() <= missing_told) return;
    missing_told = missing.size();
    pending.notes.push_back({studies::NoteKind::missing_characters,
                             "no font has these; a question mark is shown for each: " + missing, now_s()});
}

void DesktopStation::State::connectCallbacks() {
    GLFWwindow* w = window->handle();
    glfwSetWindowUserPointer(w, this);
    glfwSetKeyCallback(w, [](GLFWwindow* from, int key, int, int action, int) {
        auto* state = static_cast<State*>(glfwGetWindowUserPointer(from));
        const bool pages = key == GLFW_KEY_PAGE_UP || key == GLFW_KEY_PAGE_DOWN;
        if (action == GLFW_PRESS || (pages && action == GLFW_REPEAT)) state->onKey(key);
        if (action != GLFW_RELEASE && key == GLFW_KEY_BACKSPACE) state->typed.erase();
    });
    glfwSetCharCallback(w, [](GLFWwindow* from, unsigned int character) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->typed.type(character);
    });
    glfwSetCursorPosCallback(w, [](GLFWwindow* from, double x, double y) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->onCursor(x, y);
    });
    glfwSetScrollCallback(w, [](GLFWwindow* from, double, double notches) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->pending.farther_m += notches * farther_step_m;
    });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* from, int button, int action, int) {
        auto* state = static_cast<State*>(glfwGetWindowUserPointer(from));
        if (button == GLFW_MOUSE_BUTTON_LEFT) state->onSelect(action == GLFW_PRESS);
        if (button == GLFW_MOUSE_BUTTON_RIGHT) state->onTurning(action == GLFW_PRESS);
    });
    glfwSetWindowFocusCallback(w, [](GLFWwindow* from, int focused) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->onFocus(focused == GLFW_TRUE);
    });
    glfwSetWindowPosCallback(w, [](GLFWwindow* from, int, int) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->onWindowMoved();
    });
    glfwSetWindowSizeCallback(w, [](GLFWwindow* from, int, int) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->onWindowMoved();
    });
    onWindowMoved();
}

DesktopStation::DesktopStation(std::unique_ptr<State> state) : state_(std::move(state)) {}
DesktopStation::~DesktopStation() = default;

Result<std::unique_ptr<DesktopStation>> DesktopStation::open(const assets::Avatar& avatar,
                                                             const DesktopOptions& options) {
    auto state = std::make_unique<State>();
    state->options = options;
    auto window = GlWindow::open(options.title, options.size, options.fullscreen);
    if (!window) return tl::unexpected(window.error());
    state->window = std::move(*window);
    auto made = renderer::Renderer::create(avatar, {});
    if (!made) return tl::unexpected(made.error());
    state->renderer = std::make_unique<renderer::Renderer>(std::move(*made));
    state->period_s = 1.0 / state->window->refreshRate_hz();
    state->windowed = options.size;
    state->utc_offset_s = utcNow_s() - state->now_s();
    if (options.operator_window) {
        auto operators =
            DesktopOperator::open(*state->window, options.title + " - experimenter", options.operator_feed);
        if (!operators) return tl::unexpected(operators.error());
        state->operators = std::move(*operators);
    }
    state->connectCallbacks();
    return std::unique_ptr<DesktopStation>(new DesktopStation(std::move(state)));
}

studies::StationInfo DesktopStation::info() const {
    const WindowSize size = state_->window->framebufferSize();
    return {studies::StationKind::desktop,
            fmt::format("{}x{} pixels, {:.0f} Hz, {}", size.width, size.height, 1.0 / state_->period_s,
                        state_->renderer->driver()),
            false, state_->options.controls, state_->options.controls};
}

studies::InputFrame DesktopStation::beginFrame() {
    State& s = *state_;
    // A driver that does not wait for the display (software, remote) would draw as fast as it can: pace it
    // here.
    // From begin to begin, so that drawing and waiting for the display share one period.
    const double ready_s = s.last_begin_s + 0.9 * s.period_s;
    if (const double wait_s = ready_s - s.now_s(); wait_s > 0.0)
        std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    s.moveOn();
    const OperatorRequest asked = s.pollEvents();
    studies::InputFrame input = std::exchange(s.pending, {});
    input.read_before_s = std::exchange(s.last_begin_s, s.now_s());
    input.input_time_s = s.last_begin_s;
    // Swapping returns when the display has taken the frame: at the next refresh at the earliest.
    input.time_s = std::max({s.last_time_s, s.last_begin_s, s.last_swap_s + s.period_s});
    input.utc_s = input.time_s + s.utc_offset_s;
    s.updateLean(input.time_s - s.last_time_s);
    s.last_time_s = input.time_s;
    s.told_head = s.head();
    s.told_ray = s.cursorRay(s.told_head);
    input.stage_from_head = s.told_head;
    input.pointer = s.told_ray;
    input.select_held = s.held || input.select;  // a click shorter than a frame was held too
    TypedText::Part text = s.typed.take();
    if (typing(s.presented)) {
        input.typed = std::move(text.typed);
        input.erased = text.erased;
    }
    input.quit = glfwWindowShouldClose(s.window->handle()) == GLFW_TRUE;
    asked.putInto(input);
    return input;
}

studies::FrameReport DesktopStation::present(const studies::PresentedFrame& frame) {
    State& s = *state_;
    if (looksAgain(frame, s.presented)) s.look = lookAtTask(frame, s.options.eye_height_m);
    if (frame.status != s.presented.status)
        glfwSetWindowTitle(s.window->handle(),
                           (s.options.title + " - " + studies::sessionStatusText(frame.status)).c_str());
    s.presented = frame;
    const WindowSize size = s.window->framebufferSize();
    const bool visible = size.width > 0 && size.height > 0 &&
                         glfwGetWindowAttrib(s.window->handle(), GLFW_ICONIFIED) == GLFW_FALSE;
    if (visible) {
        renderer::Scene scene = sceneFromFrame(frame, s.head());
        scene.camera.vertical_fov_rad = verticalView_rad(frame, s.aspect());
        addNotice(scene, frame.notice);
        s.renderer->draw(scene, size.width, size.height);
        if (s.operators) s.operators->drawn(size);
        glfwSwapBuffers(s.window->handle());
        s.noteMissingCharacters();
    }
    s.last_swap_s = s.now_s();
    studies::FrameReport report{frame.number, visible, s.last_swap_s, s.sample(frame.number, visible)};
    if (visible) s.last_shown_s = s.last_swap_s;
    if (s.operators) s.operators->presented(frame, report, s.in_front);
    return report;
}

}  // namespace deixis::app
