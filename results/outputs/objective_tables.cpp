// Tables of answers beside the objective evaluation.
#include <map>

#include "results/outputs/analysis_tables.hpp"
#include "test_fields.hpp"

namespace deixis::results::tables {

namespace {

struct SystemMeans {
    std::string measure;
    std::string system;
    double objective = 0.0;
    double answers = 0.0;
};

}  // namespace

Table objectiveMeans(const AnalysisResult& result) {
    std::vector<SystemMeans> rows;
    if (result.options.objective)
        for (std::size_t m = 0; m < result.measures.size(); ++m)
            for (const SystemResult& system : result.systems) {
                const auto& evaluated = result.options.objective->systems;
                const auto found = evaluated.find(system.system);
                if (found != evaluated.end() && system.measures[m].n > 0)
                    rows.push_back(
                        {result.measures[m].name, system.system, found->second, system.measures[m].mean});
            }
    return withScales(
        tableOf<SystemMeans>("objective_means", units::means, "Systems by Equation 2 and by answers",
                             {{"measure", &SystemMeans::measure, {.heading = true}},
                              {"system", &SystemMeans::system},
                              {"equation_2",
                               &SystemMeans::objective,
                               {.label = "Equation 2", .format = Format::three_decimals}},
                              {"mean", &SystemMeans::answers, {.label = "Mean answer"}}},
                             rows),
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
        result.objective);
}

}  // namespace deixis::results::tables
