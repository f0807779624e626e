// The page: what stands where.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "claims.hpp"
#include "figures.hpp"
#include "paper_figures.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "results/reproduction/reproduction.hpp"

namespace deixis::results {

namespace {

bool anySimulated(const ReproductionInput& input) {
    return std::ranges::any_of(input.studies, [](const StudyFigures& one) { return one.synthetic; });
}

std::string lead(const ReproductionInput& input, const std::vector<Claim>& claims) {
    const auto agree =
        std::ranges::count_if(claims, [](const Claim& one) { return one.verdict == Verdict::agrees; });
    const std::string out = paragraphHtml(
        fmt::format("Of the paper\u2019s claims, looked at {} times (each on every grid and by every kind of "
                    "participants), {} came out here, too.",
                    claims.size(), agree),
        ParagraphLook::lead);
    std::string synthetic =
        "The demonstrations are synthetic, so all systems learned from formulas, not from people";
    if (anySimulated(input))
        synthetic +=
            ", and all participants are simulated: their answers follow from assumptions and say nothing "
            "about people";
    return out + titledParagraph("Synthetic:",
                                 synthetic +
                                     ". No number of ours stands for one of the paper\u2019s; what can be "
                                     "compared is what follows from its methods.",
                                 ParagraphLook::synthetic);
}

/// Each claim once, and under it what came out, by each grid and kind of participants.
Section claimsSection(const std::vector<Claim>& claims) {
    Json listed = Json::array(), reasons = Json::array();
    std::map<std::string, std::size_t> place_of_claim;
    std::map<std::string, std::set<std::string>> claims_of_reason;  // one may stand for several
    for (const Claim& one : claims) {
        const auto [place, fresh] = place_of_claim.try_emplace(one.claim, listed.size());
        if (fresh)
            listed.push_back({{"claim", one.claim},
                              {"section", one.section},
                              {"paper", one.paper},
                              {"found", Json::array()}});
        listed[place->second]["found"].push_back(
            {{"verdict", one.verdict == Verdict::agrees ? "Agrees" : "Differs"},
             {"where", one.where},
             {"ours", one.ours}});
        if (one.why.empty()) continue;
        auto& of_reason = claims_of_reason[one.why];
        if (of_reason.empty()) reasons.push_back({{"why", one.why}, {"claims", ""}});
        if (!of_reason.insert(one.claim).second) continue;
        for (Json& reason : reasons)
            if (reason.at("why") == one.why) {
                const std::string before = reason.at("claims");
                reason["claims"] = before.empty() ? one.claim : before + " " + one.claim;
            }
    }
    Json values{{"claims", listed}};
    if (!reasons.empty()) values["why_not"] = {{"reasons", reasons}};
    return {"What agrees and what does not", filled("claims.mustache", values)};
}

Section objectiveSection(const ReproductionInput& input, Numbering& figures, Numbering& tables) {
    if (input.grids.empty()) return {};
    using Row = GridFigures::System;
    const std::string intro = paragraphHtml(
        "Equation\u00a02 of each system\u2019s clips at test points that it was not trained on (the "
        "paper\u2019s Figure\u00a09 and Table\u00a02). The paper calls its grid uniform and also spherical; "
        "both are here.",
        ParagraphLook::intro);
    std::string drawn, written;
    for (const GridFigures& grid : input.grids) {
        drawn += figureHtml(
            accuracyBesidePaper(grid, fmt::format("grid-{}", &grid - input.grids.data() + 1), figures));
        Table table = tableOf<Row>(
            "grid", units::clips, "",
            {{"system", &Row::system},
             {"paper_mean",
              [](const Row& one) {
                  const PaperSystem* paper = paperSystem(one.system);
                  return paper != nullptr ? paper->equation_2 : std::nullopt;
              },
              {.label = "paper"}},
             {"mean", &Row::mean, {.label = "ours", .format = Format::three_decimals}},
             {"sd", &Row::sd, {.label = "SD", .format = Format::three_decimals}},
             {"median", &Row::median, {.label = "median", .format = Format::three_decimals}},
             {"error_deg", &Row::error_deg, {.label = "error (\u00b0)", .format = Format::one_decimal}},
             {"eye_error_deg",
              &Row::eye_error_deg,
              {.label = "eye\u2013fingertip (\u00b0)", .format = Format::one_decimal}},
             {"outliers", [](const Row& one) { return lowOutliers(one.accuracies); }, {.label = "outliers"}},
             {"missing", &Row::missing, {.label = "missing"}},
             {"paper_rho",
              [](const Row& one) {
                  const PaperSystem* paper = paperSystem(one.system);
                  return paper != nullptr ? paper->density_rho : std::nullopt;
              },
              {.label = "\u03c1, paper", .format = Format::three_decimals}},
             {"rho", &Row::density_rho, {.label = "\u03c1, ours", .format = Format::three_decimals}},
             {"p", &Row::density_p}},
            grid.systems);
        written += tableHtml(
            table,
            fmt::format(
                "Accuracy at {} points, {}: mean of Equation 2, the paper\u2019s beside ours; outliers are "
                "below the lower quartile by more than 1.5 times the quartiles\u2019 distance; \u03c1 is "
                "Spearman\u2019s correlation with the density of {} training targets.",
                grid.points, grid.grid, grid.training_targets),
            tables, dense_table);
    }
    return {"Objective evaluation", intro + figuresPlaced(drawn) + written};
}

/// Behind the others, a column for each kind of participants.
void addKinds(Table& table, const ReproductionInput& input, ColumnKind kind) {
    for (const StudyFigures& study : input.studies) {
        Column& column = table.columns.emplace_back(study.participants_kind, kind);
        column.label = study.participants_kind;
        column.format = Format::score;
        column.right = kind == ColumnKind::text;
    }
}

/// A row for each system.
Table scoresTable(const ReproductionInput& input, const std::string& measure) {
    Table table{measure, units::means, "", {{"system", ColumnKind::text}, {"paper", ColumnKind::number}}};
    table.column("paper").label = "paper";
    table.column("paper").format = Format::score;
    addKinds(table, input, ColumnKind::number);
    for (const PaperSystem& paper : paper_systems) {
        const auto value = measure == "accuracy" ? paper.accuracy : paper.naturalness;
        if (!value) continue;
        Table::Row& row = table.rows.emplace_back(Table::Row{{paper.system, *value}});
        row.percent = measure == "accuracy";
        for (const StudyFigures& study : input.studies) {
            Cell& cell = row.cells.emplace_back();
            for (const StudyFigures::Score& one : study.scores)
                if (one.measure == measure && one.system == paper.system) cell = one.mean;
        }
    }
    return table;
}

Table layoutsTable(const ReproductionInput& input) {
    Table table{"layouts",
                units::answers,
                "",
                {{"system", ColumnKind::text}, {"layout", ColumnKind::text}, {"paper", ColumnKind::number}}};
    table.column("layout").label = "layout";
    table.column("paper").label = "paper";
    addKinds(table, input, ColumnKind::text);
    for (const PaperSystem& paper : paper_systems)
        for (const auto& [layout, value] :
             {std::pair{"across", paper.across}, std::pair{"side-by-side", paper.side_by_side}}) {
            if (!value) continue;
            Table::Row& row = table.rows.emplace_back(Table::Row{{paper.system, layout, *value}});
            for (const StudyFigures& study : input.studies) {
                Cell& cell = row.cells.emplace_back();
                for (const StudyFigures::Layout& one : study.layouts)
                    if (one.system == paper.system && one.layout == layout)
                        cell = fmt::format("{} \u00b1 {}", fixedText(one.mean, 2), fixedText(one.sd, 2));
            }
        }
    return table;
}

std::string ceilingHtml(const CeilingFigures& ceiling, Numbering& tables) {
    std::vector<std::string> observers;
    for (const auto& one : ceiling.readings)
        if (std::ranges::find(observers, one.observer) == observers.end()) observers.push_back(one.observer);
    Table table{"ceilings", units::trials, "", {{"system", ColumnKind::text}}};
    for (const std::string& one : observers) {
        Column& column = table.columns.emplace_back(one, ColumnKind::number);
        column.label = one;
        column.format = Format::percent;
    }
    for (const auto& one : ceiling.readings) {
        auto row = std::ranges::find_if(
            table.rows, [&](const Table::Row& other) { return other.cells.front().text() == one.system; });
        if (row == table.rows.end()) row = table.rows.insert(table.rows.end(), Table::Row{{one.system}});
        row->cells.resize(table.columns.size());
        row->cells[table.at(one.observer)] = one.without_error;
    }
    std::string out = tableHtml(
        table,
        "Ceilings: shares of games in which the target is what is read, by observers who make no error.",
        tables);
    if (ceiling.nearest_target_share)
        out +=
            noteHtml(fmt::format("Whoever reads the demonstration\u2019s own target, seen from between the "
                                 "pointer\u2019s eyes, gets {} % of GT-nn right: so often the study\u2019s "
                                 "target is the ball nearest to it. The paper\u2019s participants got 85.6 "
                                 "%: its demonstrations were nearer to the test targets than these.",
                                 fixedText(100.0 * *ceiling.nearest_target_share, 1)));
    return out;
}

Section studySection(const ReproductionInput& input, Numbering& figures, Numbering& tables) {
    if (input.studies.empty()) return {};
    double least = 1.0, most = 0.0;
    for (const PaperSystem& paper : paper_systems) {
        double low = 2.0, high = -1.0;
        for (const StudyFigures& study : input.studies)
            for (const StudyFigures::Score& one : study.scores)
                if (one.measure == "accuracy" && one.system == paper.system) {
                    low = std::min(low, one.mean);
                    high = std::max(high, one.mean);
                }
        if (high < low) continue;
        least = std::min(least, high - low);
        most = std::max(most, high - low);
    }
    std::string out = paragraphHtml(
        fmt::format("{} participants each{}. The same clips were seen by all; the kinds differ in how they "
                    "read an arm. That alone moves a system\u2019s share of right choices by {} to {} "
                    "percentage points (the paper\u2019s Figure\u00a07 and Table\u00a01).",
                    input.studies.front().participants, anySimulated(input) ? ", simulated" : "",
                    fixedText(100.0 * least, 0), fixedText(100.0 * most, 0)),
        ParagraphLook::intro);
    // One after another: the figures count.
    std::string drawn;
    for (const char* measure : {"accuracy", "naturalness"})
        drawn += figureHtml(studyBesidePaper(input, measure, figures));
    out += figuresPlaced(drawn);
    out += tableHtml(scoresTable(input, "accuracy"), "Right choices, mean over participants.", tables);
    if (input.ceiling) out += ceilingHtml(*input.ceiling, tables);
    out += tableHtml(scoresTable(input, "naturalness"), "Naturalness from 1 to 5, mean over participants.",
                     tables);
    out += tableHtml(layoutsTable(input),
                     "Share of right choices by layout, \u00b1 the standard deviation over answers.", tables);
    return {"The study", out};
}

/// An SVG picture without the size in which it is drawn alone.
std::string asWideAsThePage(std::string svg) {
    const std::size_t width = svg.find(" width=\""), end = svg.find('>');
    const std::size_t height = svg.find(" height=\"", width);
    if (width > end || height > end) return svg;
    const std::size_t after = svg.find('"', height + 9) + 1;
    return svg.replace(width, after - width, " style=\"width:100%;height:auto\"");
}

Section demonstrationsSection(const ReproductionInput& input, Numbering& figures, Numbering& tables) {
    const auto compared = compareHands(input.demonstrations);
    std::string out;
    if (!input.targets_svg.empty())
        out +=
            filled("picture.mustache",
                   {{"name", "targets"},
                    {"svg", asWideAsThePage(input.targets_svg)},
                    {"caption", figures.next() +
                                    " Targets of the demonstrations (blue) and of the study (red), as in the "
                                    "paper\u2019s Figure\u00a01."}});
    using Row = HandsCompared;
    if (!compared.empty())
        out += tableHtml(tableOf<Row>("hands", units::clips, "",
                                      {{"measure", &Row::measure},
                                       {"n_left", &Row::n_left, {.label = "left"}},
                                       {"n_right", &Row::n_right, {.label = "right"}},
                                       {"median_left",
                                        &Row::median_left,
                                        {.label = "median, left", .format = Format::three_decimals}},
                                       {"median_right",
                                        &Row::median_right,
                                        {.label = "median, right", .format = Format::three_decimals}},
                                       {"p", &Row::p},
                                       {"p_holm", &Row::p_holm}},
                                      compared),
                         "Demonstrations by hand, of which the paper has 25 by the left and 27 by the "
                         "right; exact rank-sum tests, two-sided, and Holm\u2019s correction over both.",
                         tables);
    return {"Demonstrations", out};
}

Section trainedSection(const ReproductionInput& input, Numbering& figures, Numbering& tables) {
    if (input.trained.empty()) return {};
    using Row = TrainedSystem;
    std::string out;
    const auto in_cm = [](const Row& one) -> std::optional<double> {
        return one.arm_error_m ? std::optional(100.0 * *one.arm_error_m) : std::nullopt;
    };
    if (!input.grids.empty())
        out += figuresPlaced(figureHtml(accuracyAndImitation(input, figures)), FigurePlace::single);
    out += tableHtml(
        tableOf<Row>("trained", units::targets, "",
                     {{"system", &Row::system},
                      {"numbers", &Row::numbers, {.label = "numbers"}},
                      {"bytes", &Row::bytes, {.label = "bytes"}},
                      {"rewarded", &Row::rewarded, {.label = "rewarded"}},
                      {"reward", &Row::reward, {.label = "reward", .format = Format::three_decimals}},
                      {"jerk", &Row::jerk_ratio, {.label = "jerk", .format = Format::plain}},
                      {"at_rest", &Row::at_rest, {.label = "at rest", .format = Format::percent}},
                      {"arm_error", in_cm, {.label = "arm (cm)", .format = Format::one_decimal}},
                      {"trained_by", &Row::trained_by, {.label = "trained by"}}},
                     input.trained),
        "What each system has learned, as its file says: how many numbers, what a policy was rewarded "
        "for (Eq. 2 of which line), and of held-out targets that reward, the hand\u2019s jerk over "
        "the demonstrations\u2019, the share of clips that end at rest, and how far elbow and wrist "
        "are from the demonstration\u2019s. The paper gives no sizes.",
        tables, dense_table);
    return {"What was trained", out};
}

Section provenance(const ReproductionInput& input) {
    std::vector<Fact> facts{{"Program", escapeHtml(input.program)}};
    for (const GridFigures& one : input.grids) facts.push_back({"Evaluation", escapeHtml(one.file)});
    if (input.ceiling) facts.push_back({"Evaluation", escapeHtml(input.ceiling->file)});
    for (const StudyFigures& one : input.studies) facts.push_back({"Study", escapeHtml(one.file)});
    for (const std::string& one : input.pages)
        facts.push_back({"More", filled("link.mustache", {{"to", one}})});
    return {"Where the numbers come from", factsHtml(facts)};
}

}  // namespace

std::string renderReproduction(const ReproductionInput& input) {
    const std::vector<Claim> claims = paperClaims(input);
    Numbering figures("Figure");
    Numbering tables;
    // Figures and tables count: braces, from the first to the last.
    std::vector<Section> sections{claimsSection(claims),
                                  objectiveSection(input, figures, tables),
                                  studySection(input, figures, tables),
                                  demonstrationsSection(input, figures, tables),
                                  trainedSection(input, figures, tables),
                                  provenance(input)};
    const std::string title = "Deichler et al. (2023), and the same here";
    return withContents(pageStart(title, title) + lead(input, claims), std::move(sections)) +
           pageEnd("The tables have the figures' numbers.");
}

}  // namespace deixis::results
