#include "results/gestures/gesture_evaluation.hpp"

#include <fmt/format.h>

#include "results/page/html_table.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"
#include "results/tables/table.hpp"
#include "strips.hpp"

namespace deixis::results {

namespace {

constexpr TableUnit motion_parts{"parts of 2 s of motion"};

/// A row with the set that it is of; the published rows have a set of their own.
struct ScoreRow {
    std::string set;
    const GestureModelScores* of = nullptr;
};

const Fields<ScoreRow>& scoreFields() {
    static const Fields<ScoreRow> fields{
        {"set", &ScoreRow::set, {.label = "speeches"}},
        {"model", [](auto& row) { return row.of->model; }},
        {"fgd_no_controls",
         [](auto& row) { return row.of->fgd_no_controls; },
         {.label = "FGD, no controls", .format = Format::three_decimals}},
        {"fgd_pose_controls",
         [](auto& row) { return row.of->fgd_pose_controls; },
         {.label = "with poses", .format = Format::three_decimals}},
        {"fgd_style_controls",
         [](auto& row) { return row.of->fgd_style_controls; },
         {.label = "with styles", .format = Format::three_decimals}},
        {"pcs", [](auto& row) { return row.of->pcs; }, {.label = "PCS", .format = Format::three_decimals}},
        {"scs", [](auto& row) { return row.of->scs; }, {.label = "SCS", .format = Format::three_decimals}},
        {"posed_off_deg", [](auto& row) { return row.of->posed_off_deg; }, {.label = "off poses, °"}},
        {"exact_off_deg",
         [](auto& row) { return row.of->exact_off_deg; },
         {.label = "exact, °", .format = Format::three_decimals}}};
    return fields;
}

Table scoresTable(const std::vector<GestureTestSet>& sets, bool with_published) {
    std::vector<ScoreRow> rows;
    for (const GestureTestSet& set : sets)
        for (const GestureModelScores& one : set.models) rows.push_back({set.name, &one});
    if (with_published)
        for (const GestureModelScores& one : publishedGestureScores())
            rows.push_back({"published, TED", &one});
    return tableOf("gesture_scores", motion_parts, "", scoreFields(), rows);
}

std::string cellWords(const std::optional<double>& value, int decimals = 3) {
    return value ? fixedText(*value, decimals) : std::string("-");
}

constexpr const char* not_comparable =
    "FGD depends on the autoencoder and on the motions that it was trained on: it cannot be compared with "
    "published "
    "figures, and PCS and SCS were measured there on other motions.";

}  // namespace

const std::vector<GestureModelScores>& publishedGestureScores() {
    static const std::vector<GestureModelScores> rows{
        {"proposed", 0.447, 0.194, 0.228, 0.014, 0.249, 0.96, {}},
        {"baseline", 0.368, {}, {}, {}, {}, {}, {}},
        {"mean pose", 26.768, {}, {}, 0.143, 1.236, {}, {}}};
    return rows;
}

std::string gestureScoresText(const std::vector<GestureTestSet>& sets) {
    std::string out = fmt::format("{:<28} {:>10} {:>10} {:>10} {:>7} {:>7} {:>10} {:>8}\n", "", "FGD",
                                  "poses", "styles", "PCS", "SCS", "off, deg", "exact");
    const auto rows = [&out](const std::vector<GestureModelScores>& models) {
        for (const GestureModelScores& one : models)
            out += fmt::format("  {:<26} {:>10} {:>10} {:>10} {:>7} {:>7} {:>10} {:>8}\n", one.model,
                               fixedText(one.fgd_no_controls, 3), cellWords(one.fgd_pose_controls),
                               cellWords(one.fgd_style_controls), cellWords(one.pcs), cellWords(one.scs),
                               cellWords(one.posed_off_deg, 2), cellWords(one.exact_off_deg));
    };
    for (const GestureTestSet& set : sets) {
        out += fmt::format("{}{}: {} speeches, {:.1f} min, {} parts of 2 s\n", set.name,
                           set.synthetic ? " (synthetic)" : "", set.speeches, set.minutes, set.parts);
        rows(set.models);
    }
    out += "published (Yoon et al. 2021, table 1; TED talks)\n";
    rows(publishedGestureScores());
    return out + not_comparable + "\n";
}

std::string gestureScoresCsv(const std::vector<GestureTestSet>& sets) {
    return csvText(scoresTable(sets, true));
}

std::string gestureScoresJson(const GestureEvaluationPage& page) {
    Json sets = Json::array();
    for (const GestureTestSet& set : page.sets)
        sets.push_back({{"name", set.name},
                        {"synthetic", set.synthetic},
                        {"speeches", set.speeches},
                        {"minutes", set.minutes},
                        {"parts", set.parts},
                        {"models", tableJson(scoresTable({set}, false))}});
    Json facts = Json::object();
    for (const auto& [name, text] : page.facts) facts[name] = text;
    const Json out{{"schema", {{"name", "deixis-gesture-evaluation"}, {"version", 1}}},
                   {"model", facts},
                   {"trained_on_synthetic", page.trained_on_synthetic},
                   {"sets", sets},
                   {"published", tableJson(scoresTable(
                                     {{"published", false, 0, 0.0, 0, publishedGestureScores()}}, false))},
                   {"remark", not_comparable}};
    return out.dump(2) + "\n";
}

std::string gestureEvaluationHtml(const GestureEvaluationPage& page) {
    std::string lead;
    bool synthetic = page.trained_on_synthetic;
    for (const GestureTestSet& set : page.sets) synthetic = synthetic || set.synthetic;
    if (synthetic)
        lead += titledParagraph(
            "Synthetic:",
            "the speeches are spoken by machine voices and gestured by rules. These numbers say "
            "how well a model does what it was asked for; they say nothing about people.",
            ParagraphLook::synthetic);
    std::vector<Fact> facts;
    for (const auto& [name, text] : page.facts) facts.push_back({name, escapeHtml(text)});
    for (const GestureTestSet& set : page.sets)
        facts.push_back(
            {set.name, fmt::format("{} speeches, {:.1f} min, {} parts of 2 s, none of them trained on",
                                   set.speeches, set.minutes, set.parts)});
    Numbering tables;
    const std::string scores =
        tableHtml(scoresTable(page.sets, true),
                  "Numerical evaluation as in table 1 of Yoon et al. (2021). Lower is better.", tables,
                  dense_table) +
        noteHtml(not_comparable) +
        noteHtml(
            "PCS: mean absolute difference of directions at the frames 10 to 14 of each 30, which were poses "
            "(equation 8). "
            "SCS: of normalised styles (equation 9). Off poses: the mean angle there; exact: the largest "
            "angle with the "
            "option exact.");
    std::string strips;
    if (!page.strips.empty()) {
        Numbering figures("Figure");
        strips =
            filled("picture.mustache",
                   {{"name", "strips"},
                    {"svg", stripsSvg(page)},
                    {"caption",
                     figures.next() +
                         " One speech, as figure 3 of Yoon et al. (2021): stretches with poses are green, "
                         "with styles red. The figure's right arm is orange, its left arm blue."}});
    }
    const std::string title = "Evaluation of speech gestures";
    return pageStart(title, title) +
           withContents(
               lead,
               {{"What was looked at", factsHtml(facts)}, {"Scores", scores}, {"Poses over time", strips}}) +
           pageEnd("");
}

}  // namespace deixis::results
