// Gestures that people's rules put on the words of a speech: the same as the page puts
// (web/src/model/rules.ts).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/utterance.hpp"
#include "studio_work.hpp"

namespace deixis::server {

struct RuleGesture {
    int word = 0;  ///< index in Utterance::words
    std::string motion;
    int start_frame = 0;
    int frame_count = 0;
};

struct RuleControls {
    std::vector<RuleGesture> put;
    std::vector<int> no_room;  ///< words that have a rule, and no room for its gesture near them
};

/// Adds them to `pose_controls` of a request, which may be missing: a gesture in the middle of each word that
/// has a rule, where it fits between what is there already. Which of several motions it is, `seed` and word
/// say.
[[nodiscard]] RuleControls addRuleControls(const StudioWork& work, const Utterance& utterance,
                                           nlohmann::json& asked);

}  // namespace deixis::server
