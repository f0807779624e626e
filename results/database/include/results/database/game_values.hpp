// What the referential game keeps of its trials and choices, for its analysis.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/pose.hpp"

namespace deixis::results {

/// Joins to `responses AS r` the views of what the game declares (studies/trials/game): `g` of the trial, `h`
/// of the response. Other kinds have no row.
inline constexpr const char* game_values =
    "JOIN game_trials AS g ON g.participant = r.participant AND g.trial_index = r.trial_index "
    "JOIN game_choices AS h ON h.response = r.id ";

/// Of JSON [[x,y,z],...].
[[nodiscard]] inline std::vector<Vec3> positionsOf(const std::string& text) {
    std::vector<Vec3> out;
    for (const nlohmann::json& one : nlohmann::json::parse(text))
        out.emplace_back(one.at(0).get<double>(), one.at(1).get<double>(), one.at(2).get<double>());
    return out;
}

}  // namespace deixis::results
