#include "results/outputs/analysis_json_groups.hpp"

#include "analysis_json_tests.hpp"
#include "results/tables/json_values.hpp"

namespace deixis::results {

namespace {

using GroupJson = nlohmann::ordered_json;

GroupJson answersJson(const PreferenceCounts& counts) {
    const auto share = [&](int of) { return numberOrNull(counts.share(of)); };
    return {{"n", counts.answers()},
            {"wins", share(counts.wins)},
            {"ties", share(counts.ties)},
            {"losses", share(counts.losses)}};
}

}  // namespace

GroupJson groupInteractionsJson(const AnalysisResult& result) {
    GroupJson out = GroupJson::array();
    for (const GroupInteractionResult& one : result.group_interactions) {
        GroupJson row{{"measure", one.measure},           {"factor", one.factor}, {"a", one.a}, {"b", one.b},
                      {"other_factor", one.other_factor}, {"c", one.c},           {"d", one.d}};
        addGroupTest(row, one, result.alpha);
        out.push_back(std::move(row));
    }
    return out;
}

GroupJson scoreGroupsJson(const AnalysisResult& result) {
    GroupJson out = GroupJson::array();
    for (const ScoreGroupResult& one : result.score_groups) {
        GroupJson row{
            {"stage", one.stage}, {"score", one.score}, {"factor", one.factor}, {"a", one.a}, {"b", one.b}};
        addGroupTest(row, one, result.alpha);
        out.push_back(std::move(row));
    }
    return out;
}

GroupJson timeGroupsJson(const AnalysisResult& result) {
    GroupJson out = GroupJson::array();
    for (const BetweenResult& one : result.time_groups) {
        GroupJson row{{"measure", one.measure}, {"factor", one.factor}, {"a", one.a}, {"b", one.b}};
        addGroupTest(row, one, result.alpha);
        out.push_back(std::move(row));
    }
    return out;
}

GroupJson betweenJson(const AnalysisResult& result) {
    GroupJson out = GroupJson::array();
    for (const BetweenResult& one : result.between) {
        GroupJson row{{"measure", one.measure},
                      {"factor", one.factor},
                      {"system", one.system},
                      {"a", one.a},
                      {"b", one.b}};
        addGroupTest(row, one, result.alpha);
        out.push_back(std::move(row));
    }
    return out;
}

GroupJson preferencesBetweenJson(const AnalysisResult& result) {
    GroupJson out = GroupJson::array();
    for (const PreferenceBetweenResult& one : result.preferences_between) {
        GroupJson row{{"factor", one.factor},
                      {"system", one.system},
                      {"other_system", one.other_system},
                      {"a", one.a},
                      {"b", one.b},
                      {"answers_a", answersJson(one.answers_a)},
                      {"answers_b", answersJson(one.answers_b)}};
        addGroupTest(row, one, result.alpha);
        out.push_back(std::move(row));
    }
    return out;
}

}  // namespace deixis::results
