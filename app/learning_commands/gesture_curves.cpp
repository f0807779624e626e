#include "gesture_curves.hpp"

#include <fmt/format.h>

#include <optional>
#include <type_traits>
#include <vector>

#include "curve_files.hpp"
#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::app {

namespace {

using learning::GestureEpoch;

/// The table's columns: visit(name, number) for each.
template <typename Epoch, typename Visit>
void forColumns(Epoch&& e, const Visit& visit) {
    visit("epoch", e.epoch);
    visit("updates", e.updates);
    visit("huber", e.losses.huber);
    visit("gan", e.losses.gan);
    visit("style", e.losses.style);
    visit("discriminator", e.losses.discriminator);
    visit("controls", e.scores.controls);
    visit("fgd_no_controls", e.scores.fgd_no_controls);
    visit("fgd_pose_controls", e.scores.fgd_pose_controls);
    visit("fgd_style_controls", e.scores.fgd_style_controls);
    visit("pcs", e.scores.pcs);
    visit("scs", e.scores.scs);
    visit("mean_pose_fgd", e.mean_pose.fgd_no_controls);
    visit("mean_pose_pcs", e.mean_pose.pcs);
    visit("mean_pose_scs", e.mean_pose.scs);
    visit("best", e.best);
}

using Epochs = std::map<int, GestureEpoch>;

struct EpochLine {
    std::string name;
    double (*get)(const GestureEpoch&);
};

results::FigureJson axis(const char* field, const char* title, bool logarithmic) {
    results::FigureJson out = results::quantity(field);
    out["title"] = title;
    out["scale"] = {{"zero", false}};
    if (logarithmic) out["scale"]["type"] = "log";
    return out;
}

/// Values above 0 alone have a place on such an axis.
results::Figure epochFigure(const std::string& name, const std::string& caption, const char* title,
                            const std::vector<EpochLine>& lines, const Epochs& epochs, bool logarithmic) {
    using results::FigureJson;
    FigureJson values = FigureJson::array(), colours = FigureJson::array(), names = FigureJson::array();
    std::string label;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        double first = 0.0, last = 0.0;
        bool any = false;
        for (const auto& [number, epoch] : epochs) {
            const double value = lines[i].get(epoch);
            if (!(value > 0.0)) continue;
            values.push_back(
                {{"epoch", number}, {"value", results::rounded(value)}, {"line", lines[i].name}});
            if (!any) first = value;
            last = value;
            any = true;
        }
        if (!any) continue;
        names.push_back(lines[i].name);
        colours.push_back(results::systemColour(i));
        label += fmt::format("{}: from {:.3g} to {:.3g}. ", lines[i].name, first, last);
    }
    FigureJson colour{{"field", "line"}, {"type", "nominal"}, {"title", nullptr}};
    colour["scale"] = {{"domain", names}, {"range", colours}};
    colour["legend"] = {{"orient", "top"}, {"columns", 2}};
    FigureJson spec{{"width", "container"}, {"height", 220}};
    spec["layer"] = FigureJson::array(
        {results::layerOf(values, {{"type", "line"}, {"point", {{"size", 14}, {"filled", true}}}},
                          {{"x", axis("epoch", "epoch", false)},
                           {"y", axis("value", title, logarithmic)},
                           {"color", colour}})});
    return {name, caption, label, spec};
}

}  // namespace

Result<void> GestureCurves::read() {
    const auto found = readCurveTable(weights_file_);
    if (!found) return tl::unexpected(found.error());
    if (!*found) return {};
    const CsvSheet& sheet = **found;
    for (const CsvRecord& row : sheet.rows) {
        GestureEpoch epoch;
        std::optional<Error> problem;
        forColumns(epoch, [&](const char* name, auto& value) {
            const auto column = sheet.column(name);
            const auto number = column ? sheet.number(row, *column) : tl::unexpected(column.error());
            if (number)
                value = static_cast<std::remove_reference_t<decltype(value)>>(*number);
            else if (!problem)
                problem = number.error();
        });
        if (problem) return tl::unexpected(*problem);
        add(epoch);
    }
    return {};
}

Result<void> GestureCurves::write() const {
    std::string header;
    forColumns(GestureEpoch(),
               [&](const char* name, auto) { header += (header.empty() ? "" : ",") + std::string(name); });
    std::string csv = header + "\n";
    for (const auto& [number, epoch] : epochs_) {
        std::string line;
        forColumns(epoch, [&](const char*, auto value) {
            line += (line.empty() ? "" : ",") + fmt::format("{}", double(value));
        });
        csv += line + "\n";
    }
    return writeCurveFiles(weights_file_, csv, page());
}

std::string GestureCurves::page() const {
    std::string figures;
    results::Numbering numbers("Figure");
    const auto add = [&](const std::string& name, const std::string& text, const char* title,
                         const std::vector<EpochLine>& lines, bool logarithmic) {
        figures += results::figureHtml(
            epochFigure(name, numbers.next() + " " + text, title, lines, epochs_, logarithmic));
    };
    if (!epochs_.empty() && epochs_.rbegin()->second.scores.controls) {
        add("pcs", "Pose compliance (equation 8): how far directions are from poses that were asked for.",
            "PCS",
            {{"model", [](const GestureEpoch& e) { return e.scores.pcs; }},
             {"mean pose", [](const GestureEpoch& e) { return e.mean_pose.pcs; }}},
            true);
        add("scs", "Style compliance (equation 9): how far styles are from those that were asked for.", "SCS",
            {{"model", [](const GestureEpoch& e) { return e.scores.scs; }},
             {"mean pose", [](const GestureEpoch& e) { return e.mean_pose.scs; }}},
            true);
    }
    add("fgd", "Fréchet gesture distance between generated and held-out motions.", "FGD",
        {{"no controls", [](const GestureEpoch& e) { return e.scores.fgd_no_controls; }},
         {"pose controls", [](const GestureEpoch& e) { return e.scores.fgd_pose_controls; }},
         {"style controls", [](const GestureEpoch& e) { return e.scores.fgd_style_controls; }},
         {"mean pose", [](const GestureEpoch& e) { return e.mean_pose.fgd_no_controls; }}},
        true);
    add("huber", "The Huber term of equation 7, before it is weighted.", "Huber",
        {{"Huber", [](const GestureEpoch& e) { return e.losses.huber; }}}, true);
    add("style", "The style term.", "style",
        {{"style", [](const GestureEpoch& e) { return e.losses.style; }}}, true);
    add("adversarial", "The adversarial terms, from the epoch in which they begin.", "cross-entropy",
        {{"generator", [](const GestureEpoch& e) { return e.losses.gan; }},
         {"discriminator", [](const GestureEpoch& e) { return e.losses.discriminator; }}},
        false);
    const std::string title = "Training of speech gestures";
    return results::pageStart(title, title) +
           results::paragraphHtml(
               "The first figures are of speeches that were not trained on; less is better, and the weights "
               "that "
               "are kept are chosen by them. FGD depends on the autoencoder, which was trained on the same "
               "motions: it cannot be compared with published figures.",
               results::ParagraphLook::lead) +
           results::figuresPlaced(figures) +
           results::pageEnd("The numbers are in the table beside this page, whose name ends in .curves.csv.");
}

}  // namespace deixis::app
