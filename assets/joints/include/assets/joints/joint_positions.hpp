// Recordings that have only joint positions: Kinect v2 body frames, CSV with named joints, SGToolkit JSON.
// How positions become rotations: motion::clipFromPositions().
#pragma once

#include <string>
#include <string_view>

#include "assets/joints/clip_import.hpp"
#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::assets {

/// Reads a recording of one person by Kinect v2, as Microsoft's LabanotationSuite writes it, onto
/// motion::referenceHumanoid(), facing +z with the feet on the floor, at 30 frames per second. A line is one
/// body frame: time in units of 100 ns, then x, y, z (metres, y up) and tracking state (0 not tracked, 1
/// inferred, 2 tracked) of the 25 joints in Kinect's order; no header. Positions that are not tracked and
/// gaps are bridged by straight lines, and positions are smoothed over about 0.1 s, for they tremble.
/// Where options.fps is given, times are not looked at. `name` stands for the file in errors, which name the
/// line.
[[nodiscard]] Result<ImportedClip> parseKinectClip(std::string_view text, const std::string& name,
                                                   const ImportOptions& options = {});

/// Reads positions of named joints, one frame a line under a header: NAME.x, NAME.y, NAME.z for every joint
/// (also NAME_x, NAME x, x.NAME, in any case), and perhaps a column `time` in seconds (`time_ms` in
/// milliseconds); other columns are skipped, and a remark says so. Fields are separated by commas,
/// semicolons or tabs. An empty field or NaN is an unknown position, bridged by straight lines. Joints are
/// told by their names as motion::detectHumanoid() knows them. Times may be unsteady: the clip is sampled at
/// the middle one of their steps. Without times 30 fps are assumed.
[[nodiscard]] Result<ImportedClip> parseJointCsv(std::string_view text, const std::string& name,
                                                 const ImportOptions& options = {});

/// World positions of every joint in every frame, and of tips, which are called NAME_End: a header
/// frame,time,NAME.x,NAME.y,NAME.z,... and a line for each frame; seconds and metres, 6 decimals.
/// parseJointCsv() reads it.
[[nodiscard]] std::string writeJointCsv(const motion::Clip& clip);

/// Reads gestures of the SGToolkit (Yoon et al. 2021; github.com/ai4r/SGToolkit) from JSON: an array of
/// frames, bare or as "output-data" or "motion" of an object, or an array of such objects with a "name" each,
/// of which options.animation chooses. A frame is 30 numbers, x y z of 10 joints: spine, neck, nose, top of
/// the head, left shoulder, elbow, wrist, right shoulder, elbow, wrist; or 27, the directions of its 9 bones.
/// 15 frames per second. Legs and hips stay at rest. Which axis is up and whether x points to the left or, as
/// in the toolkit's window, to the right is told from the figure: the nose lies before the line from neck to
/// top.
[[nodiscard]] Result<ImportedClip> parseSgToolkitJson(std::string_view text, const std::string& name,
                                                      const ImportOptions& options = {});

}  // namespace deixis::assets
