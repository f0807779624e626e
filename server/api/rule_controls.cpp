#include "rule_controls.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>

#include "core/text.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "motion_json.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr int farthest_off_frames = 3;  ///< that a gesture may stand beside its word's middle

struct Taken {
    int from = 0;
    int to = 0;  ///< beyond its last frame
};

/// In lower case, without the marks around it.
std::string plainWord(std::string_view word) {
    const auto is_mark = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x80 && std::isalnum(byte) == 0;
    };
    while (!word.empty() && is_mark(word.front())) word.remove_prefix(1);
    while (!word.empty() && is_mark(word.back())) word.remove_suffix(1);
    return lowerCase(word);
}

/// Evenly spread; the page draws the same.
std::uint32_t drawnFor(std::uint64_t seed, std::size_t word) {
    auto x = static_cast<std::uint32_t>(seed) ^ (static_cast<std::uint32_t>(word + 1) * 0x9e3779b9U);
    x = (x ^ (x >> 16U)) * 0x85ebca6bU;
    x = (x ^ (x >> 13U)) * 0xc2b2ae35U;
    return x ^ (x >> 16U);
}

/// None where it was deleted this moment.
std::optional<json> framesOf(const StudioWork& work, const OwnMotions& own, const std::string& id) {
    if (const motion::UnitGesture* shipped = motion::findGesture(work.parts().library, id))
        return framesJson(motion::motionOf(*shipped));
    const auto found = std::ranges::find(own.motions, id, &OwnMotion::id);
    if (found == own.motions.end()) return std::nullopt;
    return framesJson(found->motion);
}

std::vector<Taken> takenBy(const json& controls) {
    std::vector<Taken> out;
    for (const json& one : controls) {
        const int start = one["start_frame"];
        out.push_back({start, start + static_cast<int>(one["frames"].size())});
    }
    return out;
}

/// Where so many frames fit that is nearest to where they are wanted.
std::optional<int> nearestStart(std::vector<Taken> taken, int length, int wanted, int total) {
    std::sort(taken.begin(), taken.end(), [](const Taken& a, const Taken& b) { return a.from < b.from; });
    taken.push_back({total, total});
    std::optional<int> best;
    int from = 0;
    for (const Taken& one : taken) {
        if (one.from - from >= length) {
            const int start = std::clamp(wanted, from, one.from - length);
            if (!best || std::abs(start - wanted) < std::abs(*best - wanted)) best = start;
        }
        from = std::max(from, one.to);
    }
    return best;
}

}  // namespace

RuleControls addRuleControls(const StudioWork& work, const Utterance& utterance, json& asked) {
    RuleControls out;
    std::map<std::string, std::vector<std::string>> motions_of;
    for (OwnRule& one : work.ownRules().rules) motions_of[plainWord(one.word)] = std::move(one.motions);
    const OwnMotions own = work.ownMotions();
    json& controls = asked["pose_controls"];
    if (controls.is_null()) controls = json::array();
    const int total = static_cast<int>(motion::frameCountOf(utterance.duration_s));
    const std::uint64_t seed = asked["seed"];
    for (std::size_t k = 0; k < utterance.words.size(); ++k) {
        const SpokenWord& word = utterance.words[k];
        const auto rule = motions_of.find(plainWord(word.text));
        if (rule == motions_of.end()) continue;
        const std::string& id = rule->second[drawnFor(seed, k) % rule->second.size()];
        const auto frames = framesOf(work, own, id);
        if (!frames) continue;
        const int length = static_cast<int>(frames->size());
        const double middle = (word.start_s + word.end_s) / 2.0 * motion::upper_body_fps;
        const int wanted =
            std::min(std::max(0, static_cast<int>(std::floor(middle - length / 2.0 + 0.5))), total - length);
        const auto start =
            length > total ? std::nullopt : nearestStart(takenBy(controls), length, wanted, total);
        if (!start || std::abs(*start - wanted) > farthest_off_frames) {
            out.no_room.push_back(static_cast<int>(k));
            continue;
        }
        controls.push_back({{"start_frame", *start}, {"frames", *frames}});
        out.put.push_back({static_cast<int>(k), id, *start, length});
    }
    if (controls.empty()) asked.erase("pose_controls");
    return out;
}

}  // namespace deixis::server
