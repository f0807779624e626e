// Recordings that hold joint positions only: Kinect v2 body frames as CSV.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "motion/clip.hpp"

namespace deixis::assets {

/// Reads a recording of one person by Kinect v2, as Microsoft's LabanotationSuite writes it, onto
/// motion::referenceHumanoid(), facing +z with the feet on the floor, at 30 frames a second. A line is one
/// body frame: time in units of 100 ns, then x, y, z (metres, y up) and tracking state (0 not tracked, 1
/// inferred, 2 tracked) of the 25 joints in Kinect's order; no header. Positions that are not tracked and
/// gaps are bridged by straight lines, and positions are smoothed over about 0.1 s, for they tremble. How
/// positions become rotations: motion::clipFromPositions(). Errors name file and line.
[[nodiscard]] Result<motion::Clip> readKinectClip(const std::filesystem::path& path);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<motion::Clip> parseKinectClip(std::string_view text, const std::string& name);

}  // namespace deixis::assets
