#include "participant_place.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace deixis::app {

void ParticipantPlace::update(const std::optional<Pose>& tracking_from_head, double time_s) {
    if (!tracking_from_head || (anchor_ && recentre_by_.empty())) return;
    if (anchor_) notes_.push_back({"recentre", recentre_by_, time_s});
    recentre_by_.clear();
    anchor_ = studies::anchorFromHead(*tracking_from_head);
    lay(time_s);
}

void ParticipantPlace::stand(const Pose& stage_from_viewer, double time_s) {
    const bool same = stage_from_viewer.position == stage_from_viewer_.position &&
                      stage_from_viewer.orientation == stage_from_viewer_.orientation;
    if (same) return;
    stage_from_viewer_ = stage_from_viewer;
    if (anchor_) lay(time_s);
}

void ParticipantPlace::recentre(const std::string& by) {
    recentre_by_ = by;
}

void ParticipantPlace::lay(double time_s) {
    placement_ = studies::placementFor(*anchor_, stage_from_viewer_, eye_level_, avatar_eye_height_m_);
    const Pose& p = placement_.turn_and_shift;
    const double yaw_rad = 2.0 * std::atan2(p.orientation.y, p.orientation.w);
    notes_.push_back({"placement",
                      fmt::format(R"({{"scale":{},"yaw_deg":{},"shift_m":[{},{},{}],"eye_height_m":{}}})",
                                  placement_.scale, degreesFromRadians(yaw_rad), p.position.x, p.position.y,
                                  p.position.z, anchor_->eye_height_m),
                      time_s});
}

double ParticipantPlace::offPlace_m(const Pose& tracking_from_head) const {
    return anchor_ ? studies::distanceFromPlace(*anchor_, tracking_from_head) : 0.0;
}

std::vector<studies::StationNote> ParticipantPlace::takeNotes() {
    return std::exchange(notes_, {});
}

}  // namespace deixis::app
