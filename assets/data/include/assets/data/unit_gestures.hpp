// The library of unit gestures as a TOML file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "motion/unit_gestures/unit_gesture.hpp"

namespace deixis::assets {

/// Reads assets/data/unit_gestures.toml or a file of its form, which its head describes. Unknown keys, ids
/// that stand twice and gestures that motion::checkGesture() refuses are rejected. Errors name file, line and
/// gesture.
[[nodiscard]] Result<motion::GestureLibrary> loadUnitGestures(const std::filesystem::path& path);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<motion::GestureLibrary> parseUnitGestures(std::string_view text,
                                                               const std::string& name);

}  // namespace deixis::assets
