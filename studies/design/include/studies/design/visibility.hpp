// Whether the balls of a trial are visible from where the participant stands: past the avatar, at rest and
// pointing, and past each other.
#pragma once

#include <string>
#include <vector>

#include "core/pose.hpp"
#include "motion/pointing/body_shape.hpp"
#include "studies/station/first_look.hpp"
#include "studies/study_file/standing.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// A ball counts as visible where at least so much of its disc is seen, at rest and pointing.
constexpr double min_visible_share = 0.9;

/// Where the eyes of participants may be in a layout: at its place for a station, at three heights, 0.15 m
/// apart, the middle one Study::eye_height_m.
struct Viewpoint {
    std::string layout;
    Standing standing = Standing::headset;
    std::vector<Vec3> eyes;  ///< metres, rounded to 0.1 mm
};

/// The eyes of a participant of Study::eye_height_m there; metres, rounded to 0.1 mm.
[[nodiscard]] Vec3 eyesAt(const Study& study, const Layout& layout, Standing standing);

/// Of all layouts in which the study plays its game; none if it plays none.
[[nodiscard]] std::vector<Viewpoint> viewpoints(const Study& study);

/// The avatar as something that is in the way.
class StandingAvatar {
  public:
    /// `skeleton` as an avatar's: bones with VRM names; at ease in `idle_pose`.
    StandingAvatar(const motion::Skeleton& skeleton, const motion::LocalPose& idle_pose);
    /// The reference humanoid at ease, 1.75 m tall, which targets are drawn for whatever avatar a study
    /// shows: they do not change with it.
    [[nodiscard]] static const StandingAvatar& reference();

    [[nodiscard]] const std::vector<motion::Capsule>& atRest() const { return at_rest_; }
    [[nodiscard]] Vec3 eyes() const;  ///< midpoint between them at rest; metres, rounded to 0.1 mm
    [[nodiscard]] std::vector<motion::Capsule> pointing(const Vec3& target) const;

  private:
    motion::Skeleton skeleton_;
    motion::HumanoidMap map_;
    std::vector<Pose> world_;
    std::vector<motion::Capsule> at_rest_;
};

/// The share of a ball's disc that an eye sees past a body and other balls, by a grid of points on the disc:
/// sums, products and roots alone, the same on every machine.
[[nodiscard]] double visibleShare(const Vec3& eye, const Sphere& ball,
                                  const std::vector<motion::Capsule>& body,
                                  const std::vector<Sphere>& others);

/// How much is seen of each of a trial's balls from one viewpoint, at the worst of its heights; shares,
/// rounded to a thousandth.
struct SeenBalls {
    std::string layout;
    Standing standing = Standing::headset;
    std::vector<double> at_rest;   ///< by ball, in the order of the balls asked about
    std::vector<double> pointing;  ///< while the avatar points at the target

    [[nodiscard]] double min() const;
    [[nodiscard]] bool clear() const { return min() >= min_visible_share; }
};

/// `balls`: the target first.
[[nodiscard]] SeenBalls seenFrom(const Viewpoint& viewpoint, const StandingAvatar& avatar,
                                 const std::vector<Sphere>& balls);

/// Whether balls around one target are clear to see from all viewpoints, past the reference avatar.
class ClearView {
  public:
    ClearView(const std::vector<Viewpoint>& from, const Vec3& target, double ball_radius_m);

    [[nodiscard]] bool seesTarget() const;
    /// Whether a further ball is seen beside the target and `others`, and hides none of them that was seen.
    [[nodiscard]] bool admits(const std::vector<Vec3>& others, const Vec3& more) const;

  private:
    std::vector<Vec3> eyes_;
    std::vector<std::vector<motion::Capsule>> bodies_;  ///< at rest, pointing
    Sphere target_;
};

}  // namespace deixis::studies
