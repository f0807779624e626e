// Replaying a recorded trial: pure geometry and time, no database, no drawing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/clip.hpp"
#include "studies/design/plan.hpp"
#include "studies/session/session.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// One play of a stimulus, on the station's clock.
struct RecordedPlay {
    int stimulus = 0;  ///< which of the trial's
    double onset_s = 0.0;
    std::optional<double> end_s{};  ///< its last frame was shown; none: it broke off
};

/// What was kept of one answered trial of one session. Times are on the station's clock.
struct RecordedTrial {
    Trial trial{};
    Layout layout{};
    double ball_diameter_m = 0.1;
    std::string station{};   ///< kind
    bool synthetic = false;  ///< answered by a simulated participant
    std::vector<RecordedPlay> plays{};
    double open_s = 0.0;      ///< the answer was open from here on
    double answered_s = 0.0;  ///< or skipped, or timed out
    std::vector<Answer> answers{};
    std::vector<KeptValue> values{};         ///< as Response::values
    std::optional<Ray> pointer{};            ///< at the answer
    Pose stage_from_head{};                  ///< at the answer
    std::vector<TrackingSample> tracking{};  ///< in order of time; empty if nothing was tracked

    /// As Response::chosenPlace().
    [[nodiscard]] int chosenPlace() const { return keptPlace(values, "chosen_place"); }
};

/// The place of the ball that a ray meets first, in the order shown; -1: none.
[[nodiscard]] int ballMetBy(const RecordedTrial& recorded, const Ray& ray);

/// Shows a recorded trial at any time.
class TrialReplay {
  public:
    /// All references must outlive it. `idle_pose` is how the avatar stands when no clip plays.
    TrialReplay(const RecordedTrial& recorded, const ClipSource& clips, const motion::Skeleton& avatar,
                const motion::LocalPose& idle_pose);

    /// From the first that is known of the trial, or a moment before its first clip, to a moment after its
    /// answer.
    [[nodiscard]] double begin_s() const { return begin_s_; }
    [[nodiscard]] double end_s() const { return end_s_; }

    /// What the participant saw: avatar, balls as they looked, the ray up to what it met. No boards.
    [[nodiscard]] PresentedFrame at(double time_s) const;
    /// Between two samples by linear and spherical interpolation; none before the first, after the last and
    /// where it was not tracked.
    [[nodiscard]] std::optional<Pose> head(double time_s) const;
    [[nodiscard]] std::optional<Ray> pointer(double time_s) const;
    /// Where the head, and the hand that points, were during the `length_s` before, oldest first.
    [[nodiscard]] std::vector<Vec3> headTrail(double time_s, double length_s) const;
    [[nodiscard]] std::vector<Vec3> handTrail(double time_s, double length_s) const;

  private:
    [[nodiscard]] std::optional<Pose> tracked(double time_s, const TrackedPose& (*of)(const TrackingSample&,
                                                                                      std::size_t)) const;
    [[nodiscard]] std::vector<Vec3> trail(double time_s, double length_s,
                                          const TrackedPose& (*of)(const TrackingSample&, std::size_t)) const;
    [[nodiscard]] std::vector<Pose> joints(double time_s, int avatar_place) const;

    const RecordedTrial& recorded_;
    const ClipSource& clips_;
    const motion::Skeleton& avatar_;
    const motion::LocalPose& idle_;
    std::size_t hand_ = 1;  ///< of TrackingSample::aim: the one that pointed
    double begin_s_ = 0.0;
    double end_s_ = 0.0;
};

}  // namespace deixis::studies
