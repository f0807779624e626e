// The plan as JSON and as a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "studies/plan.hpp"

namespace deixis::studies {

namespace {

using Json = nlohmann::ordered_json;

/// Carries an error out of the readers below; never leaves this file.
struct BadPlan : std::runtime_error {
    BadPlan(std::string where_, const std::string& message)
        : std::runtime_error(message), where(std::move(where_)) {}
    std::string where;
};

Json positionJson(const Vec3& position) {
    return Json::array({position.x, position.y, position.z});
}

Json trialJson(const Trial& trial) {
    Json distractors = Json::array();
    for (const Vec3& distractor : trial.distractors) distractors.push_back(positionJson(distractor));
    return {{"index", trial.index},
            {"stage", stageName(trial.stage)},
            {"practice", trial.practice},
            {"system", trial.system},
            {"target_id", trial.target_id},
            {"layout", trial.layout},
            {"target", positionJson(trial.target)},
            {"distractors", distractors},
            {"ball_order", trial.ball_order}};
}

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
    [[nodiscard]] std::string text(const char* key) const {
        const Json& json = get(key);
        if (!json.is_string()) bad(key, json, "a text");
        return json.get<std::string>();
    }
    [[nodiscard]] bool boolean(const char* key) const {
        const Json& json = get(key);
        if (!json.is_boolean()) bad(key, json, "true or false");
        return json.get<bool>();
    }
    [[nodiscard]] std::uint64_t count(const char* key) const {
        const Json& json = get(key);
        if (!json.is_number_unsigned()) bad(key, json, "a whole number from 0 up");
        return json.get<std::uint64_t>();
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
    [[noreturn]] void bad(const char* key, const Json& found, const char* expected) const {
        std::string shown = found.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (shown.size() > 60) shown = found.type_name();
        throw BadPlan(name(key), fmt::format("found {}, expected {}", shown, expected));
    }

  private:
    [[nodiscard]] std::string name(std::string_view key) const {
        if (where_.empty() || key.empty()) return where_ + std::string(key);
        return fmt::format("{}.{}", where_, key);
    }

    const Json& json_;
    std::string where_;
};

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

Trial readTrial(const Json& json, std::size_t index) {
    constexpr std::size_t keys = 9;
    const Reader reader(json, fmt::format("trials[{}]", index), keys);
    Trial trial;
    if (reader.count("index") != index)
        reader.bad("index", reader.get("index"), "the trials in order from 0");
    trial.index = static_cast<int>(index);
    const std::string stage = reader.text("stage");
    if (stage != stageName(StageKind::naturalness) && stage != stageName(StageKind::game))
        reader.bad("stage", reader.get("stage"), "\"naturalness\" or \"game\"");
    trial.stage = stage == stageName(StageKind::game) ? StageKind::game : StageKind::naturalness;
    trial.practice = reader.boolean("practice");
    trial.system = reader.text("system");
    trial.target_id = reader.text("target_id");
    trial.layout = reader.text("layout");
    trial.target = reader.position("target", reader.get("target"));
    for (const Json& distractor : reader.list("distractors"))
        trial.distractors.push_back(reader.position("distractors", distractor));
    const bool game = trial.stage == StageKind::game;
    if (!game && !trial.distractors.empty())
        reader.bad("distractors", reader.get("distractors"), "none in the naturalness stage");
    trial.ball_order = readBallOrder(reader, game ? trial.distractors.size() + 1 : 0);
    return trial;
}

}  // namespace

std::string planJson(const StudyPlan& plan) {
    std::string out = fmt::format(
        "{{\n  \"participant\": {},\n  \"study\": {},\n  \"study_hash\": {},\n  \"seed\": {},\n  \"trials\": "
        "[",
        Json(plan.participant).dump(), Json(plan.study_name).dump(), Json(plan.study_hash).dump(), plan.seed);
    const char* separator = "\n    ";
    for (const Trial& trial : plan.trials) {  // a line each
        out += separator + trialJson(trial).dump();
        separator = ",\n    ";
    }
    return out + "\n  ]\n}\n";
}

Result<StudyPlan> planFromJson(std::string_view json) {
    try {
        constexpr std::size_t keys = 5;
        const Json document = Json::parse(json);
        const Reader reader(document, "", keys);
        StudyPlan plan;
        plan.participant = reader.text("participant");
        if (!validParticipant(plan.participant))
            reader.bad("participant", reader.get("participant"), "a participant's id");
        plan.study_name = reader.text("study");
        plan.study_hash = reader.text("study_hash");
        plan.seed = reader.count("seed");
        for (const Json& trial : reader.list("trials"))
            plan.trials.push_back(readTrial(trial, plan.trials.size()));
        return plan;
    } catch (const BadPlan& bad) {
        return fail(bad.where.empty() ? "plan" : "plan: " + bad.where, bad.what());
    } catch (const Json::parse_error& error) {
        return fail("plan", fmt::format("this is not valid JSON (at byte {})", error.byte));
    } catch (const Json::exception& error) {
        return fail("plan", fmt::format("this JSON cannot be read: {}", error.what()));
    }
}

std::string planTable(const StudyPlan& plan) {
    std::size_t system_width = 6;
    std::size_t layout_width = 6;
    for (const Trial& trial : plan.trials) {
        system_width = std::max(system_width, trial.system.size());
        layout_width = std::max(layout_width, trial.layout.size());
    }
    std::string out =
        fmt::format("participant {}, study {}, seed {}\n", plan.participant, plan.study_name, plan.seed);
    out += fmt::format("{:>5}  {:<11}  {:<8}  {:<{}}  {:<6}  {:<{}}  {}\n", "trial", "stage", "kind",
                       "system", system_width, "target", "layout", layout_width, "target shown as");
    for (const Trial& trial : plan.trials) {
        const int place = trial.targetPlace();
        const std::string shown =
            place < 0 ? "-" : fmt::format("ball {} of {}", place + 1, trial.ball_order.size());
        out += fmt::format("{:>5}  {:<11}  {:<8}  {:<{}}  {:<6}  {:<{}}  {}\n", trial.index,
                           stageName(trial.stage), trial.practice ? "practice" : "scored", trial.system,
                           system_width, trial.target_id, trial.layout, layout_width, shown);
    }
    return out;
}

}  // namespace deixis::studies
