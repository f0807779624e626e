// Participants' paired differences.
#include <fmt/core.h>

#include "figures.hpp"
#include "results/page/figure_differences.hpp"

namespace deixis::results {

namespace {

std::vector<DifferencePlot::Row> comparedRows(const AnalysisResult& result, const Measure& measure) {
    std::vector<DifferencePlot::Row> rows;
    for (const Comparison& pair : result.pairwise)
        if (pair.measure == measure.name && !pair.differences.empty())
            rows.push_back({pair.a, pair.b, pair.differences, pair.test.hodges_lehmann,
                            pair.p_holm.value_or(1.0), pair.significant});
    return rows;
}

}  // namespace

Figure differencesFigure(const AnalysisResult& result, std::size_t index, Numbering& figures) {
    const Measure& measure = result.measures[index];
    const bool accuracy = measure.kind == MeasureKind::accuracy;
    DifferencePlot plot;
    plot.rows = comparedRows(result, measure);
    const std::string unit = accuracy               ? "percentage points"
                             : measure.unit.empty() ? "points of the scale"
                                                    : measure.unit;
    plot.axis = {{"title", "difference, " + unit},
                 {"labelExpr", accuracy ? "format(100 * datum.value, '.0f')" : "datum.label"}};
    plot.text = [&](double value) { return scoreText(measure, value); };
    return {
        fmt::format("differences-{}", index + 1),
        fmt::format("{} {}: each participant's difference (points) and their shift with its interval "
                    "(Hodges–Lehmann; filled and starred if it is significant after Holm's "
                    "correction). To the right of 0, the system named first is higher.",
                    figures.next(), escapeHtml(capitalised(measure.name))),
        fmt::format("Participants' differences in {} between the systems of each pair, with the shift and "
                    "its interval.{}",
                    measure.name, shiftsText(plot)),
        differencesSpec(plot)};
}

Section differencesSection(const AnalysisResult& result, Numbering& figures) {
    if (result.participants < 2) return {};
    std::string out;
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        if (!comparedRows(result, result.measures[i]).empty())
            out += figureHtml(differencesFigure(result, i, figures));
    return {"Paired differences", figuresPlaced(out)};
}

}  // namespace deixis::results
