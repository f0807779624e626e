// The parameters of the synthetic demonstrations and of the systems made from them, as a TOML file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "motion/synthesis/demonstration_parameters.hpp"

namespace deixis::assets {

/// Reads assets/data/demonstrations.toml or a file of its form. Every key must be there and none else; values
/// outside their limits are rejected. Errors name file, line and key.
[[nodiscard]] Result<motion::DemonstrationParameters> loadDemonstrationParameters(
    const std::filesystem::path& path);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<motion::DemonstrationParameters> parseDemonstrationParameters(std::string_view text,
                                                                                   const std::string& name);

}  // namespace deixis::assets
