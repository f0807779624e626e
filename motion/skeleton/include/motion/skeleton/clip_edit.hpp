// Cutting, moving and mirroring clips.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::motion {

/// The mirror is the plane x = 0, so left and right change places: (x, y, z) -> (-x, y, z), and rotation
/// (w, x, y, z) -> (w, x, -y, -z). Only signs change: mirrored twice, everything is itself again, bit for
/// bit.
[[nodiscard]] Vec3 mirrored(const Vec3& point);
[[nodiscard]] Pose mirrored(const Pose& pose);

/// For each joint the one on the other side; the joint itself where it lies in the middle or has none. Told
/// by names: the words left and right (LeftArm, armLeft, left_arm), L and R standing alone (arm.L, L_Arm,
/// "Bip01 L Arm"), and, where both joints of the pair are there, a first or last letter (lhumerus, LThumb,
/// handL). Joints whose names pair with none are paired by the humanoid bones that `map` gives them.
[[nodiscard]] std::vector<int> mirrorPartners(const Skeleton& skeleton, const HumanoidMap& map = {});

/// The clip's mirror image: in every frame each joint stands where the mirror shows its partner, "LeftArm"
/// where it shows "RightArm". The figure is mirrored with its motion, rest pose and end sites too: an uneven
/// figure's bones change sides with their lengths. An exact involution: mirrored twice, the clip is the same
/// bit for bit (with the same `map`; see mirrorPartners). Joints keep their order where both sides have the
/// same joints; else they stand in the source's order under changed names, and a joint without a partner
/// whose name tells its side by a word takes the other side's word.
[[nodiscard]] Clip mirrored(const Clip& clip, const HumanoidMap& map = {});

/// The pose that shows a figure's mirrored posture on the same figure: rotations change sides, a root's
/// position is mirrored, every other joint keeps its own offset (and so its bone lengths, where the two sides
/// differ). `partners`: as mirrorPartners tells.
[[nodiscard]] LocalPose mirrored(const Skeleton& skeleton, const std::vector<int>& partners,
                                 const LocalPose& pose);

/// The frames `first` to `last`, both kept, from 0. Fails if 0 <= first <= last < frame count does not
/// hold.
[[nodiscard]] Result<Clip> trimmed(const Clip& clip, int first, int last);

/// The clip in other axes: roots are moved and turned, the rest follows. Rest poses stay.
[[nodiscard]] Clip moved(const Clip& clip, const Pose& new_from_old);

/// One sign of each rotation from frame to frame, so that a plain blend between neighbours never turns the
/// long way; all of unit length.
void makeContinuous(std::vector<LocalPose>& frames);

}  // namespace deixis::motion
