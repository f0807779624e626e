// Box plots, differences, profiles and scatter plots of the evaluation.
#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "results/page/accuracy_boxes.hpp"
#include "results/page/figure_differences.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

constexpr std::size_t max_difference_points = 100;
constexpr std::size_t max_scatter_points = 500;
constexpr double pairs_alpha = 0.05;

std::vector<BoxPlot::Box> boxesOf(const Evaluation& evaluation) {
    std::vector<BoxPlot::Box> out;
    for (const auto& system : evaluation.systems) out.push_back({system.system, system.rewards});
    return out;
}

FigureJson dashedLine(const char* axis, double at) {
    return {{"data", {{"values", {FigureJson::object()}}}},
            {"mark", {{"type", "rule"}, {"color", even_colour}, {"strokeDash", {5, 4}}}},
            {"encoding", {{axis, {{"datum", at}}}}}};
}

}  // namespace

Figure accuracyBoxes(const Evaluation& evaluation, Numbering& figures) {
    const BoxPlot plot = accuracyBoxPlot(boxesOf(evaluation));
    const bool thinned = std::ranges::any_of(
        plot.boxes, [&](const BoxPlot::Box& box) { return box.values.size() > plot.max_points; });
    return {"accuracy",
            figures.next() +
                " Accuracy of every clip (the paper’s Figure\u00A09). Box: quartiles, notched at the "
                "median if the notch lies within the box; diamond: mean; whiskers: 5th and 95th "
                "percentile. Right: the same as angle between "
                "forearm and target; dashed: the ceiling." +
                (thinned ? fmt::format(" Points: at most {} of a system’s clips, evenly from the "
                                       "smallest to the largest; everything else uses all clips.",
                                       plot.max_points)
                         : std::string()),
            fmt::format("Box plots of the clips' accuracy by system; medians: {}.", mediansText(plot)),
            boxPlotSpec(plot), evaluation.systems.size() > 4};
}

Figure accuracyDifferences(const Evaluation& evaluation, Numbering& figures) {
    DifferencePlot plot;
    bool thinned = false;
    for (const SystemComparison& pair : evaluation.comparisons) {
        if (pair.differences.empty()) continue;
        plot.rows.push_back({evaluation.systems[pair.a].system, evaluation.systems[pair.b].system,
                             pair.differences, pair.test.hodges_lehmann, pair.p_holm.value_or(1.0),
                             pair.p_holm.value_or(1.0) <= pairs_alpha});
        thinned = thinned || pair.differences.size() > max_difference_points;
    }
    plot.axis = {{"title", "difference of accuracy"}};
    plot.text = accuracyText;
    plot.max_points = max_difference_points;
    return {
        "differences",
        figures.next() +
            " Differences of accuracy at the targets that both systems have clips for (points), and the "
            "typical difference with its interval (Hodges–Lehmann; filled and starred if p is at most "
            "0.05 after Holm’s correction). To the right of 0, the system named first is more "
            "accurate." +
            (thinned ? fmt::format(" At most {} points per pair are drawn, evenly from the smallest to the "
                                   "largest difference.",
                                   max_difference_points)
                     : std::string()),
        "Differences of accuracy between the systems of each pair at their common targets, with the typical "
        "difference and its interval." +
            shiftsText(plot),
        differencesSpec(plot), evaluation.systems.size() > 4};
}

namespace {

struct ProfileValue {
    double low, mean, high;
};
ProfileValue profileAt(const ProfilePoint& point, ProfileKind kind) {
    const bool reward = kind == ProfileKind::reward;
    const double centre = reward ? point.reward_mean : point.speed_mean;
    const double sd = reward ? point.reward_sd : point.speed_sd;
    return {std::max(0.0, centre - sd), centre, centre + sd};
}

struct ProfileScale {
    double first_s = -0.5, last_s = 0.5;
    double high = 0.0;
};

/// By the longest and the widest band of all systems.
ProfileScale profileScale(const Evaluation& evaluation, ProfileKind kind) {
    ProfileScale scale;
    double highest = 1.0;
    for (const auto& system : evaluation.systems)
        for (const HandProfile* profile : {&system.left, &system.right})
            for (const ProfilePoint& point : profile->points) {
                scale.first_s = std::min(scale.first_s, point.time_s);
                scale.last_s = std::max(scale.last_s, point.time_s);
                highest = std::max(highest, profileAt(point, kind).high);
            }
    scale.high = kind == ProfileKind::reward ? 0.65 : std::ceil(highest / 0.5) * 0.5;
    return scale;
}

struct NamedHand {
    std::string name;
    const HandProfile* profile;
    const char* hand;
};

std::vector<NamedHand> handsOf(const SystemEvaluation& system) {
    std::vector<NamedHand> hands;
    for (const auto& [name, profile] : {std::pair{"right", &system.right}, std::pair{"left", &system.left}})
        if (profile->clips > 0)
            hands.push_back({fmt::format("{} hand ({})", name, profile->clips), profile, name});
    return hands;
}

FigureJson profileValues(const std::vector<NamedHand>& hands, ProfileKind kind, double high) {
    FigureJson values = FigureJson::array();
    for (const NamedHand& hand : hands)
        for (const ProfilePoint& point : hand.profile->points) {
            const ProfileValue at_step = profileAt(point, kind);
            const double sd = kind == ProfileKind::reward ? point.reward_sd : point.speed_sd;
            values.push_back({{"t", rounded(point.time_s)},
                              {"mean", rounded(at_step.mean)},
                              {"low", rounded(at_step.low)},
                              {"high", rounded(std::min(at_step.high, high))},
                              {"hand", hand.name},
                              {"tip", fmt::format("{} hand at {:.2f} s: {:.3f}, SD {:.3f}, n = {}", hand.hand,
                                                  rounded(point.time_s), at_step.mean, sd, point.n)}});
        }
    return values;
}

}  // namespace

Figure profileFigure(const Evaluation& evaluation, std::size_t index, ProfileKind kind, Numbering& figures) {
    const SystemEvaluation& system = evaluation.systems[index];
    const bool reward = kind == ProfileKind::reward;
    const ProfileScale scale = profileScale(evaluation, kind);
    const auto hands = handsOf(system);
    FigureJson names = FigureJson::array();
    FigureJson colours = FigureJson::array();
    for (const NamedHand& hand : hands) {
        names.push_back(hand.name);
        colours.push_back(systemColour(hand.profile == &system.right ? 0 : 5));
    }
    FigureJson time = quantity("t");
    time["scale"] = {{"domain", {scale.first_s, scale.last_s}}, {"nice", false}};
    time["axis"] = {{"title", "time from pointing (s)"},
                    {"grid", true},
                    {"tickCount", 6},
                    {"labelFlush", false},
                    {"labelPadding", 10}};
    FigureJson mean = quantity("mean");
    mean["scale"] = {{"domain", {0.0, scale.high}}, {"nice", false}};
    mean["axis"] = {{"title", reward ? "reward (Eq. 2)" : "hand speed (m/s)"}, {"tickCount", 6}};
    const FigureJson colour{{"field", "hand"},
                            {"type", "nominal"},
                            {"scale", {{"domain", std::move(names)}, {"range", std::move(colours)}}},
                            {"legend", {{"columns", 2}, {"symbolOpacity", 1}}}};
    FigureJson band = quantity("low");
    band["scale"] = mean["scale"];
    band["title"] = mean["axis"]["title"];
    FigureJson layers = FigureJson::array();
    layers.push_back(
        {{"mark", {{"type", "area"}, {"opacity", 0.17}}},
         {"encoding", {{"x", time}, {"y", band}, {"y2", {{"field", "high"}}}, {"color", colour}}}});
    layers.push_back({{"data", {{"values", {FigureJson::object()}}}},
                      {"mark", {{"type", "rule"}, {"color", soft_colour}}},
                      {"encoding", {{"x", {{"datum", 0}}}}}});
    const double limit = reward ? motion::highest_pointing_reward : evaluation.input.rule.slower_than_m_s;
    if (limit < scale.high) layers.push_back(dashedLine("y", limit));
    layers.push_back({{"mark",
                       {{"type", "line"},
                        {"strokeWidth", 2},
                        {"strokeDash", {{"expr", "indexof(datum.hand, 'left') == 0 ? [6, 3] : [1, 0]"}}}}},
                      {"encoding", {{"x", time}, {"y", mean}, {"color", colour}}}});
    layers.push_back({{"mark", {{"type", "circle"}, {"size", 60}, {"opacity", 0}}},
                      {"encoding", {{"x", time}, {"y", mean}, {"tooltip", {{"field", "tip"}}}}}});
    std::string spoken;
    for (const NamedHand& hand : hands) {
        const auto& points = hand.profile->points;
        const auto at_zero = std::find_if(points.begin(), points.end(), [](const ProfilePoint& point) {
            return std::abs(point.time_s) < 0.5 * profile_step_s;
        });
        if (at_zero != points.end())
            spoken += fmt::format(" At the time of pointing, {}: {:.3f}.", hand.name,
                                  profileAt(*at_zero, kind).mean);
    }
    const char* what = reward ? "reward" : "speed of the pointing hand";
    return {fmt::format("{}-{}", reward ? "reward" : "speed", index + 1),
            fmt::format("{} {}: {}.", figures.next(), escapeHtml(system.system), what),
            fmt::format("{}: mean and one standard deviation of the {} around the time of pointing.{}",
                        system.system, what, spoken),
            {{"height", 200},
             {"data", {{"values", profileValues(hands, kind, scale.high)}}},
             {"layer", std::move(layers)}}};
}

namespace {

/// Places of the clips in the order of their densities.
std::vector<std::size_t> byDensity(const SystemEvaluation& system) {
    std::vector<std::size_t> order(system.densities.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return system.densities[a] < system.densities[b]; });
    return order;
}

/// Medians of ten groups of clips of neighbouring densities; none of fewer than fifty clips.
FigureJson tenthsOf(const SystemEvaluation& system, const std::vector<std::size_t>& order) {
    constexpr std::size_t groups = 10;
    FigureJson tenths = FigureJson::array();
    if (order.size() < 5 * groups) return tenths;
    for (std::size_t group = 0; group < groups; ++group) {
        std::vector<double> densities;
        std::vector<double> rewards;
        for (std::size_t i = group * order.size() / groups; i < (group + 1) * order.size() / groups; ++i) {
            densities.push_back(system.densities[order[i]]);
            rewards.push_back(system.rewards[order[i]]);
        }
        const double density = quantile(densities, 0.5);
        const double reward = quantile(rewards, 0.5);
        tenths.push_back({{"x", rounded(density)},
                          {"y", rounded(reward)},
                          {"tip", fmt::format("median of {} clips: {:.3f} at {:.3g} per m\u00b3",
                                              rewards.size(), reward, density)}});
    }
    return tenths;
}

std::string correlationWords(const SpearmanTest& test) {
    if (test.method == "undefined") return "no correlation is defined";
    return fmt::format("ρ = {}, p {}{}", fixedText(test.rho, 3), test.p < 0.001 ? "" : "= ", pText(test.p));
}

}  // namespace

Figure densityScatter(const Evaluation& evaluation, std::size_t index, Numbering& figures) {
    const SystemEvaluation& system = evaluation.systems[index];
    double highest = 0.0;
    for (const TestPoint& point : evaluation.points) highest = std::max(highest, point.density);
    std::vector<const MeasuredClip*> clips;
    for (const MeasuredClip* clip : system.clips)
        if (clip->accuracy) clips.push_back(clip);
    const auto order = byDensity(system);
    FigureJson points = FigureJson::array();
    for (const std::size_t pick : evenPicks(order.size(), max_scatter_points)) {
        const std::size_t i = order[pick];
        points.push_back({{"x", rounded(system.densities[i])},
                          {"y", rounded(system.rewards[i])},
                          {"tip", fmt::format("{}: {:.3f} ({:.1f}\u00b0)", clips[i]->clip, system.rewards[i],
                                              system.errors_deg[i])}});
    }
    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {0.0, highest > 0.0 ? 1.04 * highest : 1.0}}, {"nice", false}};
    x["axis"] = {{"title", "density of training targets (1/m\u00b3)"},
                 {"grid", true},
                 {"tickCount", 5},
                 {"labelFlush", false},
                 {"labelPadding", 10}};
    FigureJson y = quantity("y");
    const BoxPlot boxes = accuracyBoxPlot(boxesOf(evaluation));
    y["scale"] = {{"domain", {boxes.low, boxes.high}}, {"nice", false}, {"zero", false}};
    y["axis"] = {{"title", "accuracy (Eq. 2)"}, {"format", ".2f"}, {"tickCount", 6}};
    const FigureJson at{{"x", x}, {"y", y}, {"tooltip", {{"field", "tip"}}}};
    FigureJson layers = FigureJson::array();
    layers.push_back(layerOf(std::move(points),
                             {{"type", "circle"},
                              {"size", order.size() > 100 ? 18 : 40},
                              {"opacity", 0.45},
                              {"color", systemColour(index)}},
                             at));
    layers.push_back(dashedLine("y", motion::highest_pointing_reward));
    const FigureJson tenths = tenthsOf(system, order);
    if (!tenths.empty()) {
        layers.push_back(
            layerOf(tenths, {{"type", "line"}, {"color", ink_colour}, {"strokeWidth", 1.5}}, at));
        layers.push_back(layerOf(tenths,
                                 {{"type", "point"},
                                  {"shape", "diamond"},
                                  {"size", 60},
                                  {"fill", paper_colour},
                                  {"stroke", ink_colour},
                                  {"strokeWidth", 1.5},
                                  {"opacity", 1}},
                                 at));
    }
    const std::string found = correlationWords(system.correlation);
    return {fmt::format("density-{}", index + 1),
            fmt::format("{} {}: {}.{}", figures.next(), escapeHtml(system.system), found,
                        order.size() > max_scatter_points
                            ? fmt::format(" {} of {} clips are drawn, evenly along the density.",
                                          max_scatter_points, order.size())
                            : std::string()),
            fmt::format("{}: accuracy of {} clips against the density of the training targets; a table of "
                        "this page has the correlation.",
                        system.system, order.size()),
            {{"height", 220}, {"layer", std::move(layers)}}};
}

}  // namespace deixis::results
