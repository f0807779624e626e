// The plan as JSON: writing.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/design/plan.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

using Json = nlohmann::ordered_json;

Json positionJson(const Vec3& position) {
    return Json::array({position.x, position.y, position.z});
}

Json checkJson(const TrialCheck& check) {
    return {{"kind", checkKindName(check.kind)},
            {"stimulus", check.stimulus},
            {"expected", check.expected},
            {"of_trial", check.of_trial}};
}

Json seenJson(const std::vector<SeenBalls>& seen) {
    Json out = Json::object();
    for (const SeenBalls& one : seen)
        out[std::string(standingName(one.standing))] = {{"at_rest", one.at_rest}, {"pointing", one.pointing}};
    return out;
}

Json anglesObject(const BallAngles& angles) {
    return {{"avatar", angles.avatar_deg}, {"headset", angles.headset_deg}, {"desktop", angles.desktop_deg}};
}

Json trialJson(const Trial& trial) {
    Json stimuli = Json::array();
    for (const Stimulus& stimulus : trial.stimuli) {
        Json& one = stimuli.emplace_back(Json{{"system", stimulus.system}, {"item", stimulus.item}});
        if (stimulus.clip > 0) one["clip"] = stimulus.clip;
    }
    Json distractors = Json::array();
    for (const Vec3& distractor : trial.distractors) distractors.push_back(positionJson(distractor));
    Json out = {{"index", trial.index},
                {"stage", trial.stage},
                {"kind", stageKindName(trial.kind)},
                {"practice", trial.practice},
                {"attempt", trial.attempt},
                {"page", trial.page},
                {"stimuli", stimuli},
                {"layout", trial.layout},
                {"distance", trial.distance},
                {"target", trial.target == Vec3(0.0) ? Json() : positionJson(trial.target)},
                {"distractors", distractors},
                {"ball_order", trial.ball_order},
                {"check", trial.check ? checkJson(*trial.check) : Json()}};
    if (!trial.seen.empty()) out["visibility"] = seenJson(trial.seen);
    if (trial.angles) out["angles"] = anglesObject(*trial.angles);
    return out;
}

}  // namespace

std::string planJson(const StudyPlan& plan) {
    std::string out = fmt::format(
        "{{\n  \"participant\": {},\n  \"number\": {},{}\n  \"study\": {},\n  \"study_hash\": {},\n  "
        "\"seed\": "
        "{},\n  \"groups\": {},\n  \"stages\": {},\n  \"trials\": [",
        Json(plan.participant).dump(), plan.number,
        plan.number_in_cell ? fmt::format("\n  \"number_in_cell\": {},", *plan.number_in_cell) : "",
        Json(plan.study_name).dump(), Json(plan.study_hash).dump(), plan.seed, Json(plan.groups).dump(),
        Json(plan.stages).dump());
    const char* separator = "\n    ";
    for (const Trial& trial : plan.trials) {  // a line each
        out += separator + trialJson(trial).dump();
        separator = ",\n    ";
    }
    return out + "\n  ]\n}\n";
}

std::string visibilityJson(const Trial& trial) {
    return trial.seen.empty() ? std::string() : seenJson(trial.seen).dump();
}

std::string anglesJson(const Trial& trial) {
    return trial.angles ? anglesObject(*trial.angles).dump() : std::string();
}

}  // namespace deixis::studies
