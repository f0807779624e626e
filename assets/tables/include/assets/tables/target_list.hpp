// A list of targets to make clips for, as CSV, such as `deixis targets` prints.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::assets {

/// Of a target's coordinates, here and in manifests: beyond it directions lose their precision.
constexpr double farthest_target_m = 1000.0;

struct ListedTarget {
    std::string
        id;  ///< letters, digits, '_', '-' and '.', not starting with '.': it becomes part of file names
    Vec3 position{0.0};  ///< metres, in the avatar's frame
};

/// Reads the columns target_id, x, y and z; others are skipped. At least one target, ids unique. Errors
/// name file, line and column.
[[nodiscard]] Result<std::vector<ListedTarget>> readTargetList(const std::filesystem::path& path);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<std::vector<ListedTarget>> parseTargetList(std::string_view text,
                                                                const std::string& name);

}  // namespace deixis::assets
