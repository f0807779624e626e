// The shipped synthetic demonstrations, on the shipped skeleton.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::app {

struct SyntheticDemonstrations {
    std::vector<motion::Demonstration> made;  ///< not mirrored
    std::filesystem::path parameters;         ///< the file that they follow from
    std::string sha256;                       ///< of its bytes
};

[[nodiscard]] Result<SyntheticDemonstrations> syntheticDemonstrations();

}  // namespace deixis::app
