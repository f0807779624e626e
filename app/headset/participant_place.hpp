// Where the participant stands: the anchor in the room, what sets it again, and where the stage lies around
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/design/placement.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

class ParticipantPlace {
  public:
    ParticipantPlace(studies::EyeLevel eye_level, double avatar_eye_height_m)
        : eye_level_(eye_level), avatar_eye_height_m_(avatar_eye_height_m) {}

    /// Every frame, with the head where it is known: takes the anchor once the head has been still for a
    /// second (after 10 s in any case) and as high as a sitting person's, since a headset is also put on and
    /// lies on tables; and a new one, at once, where one was asked for. Poses are in the tracking space.
    void update(const std::optional<Pose>& tracking_from_head, double time_s);
    /// The place of the layout, as the session says. A change turns and shifts the stage.
    void stand(const Pose& stage_from_viewer, double time_s);
    /// Takes the next known head for the anchor; `by` is "operator", "button" or "runtime".
    void recentre(const std::string& by);

    [[nodiscard]] bool known() const { return anchor_.has_value(); }
    [[nodiscard]] const studies::Placement& placement() const { return placement_; }
    /// From the place, along the floor, metres of the room; 0 before the anchor is known.
    [[nodiscard]] double offPlace_m(const Pose& tracking_from_head) const;
    /// What it has to tell (recentre, placement) since the last call.
    [[nodiscard]] std::vector<studies::StationNote> takeNotes();

  private:
    void lay(double time_s);
    [[nodiscard]] bool settled(const Pose& tracking_from_head, double time_s);

    studies::EyeLevel eye_level_;
    double avatar_eye_height_m_;
    std::optional<studies::Anchor> anchor_;
    std::optional<Pose> still_at_;  ///< where the head has been still
    double still_since_s_ = 0.0;
    double worn_since_s_ = 0.0;
    Pose stage_from_viewer_{};
    studies::Placement placement_{};
    std::string recentre_by_;  ///< empty: none is asked for
    std::vector<studies::StationNote> notes_;
};

}  // namespace deixis::app
