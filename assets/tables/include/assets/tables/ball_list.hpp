// The balls among which a pointing clip is read, as CSV, such as `deixis targets` prints.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::assets {

/// A target with the distractors of one distance. Positions in metres, in the avatar's frame.
struct BallSet {
    std::string band;                  ///< name of the distance; empty if there is one alone
    std::vector<Vec3> balls{};         ///< the target first
    std::vector<std::string> names{};  ///< of the balls: "target", "d1", "d2", ...
};

/// Sets by target id; each has every distance of the list, in the order of its columns.
using BallList = std::map<std::string, std::vector<BallSet>>;

/// Reads target_id,x,y,z and at least one distractor: columns [BAND_]dN_x, [BAND_]dN_y, [BAND_]dN_z. A target
/// whose distractor has three empty cells lacks it. Errors name file, line and column.
[[nodiscard]] Result<BallList> readBallList(const std::filesystem::path& path);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<BallList> parseBallList(std::string_view text, const std::string& name);

}  // namespace deixis::assets
