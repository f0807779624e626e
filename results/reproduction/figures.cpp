#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "paper_figures.hpp"
#include "results/page/accuracy_boxes.hpp"

namespace deixis::results {

namespace {

/// What stands for the paper in both figures: no line, which is a box plot's median.
FigureJson paperMark() {
    return {{"type", "point"}, {"shape", "cross"},    {"size", 130},
            {"filled", true},  {"color", ink_colour}, {"opacity", 1}};
}

FigureJson xyEncoding() {
    return {{"x", quantity("x")}, {"y", quantity("y")}, {"tooltip", {{"field", "tip"}}}};
}

}  // namespace

Figure accuracyBesidePaper(const GridFigures& grid, const std::string& name, Numbering& figures) {
    std::vector<BoxPlot::Box> boxes;
    FigureJson paper = FigureJson::array();
    for (const GridFigures::System& one : grid.systems) {
        if (const PaperSystem* found = paperSystem(one.system); found != nullptr && found->equation_2)
            paper.push_back(
                {{"x", boxes.size()},
                 {"y", *found->equation_2},
                 {"tip", fmt::format("{} in the paper: mean {:.2f}", found->name, *found->equation_2)}});
        boxes.push_back({one.system, one.accuracies});
    }
    const BoxPlot plot = accuracyBoxPlot(std::move(boxes));
    FigureJson spec = boxPlotSpec(plot);
    spec["layer"].push_back(layerOf(std::move(paper), paperMark(), xyEncoding()));
    return {name,
            figures.next() +
                fmt::format(" Accuracy at {} points, {} (the paper’s Figure\u00A09). Crosses: the means "
                            "that the paper prints. Diamonds: our means. Right: the same as angle.",
                            grid.points, escapeHtml(grid.grid)),
            "Accuracy by system. Medians: " + mediansText(plot), std::move(spec), true};
}

Figure studyBesidePaper(const ReproductionInput& input, const std::string& measure, Numbering& figures) {
    const bool accuracy = measure == "accuracy";
    std::vector<std::vector<std::string>> names;
    FigureJson paper = FigureJson::array(), points = FigureJson::array();
    std::string label;
    for (const PaperSystem& one : paper_systems) {
        const auto value = accuracy ? one.accuracy : one.naturalness;
        if (!value) continue;
        const double x = static_cast<double>(names.size());
        const std::string system(one.system);
        names.push_back(brokenName(system));
        paper.push_back(
            {{"x", x}, {"y", *value}, {"tip", fmt::format("{} in the paper: {:g}", one.name, *value)}});
        label += fmt::format(" {}: paper {:g}", system, *value);
        for (std::size_t k = 0; k < input.studies.size(); ++k) {
            const StudyFigures& study = input.studies[k];
            const double aside =
                0.18 * (static_cast<double>(k) - 0.5 * (static_cast<double>(input.studies.size()) - 1.0));
            for (const StudyFigures::Score& score : study.scores) {
                if (score.measure != measure || score.system != system) continue;
                points.push_back(
                    {{"x", x + aside},
                     {"y", score.mean},
                     {"low", score.lower.value_or(score.mean)},
                     {"high", score.upper.value_or(score.mean)},
                     {"kind", study.participants_kind},
                     {"tip", fmt::format("{}, {}: {:.3g}", system, study.participants_kind, score.mean)}});
                label += fmt::format(", {} {:.3g}", study.participants_kind, score.mean);
            }
        }
        label += ".";
    }
    FigureJson kinds = FigureJson::array(), colours = FigureJson::array();
    for (std::size_t k = 0; k < input.studies.size(); ++k) {
        kinds.push_back(input.studies[k].participants_kind);
        colours.push_back(systemColour(k));
    }
    const FigureJson colour = {{"field", "kind"},
                               {"type", "nominal"},
                               {"scale", {{"domain", kinds}, {"range", colours}}},
                               {"legend", {{"title", nullptr}, {"orient", "bottom"}}}};
    FigureJson x = quantity("x");
    x["scale"] = {
        {"domain", {-0.5, static_cast<double>(names.size()) - 0.5}}, {"nice", false}, {"zero", false}};
    x["axis"] = nameAxis(names);
    FigureJson y = quantity("y");
    y["scale"] = {
        {"domain", accuracy ? FigureJson{0.0, 1.0} : FigureJson{1.0, 5.0}}, {"nice", false}, {"zero", false}};
    y["axis"] = accuracy ? FigureJson{{"title", "right choices"}, {"format", ".0%"}}
                         : FigureJson{{"title", "naturalness"}, {"tickCount", 5}};
    FigureJson rule = {
        {"x", quantity("x")}, {"y", quantity("low")}, {"y2", {{"field", "high"}}}, {"color", colour}};
    FigureJson mark = xyEncoding();
    mark["color"] = colour;
    FigureJson first = xyEncoding();
    first["x"] = std::move(x);
    first["y"] = std::move(y);
    FigureJson layers = FigureJson::array();
    layers.push_back(layerOf(std::move(paper), paperMark(), std::move(first)));
    layers.push_back(layerOf(points, {{"type", "rule"}, {"strokeWidth", 1.5}}, std::move(rule)));
    layers.push_back(layerOf(std::move(points),
                             {{"type", "point"}, {"filled", true}, {"size", 70}, {"opacity", 1}},
                             std::move(mark)));
    return {"study-" + measure,
            figures.next() +
                (accuracy ? " Right choices (the paper’s Figure\u00A07)."
                          : " Naturalness (the paper’s Figure\u00A07).") +
                " Crosses: the paper’s means. Points: ours, with their intervals.",
            label.empty() ? "Nothing." : label.substr(1),
            {{"height", 300}, {"layer", std::move(layers)}}};
}

Figure accuracyAndImitation(const ReproductionInput& input, Numbering& figures) {
    const GridFigures& grid = input.grids.front();
    FigureJson points = FigureJson::array();
    std::string label;
    for (const TrainedSystem& trained : input.trained) {
        const auto found = std::ranges::find_if(
            grid.systems, [&](const GridFigures::System& one) { return one.system == trained.system; });
        if (found == grid.systems.end() || !found->mean || !trained.arm_error_m) continue;
        const double arm_cm = 100.0 * *trained.arm_error_m;
        points.push_back(
            {{"x", rounded(arm_cm)},
             {"y", rounded(*found->mean)},
             {"name", trained.system},
             {"tip", fmt::format("{}: {:.3f}, {:.1f} cm", trained.system, *found->mean, arm_cm)}});
        label += fmt::format(" {}: {:.3f} at {:.1f} cm.", trained.system, *found->mean, arm_cm);
    }
    FigureJson at = xyEncoding();
    at["x"]["axis"] = {{"title", "arm beside the demonstration's, cm"}};
    at["x"]["scale"] = {{"zero", false}, {"padding", 40}};
    at["y"]["axis"] = {{"title", "accuracy (Eq. 2)"}, {"format", ".2f"}};
    at["y"]["scale"] = {{"zero", false}, {"padding", 16}};
    FigureJson named = at;
    named["text"] = {{"field", "name"}};
    FigureJson layers = FigureJson::array();
    layers.push_back(layerOf(
        points,
        {{"type", "point"}, {"filled", true}, {"size", 70}, {"color", systemColour(0)}, {"opacity", 1}},
        std::move(at)));
    layers.push_back(layerOf(std::move(points),
                             {{"type", "text"}, {"dy", -10}, {"fontSize", 11}, {"color", ink_colour}},
                             std::move(named)));
    return {"imitation",
            figures.next() +
                fmt::format(
                    " Accuracy on the {} against how far the arm is from where the demonstrations have it, "
                    "at held-out targets. Their forearms do not point at these; eye and fingertip do.",
                    escapeHtml(grid.grid)),
            label.empty() ? "Nothing." : label.substr(1),
            {{"height", 340}, {"layer", std::move(layers)}}};
}

}  // namespace deixis::results
