#include "analysis_json_groups.hpp"

#include "json_values.hpp"

namespace deixis::results {

namespace {

using GroupJson = nlohmann::ordered_json;

void addGroupTest(GroupJson& out, const GroupTest& one, double alpha) {
    const RankSumTest& test = one.test;
    const HodgesLehmann& shift = test.hodges_lehmann;
    out["n_a"] = test.n_a;
    out["n_b"] = test.n_b;
    out["mean_a"] = numberOrNull(test.n_a > 0, one.mean_a);
    out["mean_b"] = numberOrNull(test.n_b > 0, one.mean_b);
    out["u"] = numberOrNull(test.p_two_sided.has_value(), test.u);
    out["ties"] = test.ties;
    out["z"] = numberOrNull(test.z);
    out["p"] = numberOrNull(test.p_two_sided);
    out["p_holm"] = numberOrNull(one.p_holm);
    out["significant"] = one.significant;
    out["method"] = test.method;
    out["family"] = one.family;
    out["family_size"] = one.family_size;
    out["alpha"] = alpha;
    out["p_normal"] = numberOrNull(test.normal_p_two_sided);
    out["a12"] = numberOrNull(test.a12);
    out["cliffs_delta"] = numberOrNull(test.cliffs_delta);
    out["hodges_lehmann"] = {
        {"estimate", numberOrNull(shift.estimate)}, {"lower", numberOrNull(shift.lower)},
        {"upper", numberOrNull(shift.upper)},       {"lower_included", shift.lower_included},
        {"upper_included", shift.upper_included},   {"level", numberOrNull(shift.level)}};
    if (one.equivalence) out["equivalence"] = equivalenceJson(*one.equivalence);
}

GroupJson answersJson(const PreferenceCounts& counts) {
    const auto share = [&](int of) { return numberOrNull(counts.share(of)); };
    return {{"n", counts.answers()},
            {"wins", share(counts.wins)},
            {"ties", share(counts.ties)},
            {"losses", share(counts.losses)}};
}

}  // namespace

GroupJson equivalenceJson(const Equivalence& one) {
    return {{"bound", one.bound}, {"p", one.p}, {"p_holm", one.p_holm}, {"equivalent", one.equivalent}};
}

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
