#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "simulated_boards.hpp"
#include "studies/simulation/simulated_participant.hpp"

namespace deixis::studies {

namespace {

std::string openBalls(const PresentedFrame& frame, const InputFrame& input) {
    double nearest_m = 1e9;
    double farthest_m = 0.0;
    for (const BallView& ball : frame.balls) {
        const double away_m = glm::length(ball.centre - input.stage_from_head.position);
        nearest_m = std::min(nearest_m, away_m);
        farthest_m = std::max(farthest_m, away_m);
    }
    return fmt::format("choosing one of {} balls, {:.2f} to {:.2f} m from the eyes", frame.balls.size(),
                       nearest_m, farthest_m);
}

std::string openBoard(const Panel& panel) {
    const BoardReading board = readBoard(panel);
    if (board.playing()) return "the end of a movement that was played";
    const auto open =
        std::count_if(board.asks.begin(), board.asks.end(), [](const Ask& ask) { return ask.enabled; });
    if (open > 0) return fmt::format("giving {} answers on a board", open);
    return board.go_on != nullptr ? "leaving a board" : "a board whose buttons cannot be pressed yet";
}

/// What the participant could have done, or waited for.
std::string whatIsOpen(const PresentedFrame& frame, const InputFrame& input) {
    const bool choosing = std::any_of(frame.balls.begin(), frame.balls.end(), [](const BallView& ball) {
        return ball.look == BallLook::selectable || ball.look == BallLook::hovered;
    });
    if (choosing) return openBalls(frame, input);
    return frame.panel ? openBoard(*frame.panel) : "the end of a movement";
}

}  // namespace

SimulatedStation::SimulatedStation(const SimulatedParameters& parameters, const motion::Skeleton& avatar,
                                   std::uint64_t seed, bool keyboard)
    : participant_(parameters, avatar, seed, keyboard),
      frame_rate_hz_(parameters.frame_rate_hz),
      details_("virtual time, nothing drawn"),
      observer_(
          fmt::format("reads {}, noise {:g} degrees, lapses {:g}", readingName(parameters.observer.reading),
                      degreesFromRadians(parameters.observer.noise_rad), parameters.observer.lapse_rate)) {}

StationInfo SimulatedStation::info() const {
    return {StationKind::simulated, details_ + "; " + observer_, true};
}

InputFrame SimulatedStation::beginFrame() {
    ++frames_;
    input_ = participant_.act(static_cast<double>(frames_) / frame_rate_hz_);
    if (failure_) {
        input_.quit = true;
        input_.quit_reason = "no progress";
    }
    return input_;
}

FrameReport SimulatedStation::present(const PresentedFrame& frame) {
    participant_.see(frame, input_.time_s);
    if (viewer_) viewer_(frame, input_);
    watchProgress(frame);
    return {frame.number, true, input_.time_s};
}

/// The status names the trial, and counts down the seconds of a page that must be read for long.
void SimulatedStation::watchProgress(const PresentedFrame& frame) {
    const std::string under_way =
        fmt::format("stage \"{}\", {}", frame.stage, sessionStatusText(frame.status));
    if (under_way != under_way_) {
        under_way_ = under_way;
        since_s_ = input_.time_s;
    }
    if (failure_ || input_.time_s - since_s_ < patience_s) return;
    failure_ = Error{"simulated participant",
                     fmt::format("{}: no answer within {:g} minutes of virtual time; it was waiting for: {}",
                                 under_way, patience_s / 60.0, whatIsOpen(frame, input_)),
                     fmt::format("A person may get stuck here, too: 'deixis run STUDY --station simulated "
                                 "--screenshot {}=FILE.png' shows what is seen",
                                 presentedStateName(frame))};
}

void SimulatedStation::attachViewer(std::string details, Viewer viewer) {
    details_ = std::move(details);
    viewer_ = std::move(viewer);
}

}  // namespace deixis::studies
