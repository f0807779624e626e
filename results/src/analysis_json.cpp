#include <nlohmann/json.hpp>

#include "results/analysis.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(bool known, double value) {
    return known ? Json(value) : Json();
}

Json summaryJson(const Summary& summary, std::size_t participants) {
    return {{"mean", orNull(summary.n > 0, summary.mean)},
            {"sd_participants", orNull(participants > 1, summary.sd_participants)},
            {"sd_trials", orNull(summary.n > 1, summary.sd_trials)},
            {"n", summary.n}};
}

Json comparisonJson(const Comparison& comparison) {
    Json out;
    out["measure"] = comparison.measure;
    if (!comparison.system.empty()) out["system"] = comparison.system;
    out["a"] = comparison.a;
    out["b"] = comparison.b;
    out["mean_difference"] = orNull(comparison.test.n > 0, comparison.mean_difference);
    out["n"] = comparison.test.n;
    out["n_zero"] = comparison.test.n_zero;
    out["w_plus"] = comparison.test.w_plus;
    out["w_minus"] = comparison.test.w_minus;
    out["p"] = comparison.test.p;
    out["p_holm"] = comparison.p_holm;
    out["significant"] = comparison.significant;
    out["method"] = comparison.test.method;
    return out;
}

}  // namespace

std::string analysisJson(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    Json out;
    out["program"] = {{"name", "deixis"}, {"recorded_by", table.program_versions}};
    out["study"] = {{"name", table.study_name},
                    {"title", table.study_title},
                    {"hash", table.study_hash},
                    {"planned_participants", table.planned_participants},
                    {"planned_ratings", table.planned_ratings},
                    {"planned_choices", table.planned_choices}};
    out["participants"] = result.participants;
    out["synthetic"] = result.synthetic;
    out["alpha"] = table.alpha;
    out["systems"] = Json::array();
    for (const auto& system : result.systems)
        out["systems"].push_back(
            {{"system", system.system},
             {"accuracy", summaryJson(system.accuracy, system.accuracy_by_participant.size())},
             {"naturalness", summaryJson(system.naturalness, system.naturalness_by_participant.size())}});
    out["layouts"] = Json::array();
    for (const auto& row : result.layouts)
        out["layouts"].push_back({{"system", row.system},
                                  {"layout", row.layout},
                                  {"mean", orNull(row.n > 0, row.mean)},
                                  {"sd_trials", orNull(row.n > 1, row.sd_trials)},
                                  {"n", row.n}});
    out["pairwise"] = Json::array();
    for (const auto& comparison : result.pairwise) out["pairwise"].push_back(comparisonJson(comparison));
    out["layout_tests"] = Json::array();
    for (const auto& comparison : result.layout_tests)
        out["layout_tests"].push_back(comparisonJson(comparison));
    out["remarks"] = result.remarks;
    // Text from a study file may hold bytes that are no UTF-8.
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace deixis::results
