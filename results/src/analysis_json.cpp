#include <nlohmann/json.hpp>

#include "results/analysis.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(bool known, double value) {
    return known ? Json(value) : Json();
}

Json summaryJson(const Summary& summary) {
    const std::size_t participants = summary.by_participant.size();
    return {{"mean", orNull(summary.n > 0, summary.mean)},
            {"sd_participants", orNull(participants > 1, summary.sd_participants)},
            {"sd_trials", orNull(summary.n > 1, summary.sd_trials)},
            {"n", summary.n}};
}

void addTest(Json& out, const SignedRankTest& test, double p_holm, bool significant) {
    out["n"] = test.n_pairs;
    out["n_zero"] = test.n_zero;
    out["w_plus"] = test.w_plus;
    out["w_minus"] = test.w_minus;
    out["p"] = test.p_two_sided;
    out["p_holm"] = p_holm;
    out["significant"] = significant;
    out["method"] = test.method;
}

Json comparisonJson(const Comparison& comparison) {
    Json out;
    out["measure"] = comparison.measure;
    if (!comparison.factor.empty()) out["factor"] = comparison.factor;
    if (!comparison.system.empty()) out["system"] = comparison.system;
    out["a"] = comparison.a;
    out["b"] = comparison.b;
    out["mean_difference"] = orNull(comparison.test.n_pairs > 0, comparison.mean_difference);
    addTest(out, comparison.test, comparison.p_holm, comparison.significant);
    return out;
}

Json levelsJson(const AnalysisResult& result, const std::string& factor) {
    Json out = Json::array();
    for (const auto& row : result.levels)
        if (row.factor == factor)
            out.push_back({{"measure", row.measure},
                           {"system", row.system},
                           {factor, row.level},
                           {"mean", orNull(row.n > 0, row.mean)},
                           {"sd_trials", orNull(row.n > 1, row.sd_trials)},
                           {"n", row.n}});
    return out;
}

Json levelTestsJson(const AnalysisResult& result, const std::string& factor) {
    Json out = Json::array();
    for (const auto& comparison : result.level_tests)
        if (comparison.factor == factor) out.push_back(comparisonJson(comparison));
    return out;
}

Json preferencesJson(const AnalysisResult& result) {
    Json out = Json::array();
    for (const auto& pair : result.preferences) {
        Json row{{"a", pair.a},
                 {"b", pair.b},
                 {"prefers_a", pair.prefers_a},
                 {"ties", pair.ties},
                 {"prefers_b", pair.prefers_b},
                 {"mean", pair.mean}};
        addTest(row, pair.test, pair.p_holm, pair.significant);
        out.push_back(std::move(row));
    }
    return out;
}

const char* kindName(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::accuracy:
            return "accuracy";
        case MeasureKind::rating:
            return "rating";
        case MeasureKind::preference:
            return "preference";
    }
    return "";
}

}  // namespace

std::string analysisJson(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    Json out;
    out["program"] = {{"name", "deixis"}, {"recorded_by", table.program_versions}};
    out["study"] = {{"name", table.study_name},
                    {"title", table.study_title},
                    {"hash", table.study_hash},
                    {"planned_participants", table.planned_participants}};
    out["measures"] = Json::array();
    for (const auto& measure : table.measures)
        out["measures"].push_back({{"measure", measure.name},
                                   {"kind", kindName(measure.kind)},
                                   {"low", measure.low},
                                   {"high", measure.high},
                                   {"planned", measure.planned}});
    out["participants"] = result.participants;
    out["synthetic"] = result.synthetic;
    out["alpha"] = table.alpha;
    out["systems"] = Json::array();
    for (const auto& system : result.systems) {
        Json row{{"system", system.system}};
        for (std::size_t i = 0; i < result.measures.size(); ++i)
            row[result.measures[i].name] = summaryJson(system.measures[i]);
        out["systems"].push_back(std::move(row));
    }
    out["layouts"] = levelsJson(result, "layout");
    out["distances"] = levelsJson(result, "distance");
    out["pairwise"] = Json::array();
    for (const auto& comparison : result.pairwise) out["pairwise"].push_back(comparisonJson(comparison));
    out["layout_tests"] = levelTestsJson(result, "layout");
    out["distance_tests"] = levelTestsJson(result, "distance");
    out["preferences"] = preferencesJson(result);
    out["scores"] = Json::array();
    for (const auto& score : result.scores)
        out["scores"].push_back({{"stage", score.stage},
                                 {"score", score.score},
                                 {"mean", score.mean},
                                 {"sd", orNull(score.n > 1, score.sd)},
                                 {"n", score.n}});
    out["checks"] = Json::array();
    for (const auto& check : table.checks)
        out["checks"].push_back({{"stage", check.stage},
                                 {"kind", check.kind},
                                 {"passed", check.passed},
                                 {"failed", check.failed}});
    out["left_out"] = Json::array();
    for (const auto& one : table.left_out)
        out["left_out"].push_back({{"participant", one.participant},
                                   {"why", one.dropped ? "dropped" : "excluded"},
                                   {"reason", one.reason}});
    out["withdrawn"] = table.withdrawn;
    out["remarks"] = result.remarks;
    // Text from a study file may hold bytes that are no UTF-8.
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace deixis::results
