// Which motions go with which words, as people want it: one file of the kept folder.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/http/route.hpp"
#include "server/kept/kept_folder.hpp"

namespace deixis::server {

struct OwnRule {
    std::string word;                  ///< small and capital letters are alike
    std::vector<std::string> motions;  ///< ids, of which one is taken; at least one
};

struct OwnRules {
    std::vector<OwnRule> rules;
    std::string revision;  ///< of these rules
    std::vector<DamagedFile> damaged;
};

/// `known`: ids of all motions that there are. What is there no more is left out, and with its last motion a
/// rule.
[[nodiscard]] OwnRules ownRules(const KeptFolder& folder, const std::vector<std::string>& known);

[[nodiscard]] OwnRules noRules();

[[nodiscard]] Shape ownRulesShape();
[[nodiscard]] nlohmann::json ownRulesJson(const std::vector<OwnRule>& rules);

/// Replaces all by those of that shape, where they are of the revision; none: whatever they are. A file that
/// cannot be read stays, under another name. Refuses a word twice and motions that are not known.
[[nodiscard]] tl::expected<OwnRules, Refusal> replaceOwnRules(const KeptFolder& folder,
                                                              const std::vector<std::string>& known,
                                                              const nlohmann::json& asked,
                                                              const std::optional<std::string>& revision);

}  // namespace deixis::server
