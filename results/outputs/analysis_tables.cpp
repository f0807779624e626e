#include "results/outputs/analysis_tables.hpp"

#include <fmt/format.h>

#include <map>

#include "analysis_table_parts.hpp"
#include "analysis_tables_further.hpp"
#include "analysis_tables_ratings.hpp"
#include "analysis_tables_studies.hpp"
#include "answers_csv.hpp"
#include "results/outputs/bradley_terry_outputs.hpp"
#include "results/outputs/quality_outputs.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

namespace {

using enum ColumnType;

}  // namespace

PlainTable meansTable(const AnalysisResult& result) {
    PlainTable out{
        "means",
        units::means,
        fmt::format("Means of participants' means, {:g} % bootstrap intervals over participants, and "
                    "standard deviations",
                    100.0 * result.level),
        {{"measure", text, Print::heading},
         {"system", text, Print::plain},
         {"mean", number, Print::plain, "mean"},
         {"median", number},
         {"lower", number, Print::range, "interval"},
         {"upper", number},
         {"sd_participants", number, Print::plain, "SD (participants)"},
         {"sd_trials", number, Print::plain, "SD (trials)"},
         {"participants", whole, Print::plain},
         {"answers", whole, Print::plain}}};
    for (std::size_t m = 0; m < result.measures.size(); ++m)
        for (const SystemResult& system : result.systems) {
            const Summary& one = system.measures[m];
            const std::size_t people = one.by_participant.size();
            out.rows.push_back({result.measures[m].name, system.system, knownCell(one.n > 0, one.mean),
                                knownCell(one.n > 0, one.median),
                                one.interval ? PlainCell(one.interval->lower) : PlainCell(),
                                one.interval ? PlainCell(one.interval->upper) : PlainCell(),
                                knownCell(people > 1, one.sd_participants),
                                knownCell(one.n > 1, one.sd_trials), wholeCell(people), wholeCell(one.n)});
        }
    return out;
}

namespace {

PlainTable levelsTable(const AnalysisResult& result) {
    PlainTable out{"levels",
                   units::answers,
                   "Means and standard deviations over trials, by the levels of within factors",
                   {{"measure", text, Print::heading},
                    {"factor", text, Print::heading},
                    {"system", text, Print::plain},
                    {"level", text, Print::plain},
                    {"mean", number, Print::plain},
                    {"sd_trials", number, Print::plain, "SD (trials)"},
                    {"answers", whole, Print::plain},
                    {"mean_participants", number},
                    {"lower", number},
                    {"upper", number},
                    {"participants", whole}}};
    for (const LevelResult& row : result.levels) {
        const Summary& of = row.over_participants;
        out.rows.push_back(
            {row.measure, row.factor, row.system, row.level, knownCell(row.n > 0, row.mean),
             knownCell(row.n > 1, row.sd_trials), wholeCell(row.n), knownCell(of.n > 0, of.mean),
             of.interval ? PlainCell(of.interval->lower) : PlainCell(),
             of.interval ? PlainCell(of.interval->upper) : PlainCell(), wholeCell(of.by_participant.size())});
    }
    return out;
}

}  // namespace

PlainTable omnibusTable(const AnalysisResult& result) {
    PlainTable out{"omnibus",
                   units::means,
                   "Friedman's test over all systems",
                   {{"measure", text, Print::plain},
                    {"n", whole, Print::plain, "$n$"},
                    {"chi2", number, Print::plain, "$\\chi^2$"},
                    {"df", whole, Print::plain},
                    {"p", number, Print::p_value, "$p$"},
                    {"kendalls_w", number, Print::plain, "Kendall's $W$"},
                    {"f", number, Print::plain, "$F$"},
                    {"df1", whole, Print::plain, "df$_1$"},
                    {"df2", whole, Print::plain, "df$_2$"},
                    {"p_f", number, Print::p_value, "$p_F$"}}};
    for (const OmnibusResult& one : result.omnibus) {
        const FriedmanTest& test = one.test;
        const ImanDavenport& f = test.iman_davenport;
        out.rows.push_back({one.measure, wholeCell(test.n), plainCell(test.chi2), wholeCell(test.df),
                            plainCell(test.p), plainCell(test.kendalls_w), plainCell(f.f), wholeCell(f.df1),
                            wholeCell(f.df2), plainCell(f.p)});
    }
    return out;
}

namespace {

PlainTable comparisonsTable(const std::string& name, const std::string& caption,
                            const std::vector<Comparison>& comparisons, bool with_factor) {
    std::vector<PlainColumn> columns{{"measure", text, Print::heading}};
    if (with_factor) {
        columns.push_back({"factor", text, Print::heading});
        columns.push_back({"system", text, Print::plain});
    }
    columns.push_back({"a", text, Print::plain});
    columns.push_back({"b", text, Print::plain});
    columns.push_back({"mean_difference", number});
    PlainTable out{name, units::means, caption, withMore(std::move(columns), testColumns())};
    for (const Comparison& one : comparisons) {
        std::vector<PlainCell> row{one.measure};
        if (with_factor) {
            row.emplace_back(one.factor);
            row.emplace_back(one.system);
        }
        row.emplace_back(one.a);
        row.emplace_back(one.b);
        row.push_back(knownCell(one.test.n_pairs > 0, one.mean_difference));
        out.rows.push_back(withMore(std::move(row), testCells(one)));
    }
    return out;
}

}  // namespace

PlainTable pairwiseTable(const AnalysisResult& result) {
    return comparisonsTable("pairwise", "Pairs of systems: signed-rank tests of participants' means",
                            result.pairwise, false);
}

namespace {

PlainTable interactionsTable(const AnalysisResult& result) {
    PlainTable out{"interactions", units::differences,
                   "Differences a - b under c less those under d: signed-rank tests of participants' means",
                   withMore(withMore(contrastColumns(), {{"mean_difference", number}}), testColumns())};
    for (const InteractionResult& one : result.interactions)
        out.rows.push_back(
            withMore(withMore(contrastCells(one), {PlainCell(one.mean_difference)}), testCells(one)));
    return out;
}

}  // namespace

PlainTable preferencesTable(const AnalysisResult& result) {
    PlainTable out{"preferences", units::preferences, "Preferences between systems",
                   withMore<PlainColumn>({{"a", text, Print::plain},
                                          {"b", text, Print::plain},
                                          {"prefers_a", whole, Print::plain, "for A"},
                                          {"equal", whole, Print::plain, "equal"},
                                          {"prefers_b", whole, Print::plain, "for B"},
                                          {"mean", number, Print::plain}},
                                         testColumns())};
    for (const PreferenceResult& pair : result.preferences) {
        std::vector<PlainCell> row{pair.a,
                                   pair.b,
                                   wholeCell(pair.prefers_a),
                                   wholeCell(pair.ties),
                                   wholeCell(pair.prefers_b),
                                   PlainCell(pair.mean)};
        out.rows.push_back(withMore(std::move(row), testCells(pair)));
    }
    return out;
}

namespace {

PlainTable chanceTable(const AnalysisResult& result) {
    PlainTable out{
        "chance", units::means_and_choices,
        "Correct choices and chance: signed-rank tests of participants' means of correct - 1 / balls",
        withMore<PlainColumn>({{"system", text, Print::plain},
                               {"successes", whole, Print::plain, "correct"},
                               {"choices", whole, Print::plain, "of"},
                               {"choices_with_balls", whole},
                               {"estimate", number, Print::plain, "share"},
                               {"chance", number, Print::plain},
                               {"mean_above", number, Print::plain, "above"}},
                              testColumns())};
    for (const ChanceResult& one : result.chance) {
        const bool known = one.n_known > 0;
        std::vector<PlainCell> row{one.system,
                                   wholeCell(one.successes),
                                   wholeCell(one.n),
                                   wholeCell(one.n_known),
                                   knownCell(one.n > 0, static_cast<double>(one.successes) / one.n),
                                   knownCell(known, one.chance),
                                   knownCell(known, one.mean_above)};
        out.rows.push_back(withMore(std::move(row), testCells(one)));
    }
    return out;
}

PlainTable orderTable(const AnalysisResult& result) {
    PlainTable out{"order", units::means, "First and second half of each participant's answers",
                   withMore<PlainColumn>({{"measure", text, Print::plain},
                                          {"first_half", number, Print::plain, "first half"},
                                          {"second_half", number, Print::plain, "second half"}},
                                         testColumns())};
    for (const OrderResult& one : result.order) {
        std::vector<PlainCell> row{one.measure, PlainCell(one.first), PlainCell(one.second)};
        out.rows.push_back(withMore(std::move(row), testCells(one)));
    }
    return out;
}

PlainTable timesTable(const AnalysisResult& result) {
    PlainTable out{"response_times",
                   units::answers,
                   "Response times over answers, seconds",
                   {{"measure", text, Print::heading},
                    {"system", text, Print::plain},
                    {"n", whole, Print::plain, "$n$"},
                    {"q25_s", number, Print::plain, "25 \\%"},
                    {"median_s", number, Print::plain, "median"},
                    {"q75_s", number, Print::plain, "75 \\%"}}};
    for (const TimeResult& one : result.times)
        out.rows.push_back({one.measure, one.system, wholeCell(one.n), PlainCell(one.q25_s),
                            PlainCell(one.median_s), PlainCell(one.q75_s)});
    return out;
}

PlainTable itemsTable(const AnalysisResult& result) {
    PlainTable out{"items",
                   units::answers,
                   "Items over systems and participants",
                   {{"measure", text}, {"item", text}, {"mean", number}, {"answers", whole}}};
    for (const ItemResult& one : result.items)
        out.rows.push_back({one.measure, one.item, PlainCell(one.mean), wholeCell(one.n)});
    return out;
}

PlainTable checksTable(const AnalysisResult& result) {
    PlainTable out{"checks",
                   units::checks,
                   "Attention checks",
                   {{"stage", text, Print::heading},
                    {"kind", text, Print::plain},
                    {"passed", whole, Print::plain},
                    {"failed", whole, Print::plain}}};
    for (const CheckCount& one : result.table.checks)
        out.rows.push_back({one.stage, one.kind, wholeCell(one.passed), wholeCell(one.failed)});
    return out;
}

PlainTable leftOutTable(const AnalysisResult& result) {
    PlainTable out{"left_out",
                   units::participants,
                   "Participants left out",
                   {{"participant", text}, {"why", text}, {"reason", text}}};
    for (const LeftOut& one : result.table.left_out)
        out.rows.push_back({one.participant, std::string(one.dropped ? "dropped" : "excluded"), one.reason});
    return out;
}

/// One line for each participant, measure and system that has answers.
PlainTable participantsTable(const AnalysisResult& result) {
    PlainTable out{
        "participant_means",
        units::means,
        "Participants' means",
        {{"participant", text}, {"measure", text}, {"system", text}, {"mean", number}, {"answers", whole}}};
    for (std::size_t m = 0; m < result.measures.size(); ++m) {
        // Of each system, which participant with answers is next.
        std::vector<std::size_t> next(result.systems.size(), 0);
        for (const PresenceRow& row : result.presence)
            for (std::size_t s = 0; s < result.systems.size(); ++s)
                if (const int answers = row.answers[m][s]; answers > 0)
                    out.rows.push_back({row.participant, result.measures[m].name, result.systems[s].system,
                                        PlainCell(result.systems[s].measures[m].by_participant[next[s]++]),
                                        wholeCell(answers)});
    }
    return out;
}

/// What the tables hang on and do not tell.
PlainTable settingsTable(const AnalysisResult& result) {
    PlainTable out{"settings", units::none, "Settings", {{"name", text}, {"value", number}}};
    const AnalysisOptions& options = result.options;
    out.rows.push_back({"alpha", PlainCell(result.alpha)});
    out.rows.push_back({"level", PlainCell(result.level)});
    out.rows.push_back({"resamples", PlainCell(static_cast<double>(options.resamples))});
    out.rows.push_back({"seed", PlainCell(static_cast<double>(options.seed))});
    return out;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> analysisTables(const AnalysisResult& result,
                                                                TableFormat format) {
    std::vector<PlainTable> tables{
        meansTable(result),
        levelsTable(result),
        omnibusTable(result),
        pairwiseTable(result),
        comparisonsTable("level_tests", "Levels within systems: signed-rank tests of participants' means",
                         result.level_tests, true),
        interactionsTable(result),
        preferencesTable(result),
        bradleyTerryTable(result),
        chanceTable(result),
        orderTable(result),
        timesTable(result),
        checksTable(result)};
    for (PlainTable table : ratingTables(result)) tables.push_back(std::move(table));
    for (PlainTable table : furtherTables(result)) tables.push_back(std::move(table));
    if (!result.by_study.empty())
        for (PlainTable& table : tables)
            if (table.name == "means" || table.name == "omnibus" || table.name == "pairwise" ||
                table.name == "preferences")
                table.caption += ", all studies pooled";
    for (PlainTable table : studyTables(result)) tables.push_back(std::move(table));
    const bool csv = format == TableFormat::csv;
    if (csv)
        for (PlainTable table : {itemsTable(result), leftOutTable(result), participantsTable(result),
                                 qualityTable(result), settingsTable(result)})
            tables.push_back(std::move(table));
    std::vector<std::pair<std::string, std::string>> out;
    for (const PlainTable& table : tables)
        if (!table.rows.empty())
            out.emplace_back(table.name + (csv ? ".csv" : ".tex"), csv ? csvText(table) : latexText(table));
    if (csv && !result.table.rows.empty()) out.emplace_back("answers.csv", answersCsv(result.table));
    return out;
}

}  // namespace deixis::results
