// Cutting a continuous recording of pointing into gestures. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/gesture_phases.hpp"

namespace deixis::motion {

enum class CutBy : unsigned char {
    /// The rule of Deichler et al. (2023, section 2.1): a gesture begins when the hand leaves its stance
    /// with the arms down and ends when it is back.
    returns,
    /// Each hold of a straight, raised arm is a gesture; for gesturing without returns between.
    holds
};

/// Lengths in arm lengths (shoulder to elbow to wrist), so that neither unit nor stature matters. The hand's
/// displacement is its distance, seen from the shoulder, from where it rests.
struct SegmentationOptions {
    CutBy by = CutBy::returns;
    /// A frame in which both hands are at rest; none: the stance is found, see Segmentation::rest.
    std::optional<int> rest_frame{};

    /// By returns: a gesture must go beyond `out`, and lasts from where the displacement last was within
    /// `back` to where it is within it again.
    double out = 0.45;
    double back = 0.20;
    double min_gesture_s = 0.3;  ///< beyond `back`; what is shorter is none
    double min_rest_s = 0.1;     ///< within `back`; what is shorter does not end a gesture

    /// By holds: the hand at least this far from the shoulder, slower than this over the last thirtieth of
    /// a second (0.5 m/s is the paper's still hand, section 3.2), this long, and farther from rest than
    /// `out`.
    double hold_reach = 0.93;
    double hold_speed_m_s = 0.5;
    double min_hold_s = 0.3;

    double margin_s = 0.3;  ///< of rest kept before and after a gesture, where there is so much
};

/// Frames of the recording; 0 <= first <= onset, end <= last. By holds, onset and end are where the hand sets
/// out for the hold and stops after it.
struct Gesture {
    int first = 0;
    int last = 0;
    GesturePhases phases;
    std::vector<std::string> remarks{};  ///< what makes it doubtful; empty for a plain gesture
};

/// What looks like a gesture but is not whole.
struct LeftOut {
    int first = 0;
    int last = 0;
    Side hand = Side::right;
    std::string why;
};

struct Segmentation {
    std::vector<Gesture> gestures;  ///< by onset
    std::vector<LeftOut> left_out;
    std::vector<std::string> remarks;  ///< on the recording as a whole
};

/// Cuts a recording (metres, y up). `map` must have the hips, the legs' upper ends and both arms from
/// shoulder to hand. The stance at rest, of each hand, is the median of the moments in which the hand hangs
/// still: within 40 degrees of straight down and slower than 0.15 m/s; fails if those sum up to less than
/// 0.2 s (by holds, an arm straight down is taken then, with a remark). Fails too where a bone is missing,
/// the figure does not stand upright, or the rest frame is not in the recording.
[[nodiscard]] Result<Segmentation> segment(const Clip& recording, const HumanoidMap& map,
                                           const SegmentationOptions& options = {});

/// Whether a target, in the avatar's axes, lies behind: more than 90 degrees from straight ahead.
[[nodiscard]] constexpr bool liesBehind(const Vec3& target) {
    return target.z < 0.0;
}

}  // namespace deixis::motion
