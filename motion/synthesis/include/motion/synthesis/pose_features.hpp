// A pose as the numbers that learned systems work with: how far the joints of the upper body are turned from
// the stance at ease.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::motion {

struct PointingBody;

/// The numbers are, for each joint of trunk, head, eyes, arms and index knuckles, the rotation vector
/// (exponential map, radians) from its orientation at ease to that of the pose; then, for each hand, left
/// first, how far the other joints of its fingers are on the way from ease (0) to the pointing hand (1). At
/// ease all are 0. That stance is far from the half turn at which rotation vectors wrap. Who points stands:
/// the pelvis stays in its place and the legs at ease, whatever they do in the pose.
class PoseFeatures {
  public:
    /// Fails as makeGenerator() does where the avatar lacks a bone.
    [[nodiscard]] static Result<PoseFeatures> of(const Skeleton& avatar);
    explicit PoseFeatures(const PointingBody& body);

    [[nodiscard]] std::size_t size() const { return 3 * joints_.size() + hands_.size(); }
    /// The names of the joints and the hands, with blanks between: bodies with the same can be moved by the
    /// same numbers.
    [[nodiscard]] std::string names() const;
    [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }

    /// `previous`: the numbers of the frame before, from which each joint's vector is continued beyond the
    /// half turn; empty for a first frame.
    [[nodiscard]] std::vector<double> encode(const LocalPose& pose, std::span<const double> previous) const;
    /// Of a clip of this skeleton, one entry a frame.
    [[nodiscard]] std::vector<std::vector<double>> encode(const Clip& clip) const;
    [[nodiscard]] LocalPose decode(std::span<const double> features) const;

  private:
    struct FingerTurn {
        std::size_t joint = 0;
        Vec3 turn{0.0};  ///< rotation vector from ease to the pointing hand
    };
    Skeleton skeleton_;
    LocalPose at_ease_;
    std::vector<std::size_t> joints_;
    std::array<std::vector<FingerTurn>, 2> hands_;
};

}  // namespace deixis::motion
