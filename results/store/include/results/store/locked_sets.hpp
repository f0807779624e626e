// What a database says about the locked copies of a study beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

/// Hashes of the locked sets that a database speaks of: that in force, and those of the plans.
[[nodiscard]] Result<std::vector<std::string>> lockedSets(const std::filesystem::path& database);

}  // namespace deixis::results
