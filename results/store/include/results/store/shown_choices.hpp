// Choices of the game with what was visible: which clip, which balls, from where.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "results/store/store.hpp"

namespace deixis::results {

struct ShownChoice {
    std::string participant;
    studies::Stimulus stimulus{};
    std::string layout;
    std::vector<Vec3> balls{};  ///< centres in the order in which they were shown
    int target_place = 0;       ///< which of `balls`
    int chosen_place = 0;
    Vec3 head_m{0.0};  ///< the participant's, at the answer
    ClipRecord clip{};
    std::string avatar_hash;  ///< SHA-256 of the avatar that the session showed
};

struct ShownChoices {
    std::string study_source;          ///< the study file's text; empty if it was not kept
    std::vector<ShownChoice> choices;  ///< by participant, then in the order of their trials
};

/// The scored choices that count, of participants who count. None is not an error.
[[nodiscard]] Result<ShownChoices> loadShownChoices(const std::filesystem::path& database);

}  // namespace deixis::results
