// Recordings of joint positions, as every format of them comes: from points over time to a clip of the
// avatar.
#pragma once

#include <string>
#include <vector>

#include "assets/joints/clip_import.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::assets {

/// One joint over time; only moments at which it is known, in rising order.
struct JointTrack {
    std::vector<double> time_s{};
    std::vector<Vec3> position{};

    [[nodiscard]] bool empty() const { return time_s.empty(); }
    /// Straight lines between the known moments; the first and the last position outside. Not for an empty
    /// track.
    [[nodiscard]] Vec3 at(double t) const;
    /// Mean of the moments around t, weighted 1 2 3 2 1, `step_s` apart.
    [[nodiscard]] Vec3 smoothAt(double t, double step_s) const;
};

/// Positions in file units and axes, all of them at a steady rate.
struct PositionRecording {
    std::vector<motion::BonePositions> frames;
    std::string format;
    std::optional<FoundUnit> unit{};  ///< where the format says; none: to be detected
    std::optional<UpAxis> up{};       ///< the same
    FoundRate rate{};
    std::vector<std::string> remarks{};
};

/// Fails where lines stand less than 0.1 ms or more than 1 s apart on the whole: no recording does. `hint`:
/// what may help.
[[nodiscard]] Result<void> checkStep(double step_s, const std::string& name, std::string hint);

/// Frames from the first to the last of so many lines, at steps of `step_s`. Fails where that is more than
/// ten times the lines and a thousand: gaps would be filled with motion that nobody recorded. Adds a remark
/// where a gap of more than half a second is bridged.
[[nodiscard]] Result<std::size_t> framesOver(const std::vector<double>& times_s, double step_s,
                                             const std::string& name, std::vector<std::string>& remarks);

/// Turned and scaled as found and as the options say, on motion::referenceHumanoid() (clipFromPositions()).
/// The rate is the recording's. `name` stands for the file in errors.
[[nodiscard]] Result<ImportedClip> clipOfPositions(PositionRecording recording, const std::string& name,
                                                   const ImportOptions& options);

/// Which joint of a recording is which bone, by its name; -1 where none is. The neck and the hips, where they
/// have no joint of their own, are not among them: standInForTrunk() makes them.
[[nodiscard]] motion::HumanoidMap bonesByName(const std::vector<std::string>& joint_names);

/// A neck between the shoulders and hips between the upper legs, where a frame lacks them.
void standInForTrunk(motion::BonePositions& frame);

}  // namespace deixis::assets
