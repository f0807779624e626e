// Participants' means as box plots, as in Deichler et al. 2023, Figure 7, and Yoon et al. 2021, Figure 7.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "results/analysis/several_studies.hpp"
#include "results/page/figure_boxes.hpp"
#include "studies.hpp"

namespace deixis::results {

namespace {

constexpr std::size_t max_brackets = 15;

std::size_t placeOf(const AnalysisResult& result, const std::string& system) {
    return static_cast<std::size_t>(
        std::find(result.table.systems.begin(), result.table.systems.end(), system) -
        result.table.systems.begin());
}

std::vector<BoxPlot::Pair> differingPairs(const AnalysisResult& result, const std::string& measure) {
    std::vector<BoxPlot::Pair> pairs;
    for (const Comparison& pair : result.pairwise)
        if (pair.measure == measure && pair.significant)
            pairs.push_back({placeOf(result, pair.a), placeOf(result, pair.b), *pair.p_holm});
    return pairs;
}

/// Round numbers, at most some ten, and the scale's ends; of accuracy each fifth.
FigureJson scaleValues(const Measure& measure) {
    FigureJson values = FigureJson::array();
    if (measure.kind == MeasureKind::accuracy) {
        for (int fifth = 0; fifth <= 5; ++fifth) values.push_back(fifth / 5.0);
        return values;
    }
    const double range = measure.high - measure.low;
    const double max = range <= 10.0 ? 10.0 : 6.0;
    double every = 1.0;
    for (int i = 0; range / every > max; ++i) every *= i % 3 == 1 ? 2.5 : 2.0;  // 2, 5, 10, 20, 50, ...
    values.push_back(measure.low);
    for (double at = every * std::ceil(measure.low / every); at < measure.high; at += every)
        if (at - measure.low >= 0.5 * every && measure.high - at >= 0.5 * every) values.push_back(at);
    if (measure.high > measure.low) values.push_back(measure.high);
    return values;
}

}  // namespace

FigureJson scaleAxis(const Measure& measure) {
    if (measure.kind == MeasureKind::accuracy)
        return {{"values", scaleValues(measure)},
                {"title", "correct choices"},
                {"labelExpr", "format(100 * datum.value, '.0f') + '\u00a0%'"}};
    return {{"values", scaleValues(measure)},
            {"title", measure.unit.empty()
                          ? fmt::format("{} ({:g} to {:g})", measure.name, measure.low, measure.high)
                          : fmt::format("{} ({})", measure.name, measure.unit)},
            {"format", "~r"}};
}

namespace {

std::string boxLabel(const AnalysisResult& result, const BoxPlot& plot, const Measure& measure,
                     std::size_t differing) {
    std::string label = fmt::format("Box plots of the participants' means of {} by system; medians: {}.",
                                    measure.name, mediansText(plot));
    if (result.participants > 1 && result.systems.size() > 1)
        label += fmt::format(" {} of {} pairs of systems differ significantly.", differing,
                             result.systems.size() * (result.systems.size() - 1) / 2);
    return label;
}

}  // namespace

namespace {

/// Without boxes. `measure` is used as long as the plot is.
BoxPlot emptyPlot(const Measure& measure) {
    BoxPlot plot;
    plot.low = measure.low;
    plot.high = measure.high;
    plot.axis = scaleAxis(measure);
    plot.text = [&](double value) { return scoreText(measure, value); };
    plot.nothing = "no answers";
    if (measure.kind == MeasureKind::accuracy && measure.balls > 1 && measure.min_balls == measure.balls)
        plot.levels = {{1.0 / measure.balls, "chance"}};
    return plot;
}

std::string shownName(const Measure& measure) {
    return measure.kind == MeasureKind::accuracy ? std::string("Referential accuracy")
                                                 : escapeHtml(capitalised(measure.name));
}

std::string bracketsText(const AnalysisResult& result) {
    return fmt::format(
        " Brackets: pairs that differ at α\u00A0=\u00A0{} after Holm's correction (*\u00A0p\u00A0≤"
        "\u00A00.05, **\u00A0≤\u00A00.01, ***\u00A0≤\u00A00.001).",
        result.alpha);
}

}  // namespace

Figure boxPlot(const AnalysisResult& result, std::size_t index, Numbering& figures) {
    const Measure& measure = result.measures[index];
    BoxPlot plot = emptyPlot(measure);
    for (const SystemResult& system : result.systems)
        plot.boxes.push_back({system.system, system.measures[index].by_participant});
    plot.brackets = differingPairs(result, measure.name);
    const std::size_t differing = plot.brackets.size();
    if (differing > max_brackets) plot.brackets.clear();

    std::string caption = fmt::format("{} {}: participants' means.", figures.next(), shownName(measure));
    if (!plot.brackets.empty())
        caption += bracketsText(result);
    else if (differing > 0)
        caption +=
            fmt::format(" {} pairs of systems differ, too many for brackets: see the tests.", differing);
    return {fmt::format("means-{}", index + 1), std::move(caption),
            boxLabel(result, plot, measure, differing), boxPlotSpec(plot), result.systems.size() > 6};
}

Figure studyBoxPlot(const AnalysisResult& result, std::size_t index, Numbering& figures) {
    const Measure& measure = result.measures[index];
    BoxPlot plot = emptyPlot(measure);
    std::string label = fmt::format(
        "Box plots of the participants' means of {} by system, in each study and pooled; medians:",
        measure.name);
    bool too_many = false;
    const auto add = [&](const AnalysisResult& one, const std::string& name) {
        BoxPlot group = emptyPlot(measure);
        for (const SystemResult& system : one.systems)
            group.boxes.push_back({system.system, system.measures[index].by_participant});
        label += fmt::format(" {}: {}.", name, mediansText(group));
        const auto pairs = differingPairs(one, measure.name);
        too_many = too_many || pairs.size() > max_brackets;
        if (pairs.size() <= max_brackets)
            for (const BoxPlot::Pair& pair : pairs)
                plot.brackets.push_back({plot.boxes.size() + pair.a, plot.boxes.size() + pair.b, pair.p});
        plot.groups.push_back({name, group.boxes.size()});
        for (BoxPlot::Box& box : group.boxes) plot.boxes.push_back(std::move(box));
    };
    for (const AnalysisResult& study : result.by_study) add(study, study.table.study_name);
    add(result, pooled_studies);
    std::string caption = fmt::format(
        "{} {}: participants' means in each study and over all of them (pooled), as in Yoon et al. (2021), "
        "Figure 7.",
        figures.next(), shownName(measure));
    if (!plot.brackets.empty()) caption += bracketsText(result);
    if (too_many) caption += " If more pairs differ than there is room for brackets, see the tests.";
    return {fmt::format("means-{}", index + 1), std::move(caption), std::move(label), boxPlotSpec(plot),
            true};
}

}  // namespace deixis::results
