#include "results/analysis_tables.hpp"

#include <fmt/format.h>

#include <map>

#include "analysis_tables_further.hpp"
#include "answers_csv.hpp"
#include "bradley_terry_outputs.hpp"
#include "plain_table.hpp"

namespace deixis::results {

namespace {

using enum ColumnType;

PlainCell count(std::size_t n) {
    return static_cast<long long>(n);
}

PlainCell count(int n) {
    return static_cast<long long>(n);
}

PlainTable meansTable(const AnalysisResult& result) {
    PlainTable out{
        "means",
        fmt::format("Means of participants' means, {:g} % bootstrap intervals over participants, and "
                    "standard deviations",
                    100.0 * result.level),
        {{"measure", text, Print::plain},
         {"system", text, Print::plain},
         {"mean", number, Print::plain, "mean"},
         {"median", number},
         {"lower", number, Print::plain, "lower"},
         {"upper", number, Print::plain, "upper"},
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
                                knownCell(one.n > 1, one.sd_trials), count(people), count(one.n)});
        }
    return out;
}

PlainTable levelsTable(const AnalysisResult& result) {
    PlainTable out{"levels",
                   "Means and standard deviations over trials, by the levels of within factors",
                   {{"measure", text, Print::plain},
                    {"factor", text, Print::plain},
                    {"system", text, Print::plain},
                    {"level", text, Print::plain},
                    {"mean", number, Print::plain},
                    {"sd_trials", number, Print::plain, "SD (trials)"},
                    {"answers", whole, Print::plain}}};
    for (const LevelResult& row : result.levels)
        out.rows.push_back({row.measure, row.factor, row.system, row.level, knownCell(row.n > 0, row.mean),
                            knownCell(row.n > 1, row.sd_trials), count(row.n)});
    return out;
}

PlainTable omnibusTable(const AnalysisResult& result) {
    PlainTable out{"omnibus",
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
        out.rows.push_back({one.measure, count(test.n), plainCell(test.chi2), count(test.df),
                            plainCell(test.p), plainCell(test.kendalls_w), plainCell(f.f), count(f.df1),
                            count(f.df2), plainCell(f.p)});
    }
    return out;
}

std::vector<PlainColumn> testColumns() {
    return {{"n", whole, Print::plain, "$n$"},
            {"n_zero", whole, Print::plain, "zeros"},
            {"n_positive", whole},
            {"n_negative", whole},
            {"ties", whole},
            {"w_plus", number, Print::plain, "$W^+$"},
            {"w_minus", number, Print::plain, "$W^-$"},
            {"z", number},
            {"p", number, Print::p_value, "$p$"},
            {"p_holm", number, Print::p_value, "$p_\\mathrm{Holm}$"},
            {"p_normal", number},
            {"p_pratt", number},
            {"p_holm_pratt", number},
            {"p_holm_normal", number},
            {"smallest_p", number},
            {"significant", truth},
            {"depends_on_zeros", truth},
            {"out_of_reach", truth},
            {"hodges_lehmann", number, Print::plain, "shift"},
            {"hodges_lehmann_lower", number, Print::plain, "lower"},
            {"hodges_lehmann_upper", number, Print::plain, "upper"},
            {"hodges_lehmann_lower_included", truth},
            {"hodges_lehmann_upper_included", truth},
            {"hodges_lehmann_level", number},
            {"rank_biserial", number, Print::plain, "$r$"},
            {"paired_superiority", number},
            {"shapiro_w", number},
            {"shapiro_p", number},
            {"method", text},
            {"family", text},
            {"family_size", whole}};
}

void addTest(std::vector<PlainCell>& row, const AdjustedTest& one) {
    const SignedRankTest& test = one.test;
    const bool tested = test.n_pairs > 0;
    const HodgesLehmann& shift = test.hodges_lehmann;
    for (PlainCell cell : {count(test.n_pairs),
                           count(test.n_zero),
                           count(test.n_positive),
                           count(test.n_negative),
                           count(test.ties),
                           PlainCell(test.w_plus),
                           PlainCell(test.w_minus),
                           plainCell(test.z),
                           knownCell(tested, test.p_two_sided),
                           plainCell(one.p_holm),
                           knownCell(tested, test.normal_p_two_sided),
                           knownCell(tested, test.pratt_p_two_sided),
                           plainCell(one.p_holm_pratt),
                           plainCell(one.p_holm_normal),
                           knownCell(tested, test.smallest_p),
                           PlainCell(one.significant),
                           PlainCell(one.depends_on_zeros),
                           PlainCell(one.out_of_reach),
                           plainCell(shift.estimate),
                           plainCell(shift.lower),
                           plainCell(shift.upper),
                           PlainCell(shift.lower_included),
                           PlainCell(shift.upper_included),
                           plainCell(shift.level),
                           plainCell(test.rank_biserial),
                           plainCell(test.paired_superiority),
                           plainCell(one.normality.w),
                           plainCell(one.normality.p),
                           PlainCell(test.method),
                           PlainCell(one.family),
                           count(one.family_size)})
        row.push_back(std::move(cell));
}

void append(std::vector<PlainColumn>& to, std::vector<PlainColumn> more) {
    for (PlainColumn& column : more) to.push_back(std::move(column));
}

PlainTable comparisonsTable(const std::string& name, const std::string& caption,
                            const std::vector<Comparison>& comparisons, bool with_factor) {
    PlainTable out{name, caption, {{"measure", text, Print::plain}}};
    if (with_factor) append(out.columns, {{"factor", text, Print::plain}, {"system", text, Print::plain}});
    append(out.columns, {{"a", text, Print::plain}, {"b", text, Print::plain}, {"mean_difference", number}});
    append(out.columns, testColumns());
    for (const Comparison& one : comparisons) {
        std::vector<PlainCell> row{one.measure};
        if (with_factor) {
            row.emplace_back(one.factor);
            row.emplace_back(one.system);
        }
        row.emplace_back(one.a);
        row.emplace_back(one.b);
        row.push_back(knownCell(one.test.n_pairs > 0, one.mean_difference));
        addTest(row, one);
        out.rows.push_back(std::move(row));
    }
    return out;
}

PlainTable interactionsTable(const AnalysisResult& result) {
    PlainTable out{"interactions",
                   "Differences a - b under c less those under d: signed-rank tests of participants' means",
                   {{"measure", text, Print::plain},
                    {"factor", text, Print::plain},
                    {"a", text, Print::plain},
                    {"b", text, Print::plain},
                    {"other_factor", text, Print::plain, "other factor"},
                    {"c", text, Print::plain},
                    {"d", text, Print::plain},
                    {"mean_difference", number}}};
    append(out.columns, testColumns());
    for (const InteractionResult& one : result.interactions) {
        std::vector<PlainCell> row{one.measure,      one.factor, one.a, one.b,
                                   one.other_factor, one.c,      one.d, PlainCell(one.mean_difference)};
        addTest(row, one);
        out.rows.push_back(std::move(row));
    }
    return out;
}

PlainTable preferencesTable(const AnalysisResult& result) {
    PlainTable out{"preferences",
                   "Preferences between systems",
                   {{"a", text, Print::plain},
                    {"b", text, Print::plain},
                    {"prefers_a", whole, Print::plain, "for A"},
                    {"equal", whole, Print::plain, "equal"},
                    {"prefers_b", whole, Print::plain, "for B"},
                    {"mean", number, Print::plain}}};
    append(out.columns, testColumns());
    for (const PreferenceResult& pair : result.preferences) {
        std::vector<PlainCell> row{pair.a,
                                   pair.b,
                                   count(pair.prefers_a),
                                   count(pair.ties),
                                   count(pair.prefers_b),
                                   PlainCell(pair.mean)};
        addTest(row, pair);
        out.rows.push_back(std::move(row));
    }
    return out;
}

PlainTable chanceTable(const AnalysisResult& result) {
    PlainTable out{
        "chance",
        "Right choices and chance: signed-rank tests of participants' means of correct - 1 / balls",
        {{"system", text, Print::plain},
         {"successes", whole, Print::plain, "right"},
         {"choices", whole, Print::plain, "of"},
         {"choices_with_balls", whole},
         {"estimate", number, Print::plain, "share"},
         {"chance", number, Print::plain},
         {"mean_above", number, Print::plain, "above"}}};
    append(out.columns, testColumns());
    for (const ChanceResult& one : result.chance) {
        const bool known = one.n_known > 0;
        std::vector<PlainCell> row{one.system,
                                   count(one.successes),
                                   count(one.n),
                                   count(one.n_known),
                                   knownCell(one.n > 0, static_cast<double>(one.successes) / one.n),
                                   knownCell(known, one.chance),
                                   knownCell(known, one.mean_above)};
        addTest(row, one);
        out.rows.push_back(std::move(row));
    }
    return out;
}

PlainTable orderTable(const AnalysisResult& result) {
    PlainTable out{"order",
                   "First and second half of each participant's answers",
                   {{"measure", text, Print::plain},
                    {"first_half", number, Print::plain, "first half"},
                    {"second_half", number, Print::plain, "second half"}}};
    append(out.columns, testColumns());
    for (const OrderResult& one : result.order) {
        std::vector<PlainCell> row{one.measure, PlainCell(one.first), PlainCell(one.second)};
        addTest(row, one);
        out.rows.push_back(std::move(row));
    }
    return out;
}

PlainTable timesTable(const AnalysisResult& result) {
    PlainTable out{"response_times",
                   "Response times over answers, seconds",
                   {{"measure", text, Print::plain},
                    {"system", text, Print::plain},
                    {"n", whole, Print::plain, "$n$"},
                    {"q25_s", number, Print::plain, "25 \\%"},
                    {"median_s", number, Print::plain, "median"},
                    {"q75_s", number, Print::plain, "75 \\%"}}};
    for (const TimeResult& one : result.times)
        out.rows.push_back({one.measure, one.system, count(one.n), PlainCell(one.q25_s),
                            PlainCell(one.median_s), PlainCell(one.q75_s)});
    return out;
}

PlainTable itemsTable(const AnalysisResult& result) {
    PlainTable out{"items",
                   "Items over systems and participants",
                   {{"measure", text}, {"item", text}, {"mean", number}, {"answers", whole}}};
    for (const ItemResult& one : result.items)
        out.rows.push_back({one.measure, one.item, PlainCell(one.mean), count(one.n)});
    return out;
}

PlainTable checksTable(const AnalysisResult& result) {
    PlainTable out{"checks",
                   "Attention checks",
                   {{"stage", text, Print::plain},
                    {"kind", text, Print::plain},
                    {"passed", whole, Print::plain},
                    {"failed", whole, Print::plain}}};
    for (const CheckCount& one : result.table.checks)
        out.rows.push_back({one.stage, one.kind, count(one.passed), count(one.failed)});
    return out;
}

PlainTable leftOutTable(const AnalysisResult& result) {
    PlainTable out{
        "left_out", "Participants left out", {{"participant", text}, {"why", text}, {"reason", text}}};
    for (const LeftOut& one : result.table.left_out)
        out.rows.push_back({one.participant, std::string(one.dropped ? "dropped" : "excluded"), one.reason});
    return out;
}

/// One line for each participant, measure and system that has answers.
PlainTable participantsTable(const AnalysisResult& result) {
    PlainTable out{
        "participant_means",
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
                                        count(answers)});
    }
    return out;
}

/// What the tables hang on and do not tell.
PlainTable settingsTable(const AnalysisResult& result) {
    PlainTable out{"settings", "Settings", {{"name", text}, {"value", number}}};
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
        comparisonsTable("pairwise", "Pairs of systems: signed-rank tests of participants' means",
                         result.pairwise, false),
        comparisonsTable("level_tests", "Levels within systems: signed-rank tests of participants' means",
                         result.level_tests, true),
        interactionsTable(result),
        preferencesTable(result),
        bradleyTerryTable(result),
        chanceTable(result),
        orderTable(result),
        timesTable(result),
        checksTable(result)};
    for (PlainTable table : furtherTables(result)) tables.push_back(std::move(table));
    const bool csv = format == TableFormat::csv;
    if (csv)
        for (PlainTable table :
             {itemsTable(result), leftOutTable(result), participantsTable(result), settingsTable(result)})
            tables.push_back(std::move(table));
    std::vector<std::pair<std::string, std::string>> out;
    for (const PlainTable& table : tables)
        if (!table.rows.empty())
            out.emplace_back(table.name + (csv ? ".csv" : ".tex"), csv ? csvText(table) : latexText(table));
    if (csv && !result.table.rows.empty()) out.emplace_back("answers.csv", answersCsv(result.table));
    return out;
}

}  // namespace deixis::results
