// Angles between a game's distractors and its target: what makes a choice hard or easy, besides distance.
#pragma once

#include <vector>

#include "core/pose.hpp"
#include "studies/study_file/standing.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// Between a target and each of its distractors, in their order; degrees, rounded to a hundredth.
struct BallAngles {
    std::vector<double> avatar_deg;   ///< as the avatar's eyes see them: the reference humanoid's, at rest
    std::vector<double> headset_deg;  ///< from the layout's place in a headset, eyes at Study::eye_height_m
    std::vector<double> desktop_deg;  ///< from its place at a desktop

    [[nodiscard]] const std::vector<double>& of(Standing standing) const {
        return standing == Standing::headset ? headset_deg : desktop_deg;
    }
    friend bool operator==(const BallAngles&, const BallAngles&) = default;
};

/// Between two balls' centres as an eye sees them; degrees, rounded to a hundredth, so that the last bits of
/// a library's arc cosine cannot matter. An eye in a ball's centre sees it 0 degrees from everything.
[[nodiscard]] double angleSeen_deg(const Vec3& eye, const Vec3& a, const Vec3& b);

[[nodiscard]] BallAngles ballAngles(const Study& study, const Layout& layout, const Vec3& target,
                                    const std::vector<Vec3>& distractors);

}  // namespace deixis::studies
