// What the commands that run sessions have in common.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/random.hpp"
#include "studies/design/plan.hpp"

namespace deixis::app {

/// Seed of the simulated participant who goes through a plan: the same whoever runs it.
[[nodiscard]] inline std::uint64_t simulatedSeed(const studies::StudyPlan& plan) {
    return deriveSeed(deriveSeed(plan.seed, "simulated participant"), plan.participant);
}

/// Where the clips of built-in systems are kept: beside the database.
[[nodiscard]] inline std::filesystem::path stimuliFolder(const std::filesystem::path& database) {
    return database.parent_path() / "stimuli";
}

}  // namespace deixis::app
