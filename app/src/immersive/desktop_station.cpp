#include "desktop_station.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "frame_scene.hpp"
#include "operator/desktop_operator.hpp"
#include "typed_text.hpp"

namespace deixis::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double look_rad_per_pixel = radiansFromDegrees(0.07);
constexpr double max_pitch_rad = radiansFromDegrees(80.0);
constexpr double resting_pitch_rad =
    radiansFromDegrees(-6.0);  // a standing person's gaze rests a little down
constexpr double max_lean_m = 0.25;
constexpr double lean_speed_per_s = 4.0;
const Vec3 eye_to_hand{0.20, -0.28, -0.20};  // in the head's frame turned upright
constexpr double farthest_aim_m = 8.0;
constexpr double settles_after_focus_s = 0.3;
constexpr double longest_gap_s = 3600.0;  // between frames, for counting those dropped

// Whether a board stands there to be read first, not one beside a task.
bool pageOpen(const studies::PresentedFrame& frame) {
    return frame.panel && isFullPage(frame.state);
}

// Whether clips are to be played by buttons: the board and who is shown belong together.
bool playsByButtons(const studies::PresentedFrame& frame) {
    return frame.state == studies::PresentedState::listening ||
           frame.state == studies::PresentedState::comparing;
}

bool typing(const studies::PresentedFrame& frame) {
    return frame.panel && std::any_of(frame.panel->fields.begin(), frame.panel->fields.end(),
                                      [](const studies::PanelField& field) { return field.active; });
}

Vec3 middleOf(const studies::Panel& panel) {
    return transformPoint(panel.stage_from_panel, {0.5 * panel.width_m, 0.5 * panel.height_m, 0.0});
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
    Ray told_hand{};
    double focused_at_s = 0.0;
    bool in_front = true;  // has the mouse and the keyboard

    double yaw_rad = 0.0;  // to the left of the viewer's heading
    double pitch_rad = resting_pitch_rad;
    Vec3 lean_m{0.0};
    double cursor_x = 0.0, cursor_y = 0.0;
    double later_right_px = 0.0, later_down_px = 0.0;  // moved after a press, within one frame

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
    void turn(double right_px, double down_px);
    void toggleFullscreen();
    void updateLean(double elapsed_s);
    void lookAtTask(const studies::PresentedFrame& frame);
    [[nodiscard]] Pose head() const;
    [[nodiscard]] Ray handRay(const Pose& stage_from_head) const;
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
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) pending.confirm = true;
    if (key == GLFW_KEY_ESCAPE) {
        pending.pause = true;
        pending.pause_reason = "escape";
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
    if (pending.pause && !in_front && operators->focused()) pending.pause_reason = "operator";
    return asked;
}

void DesktopStation::State::onFocus(bool focused) {
    held = false;
    in_front = focused;
    if (focused) {
        focused_at_s = now_s();
        return;
    }
    pending.pause = true;
    pending.pause_reason = "focus lost";
}

void DesktopStation::State::onCursor(double x, double y) {
    const double right_px = x - std::exchange(cursor_x, x);
    const double down_px = y - std::exchange(cursor_y, y);
    // What the mouse did elsewhere, and what brings it back, turns nobody's head.
    if (!in_front || now_s() - focused_at_s < settles_after_focus_s) return;
    // What is selected is what was in the middle of the view when the button went down, also where the mouse
    // has gone on since, in a slow frame far: that turns the view in the next one.
    if (pending.select) {
        later_right_px += right_px;
        later_down_px += down_px;
    } else {
        turn(right_px, down_px);
    }
}

void DesktopStation::State::turn(double right_px, double down_px) {
    yaw_rad -= right_px * look_rad_per_pixel;
    pitch_rad = std::clamp(pitch_rad - down_px * look_rad_per_pixel, -max_pitch_rad, max_pitch_rad);
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

// Turns the view to where a person who has just been placed here would turn: to a page's middle, to between
// those who are shown and the board of their buttons, or to the middle between the avatar and the balls, so
// that none is missed on a flat screen.
void DesktopStation::State::lookAtTask(const studies::PresentedFrame& frame) {
    yaw_rad = 0.0;
    pitch_rad = resting_pitch_rad;
    const auto seen = [&](const Vec3& point) {
        return transformPoint(inverse(frame.stage_from_viewer), point);
    };
    const auto yawTo = [&](const Vec3& point) { return std::atan2(-seen(point).x, -seen(point).z); };
    const auto pitchTo = [&](const Vec3& point) {
        const Vec3 p = seen(point);
        return std::atan2(p.y - options.eye_height_m, std::hypot(p.x, p.z));
    };
    if (frame.panel && playsByButtons(frame)) {
        const Vec3 board = middleOf(*frame.panel);
        yaw_rad = yawTo(board);
        pitch_rad = 0.5 * (resting_pitch_rad + pitchTo(board));
        return;
    }
    if (frame.panel) {
        yaw_rad = yawTo(middleOf(*frame.panel));
        if (pageOpen(frame)) pitch_rad = pitchTo(middleOf(*frame.panel));
        return;
    }
    if (frame.balls.empty()) return;
    Vec3 middle{0.0};
    for (const auto& ball : frame.balls) middle += ball.centre / static_cast<double>(frame.balls.size());
    yaw_rad = 0.5 * (yawTo(Vec3(0.0)) + yawTo(middle));
}

Pose DesktopStation::State::head() const {
    const Quat yaw = yawRotation(yaw_rad);
    const Quat pitch = glm::angleAxis(pitch_rad, Vec3(1, 0, 0));
    return presented.stage_from_viewer *
           Pose{Vec3(0.0, options.eye_height_m, 0.0) + yaw * lean_m, yaw * pitch};
}

// From the hand to the first thing in the middle of the view: what the person looks at is what the ray meets.
Ray DesktopStation::State::handRay(const Pose& stage_from_head) const {
    const Ray gaze{stage_from_head.position, stage_from_head.orientation * Vec3(0, 0, -1)};
    // Where the gaze passes the balls by, the ray ends at the depth of the nearest one to it: beside it, as
    // the gaze does, and not at another one behind.
    double distance = farthest_aim_m;
    double least_angle_rad = pi / 4.0;
    for (const auto& ball : presented.balls) {
        const double angle_rad = angleBetween(gaze.direction, ball.centre - gaze.origin);
        if (angle_rad >= least_angle_rad) continue;
        least_angle_rad = angle_rad;
        const double hit = distanceToSphere(gaze, ball.centre, ball.radius_m);
        distance = hit > 0.0 ? hit : glm::dot(gaze.direction, ball.centre - gaze.origin);
    }
    if (presented.panel) {
        const Pose& board = presented.panel->stage_from_panel;
        const Vec3 normal = board.orientation * Vec3(0, 0, 1);
        const double towards = -glm::dot(gaze.direction, normal);
        if (towards > 1e-6) {
            const double hit = glm::dot(gaze.origin - board.position, normal) / towards;
            const Vec3 on_board = transformPoint(inverse(board), gaze.origin + hit * gaze.direction);
            const bool inside = on_board.x >= 0.0 && on_board.x <= presented.panel->width_m &&
                                on_board.y >= 0.0 && on_board.y <= presented.panel->height_m;
            if (hit > 0.0 && inside) distance = std::min(distance, hit);
        }
    }
    const Quat upright = presented.stage_from_viewer.orientation * yawRotation(yaw_rad);
    const Vec3 hand = stage_from_head.position + upright * eye_to_hand;
    return {hand, glm::normalize(gaze.origin + distance * gaze.direction - hand)};
}

// Display periods that passed without a new picture since the last one.
int DesktopStation::State::droppedFrames() const {
    if (!last_shown_s) return 0;
    const double gap_s = std::clamp(last_swap_s - *last_shown_s, 0.0, longest_gap_s);
    return std::max(0, static_cast<int>(std::lround(gap_s / period_s)) - 1);
}

// The mouse in the place of a tracked head and a right hand.
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
    out.aim[right] = tracked({told_hand.origin, glm::quatLookAt(told_hand.direction, up)});
    return out;
}

void DesktopStation::State::noteMissingCharacters() {
    const std::string& missing = renderer->missingCharacters();
    if (missing.size() <= missing_told) return;
    missing_told = missing.size();
    pending.notes.push_back(
        {"missing_characters", "no font has these; a question mark is shown for each: " + missing, now_s()});
}

void DesktopStation::State::connectCallbacks() {
    GLFWwindow* w = window->handle();
    glfwSetWindowUserPointer(w, this);
    glfwSetKeyCallback(w, [](GLFWwindow* from, int key, int, int action, int) {
        auto* state = static_cast<State*>(glfwGetWindowUserPointer(from));
        if (action == GLFW_PRESS) state->onKey(key);
        if (action != GLFW_RELEASE && key == GLFW_KEY_BACKSPACE) state->typed.erase();
    });
    glfwSetCharCallback(w, [](GLFWwindow* from, unsigned int character) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->typed.type(character);
    });
    glfwSetCursorPosCallback(w, [](GLFWwindow* from, double x, double y) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->onCursor(x, y);
    });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* from, int button, int action, int) {
        auto* state = static_cast<State*>(glfwGetWindowUserPointer(from));
        if (button != GLFW_MOUSE_BUTTON_LEFT) return;
        // The click that brings the window back is no answer.
        const bool meant = state->now_s() - state->focused_at_s > settles_after_focus_s;
        state->held = action == GLFW_PRESS && meant;
        if (state->held) state->pending.select = true;
    });
    glfwSetWindowFocusCallback(w, [](GLFWwindow* from, int focused) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->onFocus(focused == GLFW_TRUE);
    });
    glfwSetInputMode(w, GLFW_CURSOR, GLFW_CURSOR_DISABLED);
    if (glfwRawMouseMotionSupported() == GLFW_TRUE) glfwSetInputMode(w, GLFW_RAW_MOUSE_MOTION, GLFW_TRUE);
    glfwGetCursorPos(w, &cursor_x, &cursor_y);
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
    state->utc_offset_s =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count() -
        state->now_s();
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
    return {"desktop",
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
    s.turn(std::exchange(s.later_right_px, 0.0), std::exchange(s.later_down_px, 0.0));
    const OperatorRequest asked = s.pollEvents();
    studies::InputFrame input = std::exchange(s.pending, {});
    s.last_begin_s = s.now_s();
    input.input_time_s = s.last_begin_s;
    // Swapping returns when the display has taken the frame: at the next refresh at the earliest.
    input.time_s = std::max({s.last_time_s, s.last_begin_s, s.last_swap_s + s.period_s});
    input.utc_s = input.time_s + s.utc_offset_s;
    s.updateLean(input.time_s - s.last_time_s);
    s.last_time_s = input.time_s;
    s.told_head = s.head();
    s.told_hand = s.handRay(s.told_head);
    input.stage_from_head = s.told_head;
    input.pointer = s.told_hand;
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
    const bool new_trial = frame.state == studies::PresentedState::waiting &&
                           s.presented.state != studies::PresentedState::waiting;
    const bool new_comparison = playsByButtons(frame) && pageOpen(s.presented);
    const bool new_page = frame.panel && pageOpen(frame) && !pageOpen(s.presented);
    if (frame.viewer_place != s.presented.viewer_place || new_page || new_comparison ||
        (new_trial && !frame.balls.empty()))
        s.lookAtTask(frame);
    if (frame.status != s.presented.status)
        glfwSetWindowTitle(s.window->handle(), (s.options.title + " - " + frame.status).c_str());
    s.presented = frame;
    const WindowSize size = s.window->framebufferSize();
    const bool visible = size.width > 0 && size.height > 0 &&
                         glfwGetWindowAttrib(s.window->handle(), GLFW_ICONIFIED) == GLFW_FALSE;
    if (visible) {
        renderer::Scene scene = sceneFromFrame(frame, s.head());
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
