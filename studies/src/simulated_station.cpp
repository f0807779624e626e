#include <utility>

#include "studies/simulated_participant.hpp"

namespace deixis::studies {

SimulatedStation::SimulatedStation(const SimulatedParameters& parameters, const motion::Skeleton& avatar,
                                   std::uint64_t seed, bool keyboard)
    : participant_(parameters, avatar, seed, keyboard),
      frame_rate_hz_(parameters.frame_rate_hz),
      details_("virtual time, nothing drawn") {}

StationInfo SimulatedStation::info() const {
    return {"simulated", details_, true};
}

InputFrame SimulatedStation::beginFrame() {
    ++frames_;
    input_ = participant_.act(static_cast<double>(frames_) / frame_rate_hz_);
    return input_;
}

FrameReport SimulatedStation::present(const PresentedFrame& frame) {
    participant_.see(frame, input_.time_s);
    if (viewer_) viewer_(frame, input_);
    return {frame.number, true, input_.time_s};
}

void SimulatedStation::attachViewer(std::string details, Viewer viewer) {
    details_ = std::move(details);
    viewer_ = std::move(viewer);
}

}  // namespace deixis::studies
