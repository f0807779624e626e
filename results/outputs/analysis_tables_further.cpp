#include "analysis_tables_further.hpp"

#include "analysis_table_parts.hpp"
#include "analysis_tables_studies.hpp"
#include "results/answers/accuracy_by_angle.hpp"
#include "results/outputs/quality_outputs.hpp"

namespace deixis::results {

namespace {

using enum ColumnType;

/// One row for each pair and choice.
PlainTable sensitivityTable(const AnalysisResult& result) {
    PlainTable out{"sensitivity",
                   units::means,
                   "The pairs of systems under other choices",
                   {{"measure", text, Print::heading},
                    {"a", text, Print::plain},
                    {"b", text, Print::plain},
                    {"choice", text, Print::key, "choice"},
                    {"n", whole, Print::plain, "$n$"},
                    {"p", number, Print::p_value, "$p$"},
                    {"p_holm", number, Print::p_value, "$p_\\mathrm{Holm}$"},
                    {"significant", truth},
                    {"changes", truth}}};
    for (const SensitivityResult& one : result.sensitivity) {
        const auto add = [&](const char* choice, const AdjustedTest& test, double p,
                             const std::optional<double>& p_holm, bool changes) {
            out.rows.push_back({one.measure, one.a, one.b, std::string(choice), wholeCell(test.test.n_pairs),
                                knownCell(test.test.n_pairs > 0, p), plainCell(p_holm),
                                PlainCell(p_holm && *p_holm <= result.alpha), PlainCell(changes)});
        };
        const AdjustedTest& head = one.headline;
        add("headline", head, head.test.p_two_sided, head.p_holm, false);
        add("pratt", head, head.test.pratt_p_two_sided, head.p_holm_pratt, head.depends_on_zeros);
        add("normal", head, head.test.normal_p_two_sided, head.p_holm_normal, head.depends_on_approximation);
        for (const SensitivityResult::Other& other : one.others)
            add(nameOf(other.choice), other.test, other.test.test.p_two_sided, other.test.p_holm,
                other.changes);
    }
    return out;
}

/// Choices that were not made.
PlainTable unansweredTable(const AnalysisResult& result) {
    PlainTable out{"unanswered",
                   units::means_and_choices,
                   "Choices that were not made",
                   {{"system", text, Print::plain},
                    {"answered", whole, Print::plain},
                    {"timed_out", whole, Print::plain, "timed out"},
                    {"skipped", whole, Print::plain},
                    {"headline", number, Print::plain},
                    {"answered_only", number, Print::plain, "answered only"},
                    {"unanswered_wrong", number, Print::plain, "all others wrong"}}};
    for (const UnansweredResult& one : result.unanswered)
        out.rows.push_back({one.system, wholeCell(one.answered), wholeCell(one.timed_out),
                            wholeCell(one.skipped), plainCell(one.headline), plainCell(one.answered_only),
                            plainCell(one.unanswered_wrong)});
    return out;
}

}  // namespace

PlainTable betweenTable(const AnalysisResult& result) {
    PlainTable out{"between", units::means, "Groups of participants: rank-sum tests of participants' means",
                   withMore<PlainColumn>({{"measure", text, Print::heading},
                                          {"factor", text, Print::heading},
                                          {"system", text, Print::plain},
                                          {"a", text, Print::plain},
                                          {"b", text, Print::plain}},
                                         groupColumns())};
    for (const BetweenResult& one : result.between)
        out.rows.push_back(withMore({one.measure, one.factor, one.system, one.a, one.b}, groupCells(one)));
    return out;
}

namespace {

PlainTable preferencesBetweenTable(const AnalysisResult& result) {
    PlainTable out{"preferences_between", units::preferences,
                   "Groups of participants: preferences for system over other system (shares of answers), "
                   "rank-sum tests of participants' net preferences",
                   withMore<PlainColumn>({{"factor", text, Print::heading},
                                          {"system", text, Print::plain},
                                          {"other_system", text, Print::plain, "other system"},
                                          {"a", text, Print::plain},
                                          {"b", text, Print::plain},
                                          {"answers_a", whole},
                                          {"wins_a", number, Print::plain, "wins A"},
                                          {"ties_a", number},
                                          {"losses_a", number, Print::plain, "losses A"},
                                          {"answers_b", whole},
                                          {"wins_b", number, Print::plain, "wins B"},
                                          {"ties_b", number},
                                          {"losses_b", number, Print::plain, "losses B"}},
                                         groupColumns())};
    for (const PreferenceBetweenResult& one : result.preferences_between) {
        std::vector<PlainCell> row{one.factor, one.system, one.other_system, one.a, one.b};
        for (const PreferenceCounts& counts : {one.answers_a, one.answers_b}) {
            row.push_back(wholeCell(counts.answers()));
            for (const int of : {counts.wins, counts.ties, counts.losses})
                row.push_back(plainCell(counts.share(of)));
        }
        out.rows.push_back(withMore(std::move(row), groupCells(one)));
    }
    return out;
}

PlainTable groupInteractionsTable(const AnalysisResult& result) {
    PlainTable out{
        "group_interactions", units::differences,
        "Differences c - d between the groups a and b: rank-sum tests of participants' differences",
        withMore(contrastColumns(), groupColumns())};
    for (const GroupInteractionResult& one : result.group_interactions)
        out.rows.push_back(withMore(contrastCells(one), groupCells(one)));
    return out;
}

PlainTable equivalenceTable(const AnalysisResult& result) {
    PlainTable out{"equivalence",
                   units::means,
                   "Equivalence within bounds that were declared before: two one-sided tests",
                   {{"measure", text, Print::heading},
                    {"factor", text, Print::heading},
                    {"system", text, Print::plain},
                    {"a", text, Print::plain},
                    {"b", text, Print::plain},
                    {"bound", number, Print::plain},
                    {"p", number, Print::p_value, "$p$"},
                    {"p_holm", number, Print::p_value, "$p_\\mathrm{Holm}$"},
                    {"equivalent", truth},
                    {"family", text}}};
    const auto add = [&](const auto& one, const std::string& factor) {
        if (const auto& found = one.equivalence; found)
            out.rows.push_back({one.measure, factor, one.system, one.a, one.b, PlainCell(found->bound),
                                PlainCell(found->p), PlainCell(found->p_holm), PlainCell(found->equivalent),
                                one.family});
    };
    for (const auto* tests : {&result.pairwise, &result.level_tests})
        for (const Comparison& one : *tests) add(one, one.factor);
    for (const BetweenResult& one : result.between) add(one, one.factor);
    return out;
}

PlainTable confusionTable(const AnalysisResult& result) {
    PlainTable out{"confusion",
                   units::choices,
                   "Which balls were chosen",
                   {{"system", text, Print::plain},
                    {"role", text, Print::plain, "ball"},
                    {"chosen", whole, Print::plain},
                    {"shown", whole, Print::plain},
                    {"share", number, Print::plain}}};
    for (const ConfusionResult& one : result.confusion)
        out.rows.push_back({one.system, one.role, wholeCell(one.chosen), wholeCell(one.shown),
                            PlainCell(static_cast<double>(one.chosen) / one.shown)});
    return out;
}

PlainTable anglesTable(const AnalysisResult& result) {
    PlainTable out{"angles",
                   units::choices,
                   "Correct choices by the angle from the target to the distractor that looks nearest",
                   {{"eyes", text, Print::plain},
                    {"system", text, Print::plain},
                    {"from_deg", number, Print::plain, "from (deg)"},
                    {"below_deg", number, Print::plain, "below (deg)"},
                    {"right", whole, Print::plain},
                    {"choices", whole, Print::plain}}};
    for (const AngleResult& one : accuracyByAngle(result.table))
        out.rows.push_back({one.eyes, one.system, PlainCell(one.from_deg), plainCell(one.below_deg),
                            wholeCell(one.right), wholeCell(one.choices)});
    return out;
}

PlainTable observersTable(const AnalysisResult& result) {
    PlainTable out{"observers",
                   units::trials,
                   "Correct choices that simulated observers are expected to make; no evidence about people",
                   {{"system", text, Print::plain},
                    {"layout", text, Print::plain},
                    {"observer", text, Print::plain},
                    {"choices", number},
                    {"accuracy", number, Print::plain},
                    {"without_error", number, Print::plain, "without error"}}};
    for (const ObserverReading& one : result.observers)
        for (std::size_t i = 0; i < observer_names.size(); ++i)
            out.rows.push_back({one.system, one.layout, std::string(observer_names[i]), PlainCell(one.trials),
                                PlainCell(one.accuracy[i]), PlainCell(one.without_error[i])});
    return out;
}

PlainTable driftTable(const AnalysisResult& result) {
    PlainTable out{"drift",
                   units::choices,
                   "Choices of the ball nearest to the arm when the hold began and when it ended",
                   {{"system", text, Print::plain},
                    {"line", text, Print::plain},
                    {"choices", whole, Print::plain},
                    {"of_first", whole, Print::plain, "at first"},
                    {"of_last", whole, Print::plain, "at last"},
                    {"moved", whole, Print::plain, "two balls"},
                    {"moved_first", whole, Print::plain, "the first"},
                    {"moved_last", whole, Print::plain, "the last"}}};
    for (const DriftResult& one : result.drift)
        out.rows.push_back({one.system, one.line, wholeCell(one.choices), wholeCell(one.of_first),
                            wholeCell(one.of_last), wholeCell(one.moved), wholeCell(one.moved_first),
                            wholeCell(one.moved_last)});
    return out;
}

PlainTable targetSpaceTable(const AnalysisResult& result) {
    PlainTable out{"target_space",
                   units::choices,
                   "Correct choices by the target's place",
                   {{"system", text, Print::heading},
                    {"item", text, Print::plain},
                    {"x_m", number, Print::plain, "$x$ (m)"},
                    {"y_m", number, Print::plain, "$y$ (m)"},
                    {"z_m", number, Print::plain, "$z$ (m)"},
                    {"mean", number, Print::plain, "correct"},
                    {"n", whole, Print::plain, "$n$"}}};
    for (const TargetPlace& one : result.target_space)
        out.rows.push_back({one.system, one.target_id, PlainCell(one.position_m.x),
                            PlainCell(one.position_m.y), PlainCell(one.position_m.z), PlainCell(one.mean),
                            wholeCell(one.n)});
    return out;
}

PlainTable pooledTable(const AnalysisResult& result) {
    PlainTable out{"pooled_ratings",
                   units::ratings,
                   "Ratings taken one by one (pseudo-replicated)",
                   {{"measure", text, Print::heading},
                    {"system", text, Print::plain},
                    {"n", whole, Print::plain, "$n$"},
                    {"mean", number, Print::plain},
                    {"sd", number, Print::plain, "SD"},
                    {"q05", number, Print::plain, "5 \\%"},
                    {"q25", number, Print::plain, "25 \\%"},
                    {"median", number, Print::plain},
                    {"q75", number, Print::plain, "75 \\%"},
                    {"q95", number, Print::plain, "95 \\%"}}};
    for (const PooledResult& one : result.pooled)
        out.rows.push_back({one.measure, one.system, wholeCell(one.n), PlainCell(one.mean),
                            knownCell(one.n > 1, one.sd), PlainCell(one.q05), PlainCell(one.q25),
                            PlainCell(one.median), PlainCell(one.q75), PlainCell(one.q95)});
    return out;
}

PlainTable scoresTable(const AnalysisResult& result) {
    PlainTable out{"scores",
                   units::scores,
                   "Scores of questionnaires over participants",
                   {{"stage", text, Print::heading},
                    {"score", text, Print::plain},
                    {"factor", text, Print::heading},
                    {"level", text, Print::plain},
                    {"mean", number, Print::plain},
                    {"sd", number, Print::plain, "SD"},
                    {"n", whole, Print::plain, "$n$"},
                    {"q25", number, Print::plain, "25 \\%"},
                    {"median", number, Print::plain},
                    {"q75", number, Print::plain, "75 \\%"}}};
    for (const ScoreResult& one : result.scores)
        out.rows.push_back({one.stage, one.score, one.factor, one.level, PlainCell(one.mean),
                            knownCell(one.n > 1, one.sd), wholeCell(one.n), PlainCell(one.q25),
                            PlainCell(one.median), PlainCell(one.q75)});
    return out;
}

}  // namespace

std::vector<PlainTable> furtherTables(const AnalysisResult& result) {
    return {groupInteractionsTable(result),
            equivalenceTable(result),
            sensitivityTable(result),
            unansweredTable(result),
            betweenTable(result),
            preferencesBetweenTable(result),
            confusionTable(result),
            driftTable(result),
            observersTable(result),
            anglesTable(result),
            targetSpaceTable(result),
            pooledTable(result),
            scoresTable(result),
            reliabilityTable(result)};
}

}  // namespace deixis::results
