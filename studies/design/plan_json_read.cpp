// The plan as JSON: reading. Every key must be there, of its type, and no other.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "studies/design/plan.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

using Json = nlohmann::ordered_json;

/// Carries an error out of the readers below; never leaves this file.
struct BadPlan : std::runtime_error {
    BadPlan(std::string where_, const std::string& message)
        : std::runtime_error(message), where(std::move(where_)) {}
    std::string where;
};

/// An object read key by key: every key must be there, of its type, and no other.
class Reader {
  public:
    Reader(const Json& json, std::string where, std::size_t keys) : json_(json), where_(std::move(where)) {
        if (!json.is_object()) bad("", json, "an object");
        if (json.size() > keys)
            throw BadPlan(where_, fmt::format("found {} keys, expected {}", json.size(), keys));
    }

    [[nodiscard]] const Json& get(const char* key) const {
        const auto found = json_.find(key);
        if (found == json_.end()) throw BadPlan(name(key), "missing");
        return *found;
    }
    [[nodiscard]] std::string text(const char* key) const { return text(key, get(key)); }
    [[nodiscard]] std::string text(const char* key, const Json& json) const {
        if (!json.is_string()) bad(key, json, "a text");
        return json.get<std::string>();
    }
    [[nodiscard]] bool boolean(const char* key) const {
        const Json& json = get(key);
        if (!json.is_boolean()) bad(key, json, "true or false");
        return json.get<bool>();
    }
    [[nodiscard]] double number(const char* key) const {
        const Json& json = get(key);
        if (!json.is_number()) bad(key, json, "a number");
        return json.get<double>();
    }
    [[nodiscard]] std::uint64_t count(const char* key) const {
        const Json& json = get(key);
        if (!json.is_number_unsigned()) bad(key, json, "a whole number, 0 or more");
        return json.get<std::uint64_t>();
    }
    /// A whole number within `low`..`high`.
    [[nodiscard]] int whole(const char* key, int low, int high) const {
        const Json& json = get(key);
        const bool fits =
            json.is_number_integer() &&
            !(json.is_number_unsigned() &&
              json.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) &&
            json.get<std::int64_t>() >= low && json.get<std::int64_t>() <= high;
        if (!fits) bad(key, json, fmt::format("a whole number from {} to {}", low, high));
        return json.get<int>();
    }
    [[nodiscard]] const Json& list(const char* key) const {
        const Json& json = get(key);
        if (!json.is_array()) bad(key, json, "a list");
        return json;
    }
    [[nodiscard]] Vec3 position(const char* key, const Json& json) const {
        const bool three = json.is_array() && json.size() == 3 &&
                           std::all_of(json.begin(), json.end(), [](const Json& e) { return e.is_number(); });
        if (!three) bad(key, json, "a position [x, y, z]");
        return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
    }
    [[noreturn]] void bad(const char* key, const Json& found, std::string_view expected) const {
        std::string shown = found.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (shown.size() > 60) shown = found.type_name();
        throw BadPlan(name(key), fmt::format("found {}, expected {}", shown, expected));
    }
    [[nodiscard]] std::string name(std::string_view key) const {
        if (where_.empty() || key.empty()) return where_ + std::string(key);
        return fmt::format("{}.{}", where_, key);
    }

  private:
    const Json& json_;
    std::string where_;
};

constexpr int max = std::numeric_limits<int>::max();

std::vector<int> readBallOrder(const Reader& reader, std::size_t balls) {
    const Json& json = reader.list("ball_order");
    std::vector<int> out;
    std::vector<bool> seen(balls, false);
    for (const Json& entry : json) {
        const bool place = entry.is_number_unsigned() && entry.get<std::uint64_t>() < balls;
        if (!place || seen[entry.get<std::size_t>()]) break;
        seen[entry.get<std::size_t>()] = true;
        out.push_back(entry.get<int>());
    }
    if (out.size() != balls || json.size() != balls)
        reader.bad("ball_order", json, "each ball's number once: 0 for the target, 1.. for the distractors");
    return out;
}

std::vector<Stimulus> readStimuli(const Reader& reader, StageKind kind) {
    const Json& json = reader.list("stimuli");
    std::vector<Stimulus> out;
    for (const Json& entry : json) {
        const bool several = entry.is_object() && entry.contains("clip");
        const Reader one(entry, reader.name(fmt::format("stimuli[{}]", out.size())), several ? 3 : 2);
        out.push_back({one.text("system"), one.text("item"), several ? one.whole("clip", 1, max) : 0});
    }
    const StageDeclaration& declared = declarationOf(kind);
    const int n = static_cast<int>(out.size());
    if (n < declared.min_stimuli || n > declared.max_stimuli)
        reader.bad("stimuli", json,
                   !declared.showsClips() ? "no stimuli on a page"
                   : declared.min_stimuli < declared.max_stimuli
                       ? fmt::format("{} to {} stimuli", declared.min_stimuli, declared.max_stimuli)
                   : declared.min_stimuli == 1 ? "one stimulus"
                                               : "two stimuli");
    return out;
}

std::optional<TrialCheck> readCheck(const Reader& trial, const Trial& read) {
    const Json& json = trial.get("check");
    if (json.is_null()) return std::nullopt;
    constexpr std::size_t keys = 4;
    const Reader reader(json, trial.name("check"), keys);
    constexpr std::array kinds{CheckKind::number, CheckKind::catch_trial, CheckKind::repeat};
    const std::string name = reader.text("kind");
    const auto* kind =
        std::find_if(kinds.begin(), kinds.end(), [&](CheckKind k) { return checkKindName(k) == name; });
    if (kind == kinds.end()) reader.bad("kind", reader.get("kind"), "\"number\", \"catch\" or \"repeat\"");
    TrialCheck check;
    check.kind = *kind;
    check.stimulus = reader.whole("stimulus", 0, std::max(0, static_cast<int>(read.stimuli.size()) - 1));
    check.expected = reader.number("expected");
    check.of_trial = check.kind == CheckKind::repeat ? reader.whole("of_trial", 0, read.index - 1)
                                                     : reader.whole("of_trial", -1, -1);
    return check;
}

/// `count` numbers from 0 to `largest`; what they are is said by `expected`.
std::vector<double> readNumbers(const Reader& reader, const char* key, std::size_t count, double largest,
                                std::string_view expected) {
    const Json& json = reader.list(key);
    std::vector<double> out;
    for (const Json& number : json)
        if (number.is_number() && number.get<double>() >= 0.0 && number.get<double>() <= largest)
            out.push_back(number.get<double>());
    if (out.size() != count || json.size() != count) reader.bad(key, json, expected);
    return out;
}

/// Plans from before it was kept have none.
std::vector<SeenBalls> readSeen(const Reader& trial, const Trial& read) {
    const Json& json = trial.get("visibility");
    const Reader stands(json, trial.name("visibility"), 2);
    std::vector<SeenBalls> out;
    for (const Standing standing : {Standing::headset, Standing::desktop}) {
        const std::string name(standingName(standing));
        constexpr std::size_t keys = 2;
        const Reader one(stands.get(name.c_str()), stands.name(name), keys);
        const std::size_t balls = read.ball_order.size();
        const auto shares = [&](const char* key) {
            return readNumbers(one, key, balls, 1.0, "a share from 0 to 1 for each ball");
        };
        out.push_back({read.layout, standing, shares("at_rest"), shares("pointing")});
    }
    return out;
}

/// Plans from before they were kept have none.
BallAngles readAngles(const Reader& trial, std::size_t distractors) {
    constexpr std::size_t keys = 3;
    const Reader reader(trial.get("angles"), trial.name("angles"), keys);
    const auto degrees = [&](const char* key) {
        return readNumbers(reader, key, distractors, 180.0, "degrees from 0 to 180 for each distractor");
    };
    return {degrees("avatar"), degrees("headset"), degrees("desktop")};
}

Trial readTrial(const Json& json, std::size_t index, const std::vector<std::string>& stages) {
    const bool seen = json.is_object() && json.contains("visibility");
    const bool angles = json.is_object() && json.contains("angles");
    const std::size_t keys = std::size_t{13} + (seen ? 1 : 0) + (angles ? 1 : 0);
    const Reader reader(json, fmt::format("trials[{}]", index), keys);
    Trial trial;
    if (reader.count("index") != index)
        reader.bad("index", reader.get("index"), "the trials in order from 0");
    trial.index = static_cast<int>(index);
    trial.stage = reader.text("stage");
    if (std::find(stages.begin(), stages.end(), trial.stage) == stages.end())
        reader.bad("stage", reader.get("stage"), "one of the plan's stages");
    const std::optional<StageKind> kind = stageKindFromName(reader.text("kind"));
    if (!kind || !declarationOf(*kind).answered)
        reader.bad("kind", reader.get("kind"), "a kind of stage that has answers");
    trial.kind = *kind;
    const StageDeclaration& declared = declarationOf(*kind);
    trial.practice = reader.boolean("practice");
    trial.attempt = reader.whole("attempt", 0, trial.practice ? max : 0);
    trial.page = reader.whole("page", 0, declared.in_pages ? max : 0);
    trial.stimuli = readStimuli(reader, trial.kind);
    trial.layout = reader.text("layout");
    trial.distance = reader.text("distance");
    const Json& target = reader.get("target");
    if (!target.is_null()) trial.target = reader.position("target", target);
    for (const Json& distractor : reader.list("distractors"))
        trial.distractors.push_back(reader.position("distractors", distractor));
    if (declared.placed && target.is_null())
        reader.bad("target", target, fmt::format("a position [x, y, z] in a {}", declared.name));
    if (!declared.balls && !trial.distance.empty())
        reader.bad("distance", reader.get("distance"), "\"\" if no balls are shown");
    if (!declared.balls && !trial.distractors.empty())
        reader.bad("distractors", reader.get("distractors"), "none if no balls are shown");
    trial.ball_order = readBallOrder(reader, declared.balls ? trial.distractors.size() + 1 : 0);
    trial.check = readCheck(reader, trial);
    if (seen) trial.seen = readSeen(reader, trial);
    if (angles) trial.angles = readAngles(reader, trial.distractors.size());
    return trial;
}

StudyPlan readPlan(const Json& document) {
    const bool in_cell = document.is_object() && document.contains("number_in_cell");
    const std::size_t keys = in_cell ? 9 : 8;
    const Reader reader(document, "", keys);
    StudyPlan plan;
    plan.participant = reader.text("participant");
    if (!validParticipant(plan.participant))
        reader.bad("participant", reader.get("participant"), "a participant's id");
    plan.number = reader.whole("number", 1, max);
    if (in_cell) plan.number_in_cell = reader.whole("number_in_cell", 1, max);
    plan.study_name = reader.text("study");
    plan.study_hash = reader.text("study_hash");
    plan.seed = reader.count("seed");
    const Json& groups = reader.get("groups");
    if (!groups.is_object()) reader.bad("groups", groups, "an object");
    for (const auto& group : groups.items()) plan.groups[group.key()] = reader.text("groups", group.value());
    for (const Json& stage : reader.list("stages")) plan.stages.push_back(reader.text("stages", stage));
    for (const Json& trial : reader.list("trials"))
        plan.trials.push_back(readTrial(trial, plan.trials.size(), plan.stages));
    return plan;
}

}  // namespace

Result<StudyPlan> planFromJson(std::string_view json) {
    try {
        return readPlan(Json::parse(json));
    } catch (const BadPlan& bad) {
        return fail(bad.where.empty() ? "plan" : "plan: " + bad.where, bad.what());
    } catch (const Json::parse_error& error) {
        return fail("plan", fmt::format("this is not valid JSON (at byte {})", error.byte));
    } catch (const Json::exception& error) {
        return fail("plan", fmt::format("this JSON cannot be read: {}", error.what()));
    }
}

}  // namespace deixis::studies
