#include "participant_place.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace deixis::app {

namespace {

constexpr double still_m = 0.08;
constexpr double still_rad = radiansFromDegrees(20.0);
constexpr double still_s = 1.0;
constexpr double patience_s = 10.0;
constexpr double lowest_eyes_m = 0.9;  // lower than a sitting adult's, higher than a table
const Vec3 ahead{0.0, 0.0, -1.0};

}  // namespace

void ParticipantPlace::update(const std::optional<Pose>& tracking_from_head, double time_s) {
    if (!tracking_from_head) {
        still_at_.reset();
        return;
    }
    if (recentre_by_.empty() && (anchor_ || !settled(*tracking_from_head, time_s))) return;
    if (anchor_) notes_.push_back({studies::NoteKind::recentre, recentre_by_, time_s});
    recentre_by_.clear();
    anchor_ = studies::anchorFromHead(*tracking_from_head);
    lay(time_s);
}

bool ParticipantPlace::settled(const Pose& tracking_from_head, double time_s) {
    const bool first = !still_at_;
    if (first) worn_since_s_ = time_s;
    const bool moved =
        first || glm::distance(tracking_from_head.position, still_at_->position) > still_m ||
        angleBetween(tracking_from_head.orientation * ahead, still_at_->orientation * ahead) > still_rad;
    if (moved) {
        still_at_ = tracking_from_head;
        still_since_s_ = time_s;
    }
    if (tracking_from_head.position.y < lowest_eyes_m) return false;
    return time_s - still_since_s_ >= still_s || time_s - worn_since_s_ >= patience_s;
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
    notes_.push_back({studies::NoteKind::placement,
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
