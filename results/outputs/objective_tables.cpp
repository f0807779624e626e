// Tables of answers beside the objective evaluation.
#include "results/outputs/analysis_tables.hpp"
#include "test_fields.hpp"

namespace deixis::results::tables {

Table objectiveMeans(const AnalysisResult& result) {
    using Row = ObjectiveMean;
    return withScales(
        tableOf<Row>(
            "objective_means", units::means, "Systems by Equation 2 and by answers",
            {{"measure", &Row::measure, {.heading = true}},
             {"system", &Row::system},
             {"equation_2", &Row::equation_2, {.label = "Equation 2", .format = Format::three_decimals}},
             {"mean", &Row::answers, {.label = "Mean answer"}}},
            result.objective.means),
        result);
}

Table objectiveCorrelations(const AnalysisResult& result) {
    using Row = ObjectiveCorrelation;
    const auto defined = [](auto read) {
        return [=](const Row& one) { return known(one.test.method != "undefined", read(one.test)); };
    };
    return tableOf<Row>(
        "objective_correlations", units::targets,
        "Rank correlations (Spearman) of mean answers with Equation 2",
        {{"measure", &Row::measure, {.heading = true}},
         {"over", &Row::over, {.label = "Over"}},
         {"system", &Row::system},
         {"n", [](auto& one) { return one.test.n; }},
         {"rho", defined([](auto& test) { return test.rho; }), {.label = "\u03c1", .latex = "$\\rho$"}},
         {"p", defined([](auto& test) { return test.p; })},
         {"method", [](auto& one) { return one.test.method; }}},
        result.objective.correlations);
}

}  // namespace deixis::results::tables
