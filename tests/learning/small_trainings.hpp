// What the tests of trainings start from.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>

#include "learning/training/training.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::tests {

/// Five synthetic ones, of which the third is held out.
inline const learning::DemonstrationSets& fewDemonstrations() {
    static const learning::DemonstrationSets data = [] {
        motion::DemonstrationParameters parameters;
        parameters.left_count = 2;
        parameters.right_count = 3;
        auto out = learning::splitDemonstrations(
            motion::makeDemonstrations(motion::referenceHumanoid(), parameters).value(), false);
        out.sha256 = "few";
        return out;
    }();
    return data;
}

/// A folder that is removed at the end.
struct TrainingFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("deixis-training-" + std::to_string(getpid()));
    TrainingFolder() { std::filesystem::create_directories(path); }
    ~TrainingFolder() { std::filesystem::remove_all(path); }
};

inline bool goOn(const learning::TrainingProgress&) {
    return true;
}

}  // namespace deixis::tests
