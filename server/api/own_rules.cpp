#include "own_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/text.hpp"
#include "kept_json.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr const char* rules_file = "rules.json";
constexpr const char* rules_format = "deixis studio rules";
constexpr std::size_t largest_rules_file = std::size_t{8} << 20U;
constexpr std::size_t max_rules = 2000;
constexpr std::size_t max_motions_of_word = 50;
constexpr std::size_t longest_word = 40;

std::vector<OwnRule> rulesOf(const json& rules) {
    std::vector<OwnRule> out;
    for (const json& one : rules) out.push_back({one["word"], one["motions"]});
    return out;
}

/// What is wrong with rules of the right shape beside their motions.
std::optional<Refusal> wordProblem(const std::vector<OwnRule>& rules) {
    std::set<std::string> words;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const std::string field = fmt::format("rules[{}].word", i);
        if (rules[i].word.find_first_of(" \t\r\n") != std::string::npos)
            return Refusal{400, fmt::format("found '{}', expected one word", rules[i].word), field};
        if (!words.insert(lowerCase(rules[i].word)).second)
            return Refusal{400, fmt::format("'{}' has a rule already", rules[i].word), field};
    }
    return std::nullopt;
}

bool isIn(const std::vector<std::string>& known, const std::string& id) {
    return std::find(known.begin(), known.end(), id) != known.end();
}

}  // namespace

Shape ownRulesShape() {
    return listShape(
        "Words and the motions that go with them",
        objectShape("", {mustField("word", textShape("Without blanks", 1, longest_word)),
                         mustField("motions", listShape("Their ids; one of them is taken",
                                                        textShape("", 1, 64), 1, max_motions_of_word))}),
        0, max_rules);
}

json ownRulesJson(const std::vector<OwnRule>& rules) {
    json out = json::array();
    for (const OwnRule& one : rules) out.push_back({{"word", one.word}, {"motions", one.motions}});
    return out;
}

OwnRules ownRules(const KeptFolder& folder, const std::vector<std::string>& known) {
    OwnRules out;
    if (folder.has(rules_file)) {
        const auto content = readKeptJson(folder, rules_file, largest_rules_file, rules_format,
                                          {mustField("rules", ownRulesShape())});
        if (content)
            out.rules = rulesOf((*content)["rules"]);
        else if (folder.has(rules_file))
            out.damaged.push_back({rules_file, content.error().text()});
    }
    for (OwnRule& one : out.rules)
        std::erase_if(one.motions, [&](const std::string& id) { return !isIn(known, id); });
    std::erase_if(out.rules, [](const OwnRule& one) { return one.motions.empty(); });
    out.revision = revisionOf(ownRulesJson(out.rules).dump());
    return out;
}

OwnRules noRules() {
    OwnRules out;
    out.revision = revisionOf(ownRulesJson(out.rules).dump());
    return out;
}

tl::expected<OwnRules, Refusal> replaceOwnRules(const KeptFolder& folder,
                                                const std::vector<std::string>& known, const json& asked,
                                                const std::optional<std::string>& revision) {
    OwnRules out;
    out.rules = rulesOf(asked);
    if (auto problem = wordProblem(out.rules)) return tl::unexpected(std::move(*problem));
    for (std::size_t i = 0; i < out.rules.size(); ++i)
        for (std::size_t k = 0; k < out.rules[i].motions.size(); ++k)
            if (const std::string& id = out.rules[i].motions[k]; !isIn(known, id))
                return tl::unexpected(Refusal{400, fmt::format("there is no motion '{}'", id),
                                              fmt::format("rules[{}].motions[{}]", i, k)});
    const auto turn = folder.turn();
    if (!turn) return notWritten(turn.error());
    const OwnRules now = ownRules(folder, known);
    if (revision && *revision != "*" && *revision != now.revision) return otherRevision();
    if (!now.damaged.empty())
        if (const auto aside = folder.putAside(rules_file); !aside) return notWritten(aside.error());
    const json rules = ownRulesJson(out.rules);
    if (const auto written = writeKeptJson(folder, rules_file, rules_format, {{"rules", rules}}); !written)
        return notWritten(written.error());
    out.revision = revisionOf(rules.dump());
    return out;
}

}  // namespace deixis::server
