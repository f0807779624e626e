#include "app/operator/desktop_operator.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "operator_place.hpp"

namespace deixis::app {

namespace {

// In units of the content scale.
constexpr WindowSize wanted_size{1280, 960};
constexpr WindowSize min_size{480, 420};

struct Frame {
    int left = 0, top = 0, right = 0, bottom = 0;
};

Frame frameOf(GLFWwindow* window) {
    Frame frame;
    glfwGetWindowFrameSize(window, &frame.left, &frame.top, &frame.right, &frame.bottom);
    return frame;
}

std::vector<ScreenRect> monitorAreas() {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::vector<ScreenRect> areas;
    for (int i = 0; i < count; ++i) {
        ScreenRect area;
        glfwGetMonitorWorkarea(monitors[i], &area.x, &area.y, &area.width, &area.height);
        areas.push_back(area);
    }
    return areas;
}

WindowSize scaled(WindowSize size, float scale, const Frame& frame) {
    const auto length = [scale](int units) {
        return static_cast<int>(std::lround(static_cast<float>(units) * scale));
    };
    return {length(size.width) + frame.left + frame.right, length(size.height) + frame.top + frame.bottom};
}

// Moves one or both windows so that they stand apart. False: there is no room.
bool place(GLFWwindow* participants, GLFWwindow* operators) {
    const bool fills = glfwGetWindowMonitor(participants) != nullptr;
    const Frame frame = fills ? Frame{} : frameOf(participants);
    ScreenRect now;
    glfwGetWindowPos(participants, &now.x, &now.y);
    glfwGetWindowSize(participants, &now.width, &now.height);
    const ScreenRect whole{now.x - frame.left, now.y - frame.top, now.width + frame.left + frame.right,
                           now.height + frame.top + frame.bottom};
    float across = 1.0F;
    float down = 1.0F;
    glfwGetWindowContentScale(participants, &across, &down);
    const auto places = placesOfWindows(whole, monitorAreas(), scaled(wanted_size, across, frame),
                                        scaled(min_size, across, frame), !fills);
    if (!places) return false;
    if (places->participant.x != whole.x)
        glfwSetWindowPos(participants, places->participant.x + frame.left, places->participant.y + frame.top);
    const ScreenRect& to = places->operators;
    glfwSetWindowSize(operators, to.width - frame.left - frame.right, to.height - frame.top - frame.bottom);
    glfwSetWindowPos(operators, to.x + frame.left, to.y + frame.top);
    return true;
}

}  // namespace

DesktopOperator::DesktopOperator(GlWindow& participants, std::unique_ptr<GlWindow> window,
                                 std::shared_ptr<const OperatorFeed> feed)
    : participants_(participants), feed_(std::move(feed)), window_(std::move(window)) {
    const CurrentContext current(window_->handle());
    operator_window_ = std::make_unique<OperatorWindow>(*window_);
}

DesktopOperator::~DesktopOperator() = default;

Result<std::unique_ptr<DesktopOperator>> DesktopOperator::open(GlWindow& participants,
                                                               const std::string& title,
                                                               std::shared_ptr<const OperatorFeed> feed) {
    auto window = GlWindow::openSecond(participants, title, wanted_size);
    if (!window) return tl::unexpected(window.error());
    if (!place(participants.handle(), (*window)->handle()))
        return fail("--operator",
                    "there is no room on the screen for the experimenter's window, which must not cover the "
                    "participant's",
                    "Connect a second monitor that extends the desktop, or make the participant's window "
                    "smaller, such as with --size 960x540 and without --fullscreen");
    // A window that fills a screen would else go away when the experimenter's is used.
    glfwSetWindowAttrib(participants.handle(), GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwShowWindow((*window)->handle());
    glfwFocusWindow(participants.handle());
    return std::unique_ptr<DesktopOperator>(
        new DesktopOperator(participants, std::move(*window), std::move(feed)));
}

OperatorRequest DesktopOperator::poll() {
    OperatorRequest asked = operator_window_->poll();
    if (asked.resume) glfwFocusWindow(participants_.handle());
    return asked;
}

void DesktopOperator::focus() {
    glfwFocusWindow(window_->handle());
}

bool DesktopOperator::focused() const {
    return glfwGetWindowAttrib(window_->handle(), GLFW_FOCUSED) == GLFW_TRUE;
}

void DesktopOperator::drawn(WindowSize size) {
    shown_ = size;
    if (operator_window_->due()) mirror_.take(size, operator_window_->mirrorSize());
}

void DesktopOperator::measure(const studies::FrameReport& report) {
    if (report.tracking) dropped_ += report.tracking->dropped_frames;
    if (last_shown_s_ >= 0.0) {
        const double rate = 1.0 / std::max(1e-4, report.display_time_s - last_shown_s_);
        frames_per_s_ += (rate - frames_per_s_) * (frames_per_s_ > 0.0 ? 0.05 : 1.0);
    }
    last_shown_s_ = report.display_time_s;
}

OperatorView DesktopOperator::view(const studies::PresentedFrame& frame, bool in_front) const {
    OperatorView view;
    if (feed_) view.feed = *feed_;
    view.status = frame.status;
    view.doing = stateInWords(frame);
    view.paused = frame.state == studies::PresentedState::paused;
    view.device_kind = "Display";
    view.device = fmt::format("{}x{} pixels", shown_.width, shown_.height);
    view.device_state = in_front ? DeviceWords{"In use", true}
                                 : DeviceWords{"The participant does not have mouse and keyboard", false};
    view.frames_per_s = frames_per_s_;
    view.dropped_frames = dropped_;
    view.pointer = "Mouse";
    if (!in_front && !view.paused)
        view.warnings.emplace_back("The participant's window is not in front. Click into it.");
    if (!frame.notice.empty())
        view.warnings.push_back(fmt::format("The participant reads: \"{}\"", frame.notice));
    return view;
}

void DesktopOperator::presented(const studies::PresentedFrame& frame, const studies::FrameReport& report,
                                bool in_front) {
    measure(report);
    if (operator_window_->due()) operator_window_->show(view(frame, in_front), mirror_);
}

}  // namespace deixis::app
