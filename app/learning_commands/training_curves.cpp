#include "training_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "curve_files.hpp"
#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

/// What is known of some measures: its title, and the words below the figure.
struct KnownMeasure {
    const char* name;
    const char* title;
    const char* caption;
};
constexpr KnownMeasure known_measures[] = {
    {"task reward", "task reward", "What is rewarded as the task, mean over the controls; at most 0.632."},
    {"task reward missed", "task reward missed",
     "Share of the task's reward that is missed; of a line, 0.1 is about 12 degrees beside."},
    {"value error", "value error", "Share of the returns' variance that the critic does not explain."},
    {"style reward", "style reward", "The discriminator's reward, mean over the controls."},
    {"bits a frame", "bits a frame", "Negative log-likelihood of the training frames; less is better."},
    {"bits a frame held out", "bits a frame, held out", "The same of the held-out demonstrations."},
    {"held-out Eq. 2", "Eq. 2", "Equation 2 of clips generated for targets that were not trained on."},
    {"held-out Eq. 2 by eye-fingertip", "Eq. 2 by eye and fingertip",
     "Equation 2, with the line from the eyes through the fingertip, of clips for targets that were not "
     "trained on."},
    {"held-out observer", "observer",
     "How surely the two-cue observer picks targets that were not trained on among balls 20 to 40 cm away, "
     "times 0.632."},
    {"held-out arm error", "arm error, m", "How far elbow and wrist are from the held-out demonstrations'."},
    {"held-out jerk ratio", "jerk, times the demonstrations'",
     "Mean jerk of the pointing hand over that of the demonstrations: 1 is as smooth as they are."},
    {"held-out end height", "end hand height, m",
     "How much higher than at the begin the pointing hand is at the end: 0 is at rest."},
    {"held-out at rest", "share at rest", "Share of the clips at whose end both hands are down again."},
    {"logit of agent", "logit of the agent",
     "What the discriminator says of the body's movements: below 0 it takes them for no demonstration's."},
    {"logit of demonstrations", "logit of demonstrations", "What it says of the demonstrations' movements."},
    {"samples a second", "samples a second", "Controls of bodies that were tried out in a second."},
    {"seconds an update", "seconds an update", "How long an update takes."},
};

std::string idOf(const std::string& name) {
    std::string out = "curve-";
    for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    return out;
}

results::Figure curve(const std::string& name, const std::string& title, const std::string& caption,
                      const std::map<std::string, std::map<int, double>>& parts) {
    using results::FigureJson;
    constexpr std::size_t most_points = 400;
    FigureJson values = FigureJson::array();
    std::size_t index = 0;
    double first = 0.0, last = 0.0;
    for (const auto& [part, of_part] : parts) {
        std::vector<std::pair<int, double>> points(of_part.begin(), of_part.end());
        for (const std::size_t i : results::evenPicks(points.size(), most_points))
            values.push_back({{"update", points[i].first},
                              {"value", results::rounded(points[i].second)},
                              {"part", part},
                              {"colour", results::systemColour(index)}});
        first = points.front().second;
        last = points.back().second;
        ++index;
    }
    FigureJson x = results::quantity("update");
    x["title"] = "update";
    FigureJson y = results::quantity("value");
    y["title"] = title;
    y["scale"] = {{"zero", false}};
    FigureJson encoding{{"x", x}, {"y", y}, {"color", results::ownColour()}};
    encoding["detail"] = {{"field", "part"}, {"type", "nominal"}};
    FigureJson spec{{"width", "container"}, {"height", 180}};
    spec["layer"] = FigureJson::array({results::layerOf(
        values, {{"type", "line"}, {"point", {{"size", 12}, {"filled", true}}}, {"strokeWidth", 1.5}},
        encoding)});
    const std::string label = parts.size() == 1
                                  ? fmt::format("{}: from {:.3g} to {:.3g}.", title, first, last)
                                  : fmt::format("{}: {} curves, one a cluster.", title, parts.size());
    return {idOf(name), caption, label, spec};
}

}  // namespace

TrainingCurves::TrainingCurves(fs::path weights_file, std::string system)
    : weights_file_(std::move(weights_file)), system_(std::move(system)) {}

Result<void> TrainingCurves::read() {
    const auto found = readCurveTable(weights_file_);
    if (!found) return tl::unexpected(found.error());
    if (!*found) return {};
    const CsvSheet& sheet = **found;
    const auto part = sheet.column("part"), update = sheet.column("update"),
               measure = sheet.column("measure"), value = sheet.column("value");
    for (const auto* column : {&part, &update, &measure, &value})
        if (!*column) return tl::unexpected(column->error());
    for (const CsvRecord& row : sheet.rows) {
        const auto at = sheet.number(row, *update, "a whole number", 1e9);
        const auto number = sheet.number(row, *value);
        for (const auto* read : {&at, &number})
            if (!*read) return tl::unexpected(read->error());
        values_[row.fields[*measure]][row.fields[*part]][static_cast<int>(*at)] = *number;
    }
    return {};
}

void TrainingCurves::add(const learning::TrainingProgress& progress) {
    const auto put = [&](const std::string& name, double value) {
        values_[name][progress.part][progress.update] = value;
    };
    for (const auto& [name, value] : progress.numbers) put(name, value);
    if (!progress.validation) return;
    put("held-out " + progress.validation->reward_name, progress.validation->reward);
    put("held-out arm error", progress.validation->arm_error_m);
    put("held-out jerk ratio", progress.validation->jerk_ratio);
    put("held-out end height", progress.validation->end_height_m);
    put("held-out at rest", progress.validation->at_rest);
}

Result<void> TrainingCurves::write() const {
    std::string csv = "part,update,measure,value\n";
    for (const auto& [measure, parts] : values_)
        for (const auto& [part, values] : parts)
            for (const auto& [update, value] : values)
                csv += fmt::format("{},{},{},{}\n", part, update, measure, value);
    return writeCurveFiles(weights_file_, csv, page());
}

std::string TrainingCurves::page() const {
    std::string figures;
    results::Numbering numbers("Figure");
    const auto add = [&](const std::string& name, const std::string& title, const std::string& caption) {
        if (const auto found = values_.find(name); found != values_.end())
            figures += results::figureHtml(curve(name, title, numbers.next() + " " + caption, found->second));
    };
    for (const KnownMeasure& one : known_measures) add(one.name, one.title, one.caption);
    for (const auto& entry : values_) {
        const std::string& name = entry.first;
        if (std::ranges::none_of(known_measures, [&](const KnownMeasure& one) { return name == one.name; }))
            add(name, name, name + ".");
    }
    const std::string title = "Training of " + system_;
    return results::pageStart(title, title) +
           results::paragraphHtml(
               "Held-out numbers are of clips generated for targets that were not trained on: the weights "
               "that are kept are chosen by them. Where there are clusters, each has its curve.",
               results::ParagraphLook::lead) +
           results::figuresPlaced(figures) +
           results::pageEnd("The numbers are in the table beside this page, whose name ends in .curves.csv.");
}

}  // namespace deixis::app
