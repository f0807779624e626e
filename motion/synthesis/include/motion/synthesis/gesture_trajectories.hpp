// Gestures as rows of numbers that a regression can learn: from where a gesture points to how it goes.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "motion/synthesis/gaussian_process.hpp"
#include "motion/synthesis/phase_trajectory.hpp"
#include "motion/synthesis/pose_features.hpp"

namespace deixis::motion {

/// A trajectory is the logarithms of the five phases' durations in seconds, then the coefficients of
/// fitTrajectory() of the poses as PoseFeatures has them. It is a gesture of the right hand; those of the
/// left are their mirror images.
class GestureTrajectories {
  public:
    /// `eye_limit_rad`: the eyes turn no further. Fails as makeGenerator() does where the avatar lacks a
    /// bone.
    [[nodiscard]] static Result<GestureTrajectories> of(const Skeleton& avatar, double eye_limit_rad);
    GestureTrajectories(PointingBody body, double eye_limit_rad);

    [[nodiscard]] const PoseFeatures& features() const { return features_; }
    [[nodiscard]] std::size_t size() const;

    /// A place as the standing body sees it from its eyes at ease: azimuth and elevation in radians, and 1 /
    /// distance in 1/m.
    [[nodiscard]] std::vector<double> seen(const Vec3& place_m) const;
    /// Of a demonstration: its trajectory, and where it really points by the line from the eyes through the
    /// fingertip in the middle of its hold: the point of that line which is as far from the eyes at ease as
    /// the target.
    struct Observation {
        Vec3 place_m{0.0};
        std::vector<double> seen;
        std::vector<double> trajectory;
    };
    [[nodiscard]] Observation observe(const Demonstration& demonstration) const;

    /// Each from 0.05 to 10 s, whatever a trajectory says.
    [[nodiscard]] PhaseDurations durations(std::span<const double> trajectory) const;
    /// In the middle of the hold.
    [[nodiscard]] LocalPose pointingPose(std::span<const double> trajectory) const;
    /// By how much the line from the eyes through the fingertip misses a place then: to its left and above,
    /// as the eyes see it, radians.
    [[nodiscard]] std::array<double, 2> missed_rad(std::span<const double> trajectory,
                                                   const Vec3& place_m) const;

    /// Elbow, wrist and fingertip of the pointing arm at an aligned time (phase_trajectory.hpp), metres.
    [[nodiscard]] std::array<Vec3, 3> arm_m(std::span<const double> trajectory, double aligned_time) const;

    /// The clip of the trajectory that `trajectoryTo` gives for a target on the right hand's side, held as
    /// asked for; a target of the left hand's is pointed at in the mirror. `stream` names the random numbers
    /// of what makes a hold unsteady.
    [[nodiscard]] GeneratedClip perform(
        const GenerationRequest& asked, std::string_view stream,
        const std::function<std::vector<double>(const Vec3&)>& trajectoryTo) const;

  private:
    [[nodiscard]] LocalPose poseAt(std::span<const double> trajectory, double aligned_time) const;
    [[nodiscard]] GeneratedClip rightHanded(const std::vector<double>& trajectory,
                                            const GenerationRequest& asked, std::string_view stream) const;

    std::shared_ptr<const PointingBody> body_;
    PoseFeatures features_;
    double eye_limit_rad_;
};

/// As near as the nearest of what a process was fitted to, and as far as the farthest: in which direction a
/// place is says how it is pointed at, and how near it is little, of which a process knows nothing outside.
[[nodiscard]] std::vector<double> asNearAs(const GaussianProcess& process, std::vector<double> seen);

/// From what is seen to the trajectory; length and noise of the kernel are the likeliest of a few.
[[nodiscard]] GaussianProcess trajectoryRegression(
    const std::vector<GestureTrajectories::Observation>& observations);

}  // namespace deixis::motion
