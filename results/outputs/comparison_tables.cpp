// Tables of what is compared: systems, levels, groups of participants, preferences.
#include <fmt/format.h>

#include "results/outputs/analysis_tables.hpp"
#include "test_fields.hpp"

namespace deixis::results::tables {

namespace {

constexpr const char* pseudo_replicated = "pseudo-replicated: ratings treated as independent";
const Show heading{.heading = true};
const Show in_files{.in = in_data};

Table comparisons(const AnalysisResult& result, const char* name, const char* caption,
                  const std::vector<Comparison>& of, bool of_levels) {
    const unsigned in = of_levels ? everywhere : page_only;
    Fields<Comparison> fields{
        {"measure", &Comparison::measure, heading},
        {"factor", &Comparison::factor, {.in = in, .heading = true}},
        {"system", &Comparison::system, {.in = in}},
        {"a", &Comparison::a},
        {"b", &Comparison::b},
        {"mean_difference", [](auto& one) { return known(one.test.n_pairs > 0, one.mean_difference); },
         in_files}};
    return withScales(tableOf(name, units::means, caption, joined(std::move(fields), testFields(result)), of),
                      result);
}

/// Which difference is compared under which levels.
template <typename Row>
Fields<Row> contrastFields() {
    return {{"measure", &Row::measure, heading},
            {"factor", &Row::factor, heading},
            {"a", &Row::a},
            {"b", &Row::b},
            {"other_factor", &Row::other_factor, heading},
            {"c", &Row::c},
            {"d", &Row::d}};
}

/// As the tests' columns, with Z in print, and without the interval, which is not computed.
Table withZ(Table table) {
    Column& z = table.column("z");
    z.in = everywhere;
    z.latex = "$Z$";
    z.label = "|Z|";
    z.format = Format::magnitude;
    table.column("hodges_lehmann").ends_in_print = false;
    return table;
}

template <typename Row>
Fields<Row> pairFields() {
    return {{"a", &Row::a}, {"b", &Row::b}, {"median_a", &Row::median_a}, {"median_b", &Row::median_b}};
}

template <typename Row>
Fields<Row> trialFields() {
    return joined<Row>({{"measure", &Row::measure, heading}, {"system", &Row::system}}, pairFields<Row>());
}

}  // namespace

Table omnibus(const AnalysisResult& result) {
    const auto of = [](auto member) { return [=](const OmnibusResult& one) { return one.test.*member; }; };
    const auto iman = [](auto member) {
        return [=](const OmnibusResult& one) { return one.test.iman_davenport.*member; };
    };
    const auto ranks = [&result](const OmnibusResult& one) {
        Json out = Json::object();
        for (std::size_t i = 0; i < one.test.mean_ranks.size(); ++i)
            out[result.table.systems[i]] = one.test.mean_ranks[i];
        return out;
    };
    return tableOf<OmnibusResult>(
        "omnibus", units::means, "Friedman's test over all systems",
        {{"measure", &OmnibusResult::measure},
         {"test", [](auto&) { return "Friedman"; }, {.in = in_json}},
         {"n", of(&FriedmanTest::n)},
         {"n_missing", [&](auto& one) { return result.participants - one.test.n; }, {.in = in_json}},
         {"ties", of(&FriedmanTest::ties), {.in = in_json}},
         {"mean_ranks", ranks, {.in = in_json}},
         {"chi2", of(&FriedmanTest::chi2)},
         {"df", of(&FriedmanTest::df)},
         {"p", of(&FriedmanTest::p)},
         {"kendalls_w", of(&FriedmanTest::kendalls_w), {.format = Format::three_decimals}},
         {"f", iman(&ImanDavenport::f), {.json = "iman_davenport/f"}},
         {"df1", iman(&ImanDavenport::df1), {.json = "iman_davenport/df1"}},
         {"df2", iman(&ImanDavenport::df2), {.json = "iman_davenport/df2"}},
         {"p_f", iman(&ImanDavenport::p), {.json = "iman_davenport/p"}},
         {"f_or_infinite",
          [](auto& one) {
              const auto& f = one.test.iman_davenport.f;
              return f ? fmt::format("{:.2f}", *f) : std::string("\u221e");
          },
          {.label = "F (Iman\u2013Davenport)", .in = page_only, .right = true}},
         {"both_df",
          [](auto& one) {
              return fmt::format("{}, {}", one.test.iman_davenport.df1, one.test.iman_davenport.df2);
          },
          {.label = "df", .in = page_only, .right = true}}},
        result.omnibus);
}

Table pairwise(const AnalysisResult& result) {
    return comparisons(result, "pairwise", "Pairs of systems: signed-rank tests of participants' means",
                       result.pairwise, false);
}

Table levelTests(const AnalysisResult& result) {
    return comparisons(result, "level_tests",
                       "Levels within systems: signed-rank tests of participants' means", result.level_tests,
                       true);
}

Table timeTests(const AnalysisResult& result) {
    Table out = comparisons(result, "response_time_tests", "", result.time_tests, false);
    out.unit = units::median_times;
    for (Table::Row& row : out.rows) row.percent = false;  // seconds
    return out;
}

Table interactions(const AnalysisResult& result) {
    auto fields = contrastFields<InteractionResult>();
    fields.push_back({"mean_difference", &InteractionResult::mean_difference, in_files});
    return withScales(
        tableOf("interactions", units::differences,
                "Differences a - b under c minus those under d: signed-rank tests of participants' means",
                joined(std::move(fields), testFields(result)), result.interactions),
        result);
}

Table groupInteractions(const AnalysisResult& result) {
    return withScales(
        tableOf("group_interactions", units::differences,
                "Differences c - d between the groups a and b: rank-sum tests of participants' differences",
                joined(contrastFields<GroupInteractionResult>(), groupFields(result)),
                result.group_interactions),
        result);
}

Table preferences(const AnalysisResult& result) {
    return tableOf("preferences", units::preferences, "Preferences between systems",
                   joined<PreferenceResult>({{"a", &PreferenceResult::a},
                                             {"b", &PreferenceResult::b},
                                             {"prefers_a", &PreferenceResult::prefers_a, {"for A", "for A"}},
                                             {"equal", &PreferenceResult::ties, {.json = "ties"}},
                                             {"prefers_b", &PreferenceResult::prefers_b, {"for B", "for B"}},
                                             {"mean", &PreferenceResult::mean}},
                                            testFields(result)),
                   result.preferences);
}

Table abilities(const AnalysisResult& result) {
    const auto print = [](const char* latex) { return Show{.latex = latex, .in = in_csv | in_print}; };
    using Ends = std::optional<BootstrapInterval>;
    const auto lower = [](Ends Ability::*of) {
        return [=](const Ability& one) { return intervalOf(one.*of).lower; };
    };
    const auto upper = [](Ends Ability::*of) {
        return [=](const Ability& one) { return intervalOf(one.*of).upper; };
    };
    const auto ends = [](Ends Ability::*of) {
        return [=](const Ability& one) { return intervalOf(one.*of); };
    };
    return tableOf<Ability>(
        "bradley_terry", units::single_preferences,
        "Abilities from preferences (Bradley and Terry); log odds, mean 0",
        {{"system", &Ability::system},
         {"ability", &Ability::estimate, {.label = "Ability"}},
         {"bca", ends(&Ability::bca), {.label = "BCa", .in = in_json}},
         {"bca_lower", lower(&Ability::bca), print("BCa from")},
         {"bca_upper", upper(&Ability::bca), print("to")},
         {"percentile", ends(&Ability::percentile), {.label = "Percentiles", .in = in_json}},
         {"percentile_lower", lower(&Ability::percentile), print("percentile from")},
         {"percentile_upper", upper(&Ability::percentile), print("to")},
         {"wins", &Ability::wins},
         {"ties", &Ability::ties},
         {"losses", &Ability::losses}},
        result.bradley_terry.abilities);
}

Table order(const AnalysisResult& result) {
    return withScales(
        tableOf(
            "order", units::means, "First and second half of each participant's answers",
            joined<OrderResult>(
                {{"measure", &OrderResult::measure},
                 {"first_half", &OrderResult::first, {.label = "First half", .format = Format::score}},
                 {"second_half", &OrderResult::second, {.label = "Second half", .format = Format::score}}},
                testFields(result)),
            result.order),
        result);
}

namespace {

struct EquivalenceRow {
    std::string measure, factor, system, a, b, family;
    Equivalence of;
    bool significant = false;
};

}  // namespace

Table equivalence(const AnalysisResult& result) {
    std::vector<EquivalenceRow> rows;
    const auto add = [&](const auto& one) {
        if (const auto& found = one.equivalence)
            rows.push_back(
                {one.measure, one.factor, one.system, one.a, one.b, one.family, *found, found->equivalent});
    };
    for (const auto* tests : {&result.pairwise, &result.level_tests})
        for (const Comparison& one : *tests) add(one);
    for (const BetweenResult& one : result.between) add(one);
    return withScales(
        tableOf<EquivalenceRow>("equivalence", units::means,
                                "Equivalence within bounds declared in advance: two one-sided tests",
                                {{"measure", &EquivalenceRow::measure, heading},
                                 {"factor", &EquivalenceRow::factor, heading},
                                 {"system", &EquivalenceRow::system},
                                 {"where",
                                  [](auto& one) {
                                      if (one.factor.empty()) return std::string("systems");
                                      return one.factor + (one.system == "all" ? "" : ", " + one.system);
                                  },
                                  {.label = "Of", .in = page_only}},
                                 {"a", &EquivalenceRow::a},
                                 {"b", &EquivalenceRow::b},
                                 {"bound", [](auto& one) { return one.of.bound; }},
                                 {"p", [](auto& one) { return one.of.p; }},
                                 {"p_holm", [](auto& one) { return one.of.p_holm; }},
                                 {"equivalent", &EquivalenceRow::significant, in_files},
                                 {"family", &EquivalenceRow::family, in_files},
                                 {"verdict",
                                  [](auto& one) { return one.significant ? "equivalent" : "not shown"; },
                                  {.in = page_only, .marked = true}}},
                                rows),
        result);
}

namespace {

struct Decision {
    const SensitivityResult* of = nullptr;
    const char* choice = "";
    const AdjustedTest* test = nullptr;
    double p = 1.0;
    std::optional<double> p_holm;
    bool changes = false;
};

std::vector<Decision> decisionsOf(const SensitivityResult& one) {
    const AdjustedTest& head = one.headline;
    const SignedRankTest& test = head.test;
    std::vector<Decision> out{
        {&one, "headline", &head, test.p_two_sided, head.p_holm, false},
        {&one, "pratt", &head, test.pratt_p_two_sided, head.p_holm_pratt, head.depends_on_zeros},
        {&one, "normal", &head, test.normal_p_two_sided, head.p_holm_normal, head.depends_on_approximation}};
    for (const SensitivityResult::Other& other : one.others)
        out.push_back({&one, nameOf(other.choice), &other.test, other.test.test.p_two_sided,
                       other.test.p_holm, other.changes});
    return out;
}

}  // namespace

Table sensitivity(const AnalysisResult& result) {
    std::vector<Decision> rows;
    for (const SensitivityResult& one : result.sensitivity)
        for (const Decision& decision : decisionsOf(one)) rows.push_back(decision);
    const Show before{.in = in_csv | in_print};
    return tableOf<Decision>(
        "sensitivity", units::means, "The pairs of systems under other choices",
        {{"measure", [](auto& one) { return one.of->measure; }, {.in = in_csv | in_print, .heading = true}},
         {"a", [](auto& one) { return one.of->a; }, before},
         {"b", [](auto& one) { return one.of->b; }, before},
         {"choice", &Decision::choice, before},
         {"n", [](auto& one) { return one.test->test.n_pairs; }},
         {"p", [](auto& one) { return known(one.test->test.n_pairs > 0, one.p); }},
         {"p_holm", &Decision::p_holm},
         {"significant", [alpha = result.alpha](auto& one) { return one.p_holm && *one.p_holm <= alpha; },
          in_files},
         {"changes", &Decision::changes, {.in = in_csv}}},
        rows);
}

Table between(const AnalysisResult& result) {
    return withScales(
        tableOf("between", units::means, "Groups of participants: rank-sum tests of participants' means",
                joined<BetweenResult>({{"measure", &BetweenResult::measure, heading},
                                       {"factor", &BetweenResult::factor, heading},
                                       {"system", &BetweenResult::system},
                                       {"a", &BetweenResult::a},
                                       {"b", &BetweenResult::b}},
                                      groupFields(result)),
                result.between),
        result);
}

Table timeGroups(const AnalysisResult& result) {
    return tableOf("response_time_groups", units::median_times, "",
                   joined<BetweenResult>({{"measure", &BetweenResult::measure},
                                          {"factor", &BetweenResult::factor},
                                          {"a", &BetweenResult::a},
                                          {"b", &BetweenResult::b}},
                                         groupFields(result)),
                   result.time_groups);
}

namespace {

std::string sharesText(const PreferenceCounts& counts) {
    if (counts.answers() == 0) return "\u2013";
    const auto percent = [&](int of) { return 100.0 * *counts.share(of); };
    return fmt::format("{:.0f} / {:.0f} / {:.0f}\u00a0%", percent(counts.wins), percent(counts.ties),
                       percent(counts.losses));
}

using BetweenRow = PreferenceBetweenResult;

/// A group's answers; the names of the columns end in its letter.
Fields<BetweenRow> answersFields(PreferenceCounts BetweenRow::*of, const std::string& group) {
    const auto share = [=](int PreferenceCounts::*which) {
        return [=](const BetweenRow& one) { return (one.*of).share(one.*of.*which); };
    };
    const std::string inner = "answers_" + group + "/";
    const std::string capital = group == "a" ? " A" : " B";
    Fields<BetweenRow> out{
        {"answers_", [=](auto& one) { return (one.*of).answers(); }, {.in = in_data, .json = "n"}},
        {"wins_", share(&PreferenceCounts::wins), {.latex = "wins", .json = "wins"}},
        {"ties_", share(&PreferenceCounts::ties), {.in = in_data, .json = "ties"}},
        {"losses_", share(&PreferenceCounts::losses), {.latex = "losses", .json = "losses"}}};
    for (Field<BetweenRow>& field : out) {
        field.column.name += group;
        field.column.json = inner + field.column.json;
        field.column.latex += capital;
    }
    return out;
}

}  // namespace

Table preferencesBetween(const AnalysisResult& result) {
    Fields<BetweenRow> fields{{"factor", &BetweenRow::factor, heading},
                              {"system", &BetweenRow::system},
                              {"other_system", &BetweenRow::other_system},
                              {"a", &BetweenRow::a},
                              {"b", &BetweenRow::b}};
    fields = joined(joined(std::move(fields), answersFields(&BetweenRow::answers_a, "a")),
                    answersFields(&BetweenRow::answers_b, "b"));
    const auto shares = [](PreferenceCounts BetweenRow::*of) {
        return [=](const BetweenRow& one) { return sharesText(one.*of); };
    };
    fields.push_back({"shares_a", shares(&BetweenRow::answers_a), {.in = page_only}});
    fields.push_back({"shares_b", shares(&BetweenRow::answers_b), {.in = page_only}});
    return tableOf("preferences_between", units::preferences,
                   "Groups of participants: preferences for system over other system (shares of answers), "
                   "rank-sum tests of participants' net preferences",
                   joined(std::move(fields), groupFields(result)), result.preferences_between);
}

Table ratingPairs(const AnalysisResult& result) {
    using Row = RatingComparison;
    Fields<Row> fields = joined<Row>({{"measure", &Row::measure, heading}}, pairFields<Row>());
    fields = joined<Row>(
        std::move(fields),
        Fields<Row>{{"participants", &Row::participants, in_files},
                    {"n_missing", &Row::n_missing, {.in = in_data, .place = behind_test}},
                    {"mean_difference",
                     [](auto& one) { return known(one.test.n_pairs > 0, one.mean_difference); }, in_files},
                    {"rating_verdict",
                     [](auto& one) { return decisionText(one, "no pairs"); },
                     {.label = "Result", .in = page_only, .marked = true}}});
    return withScales(
        withZ(tableOf(
            "pairwise_ratings", units::ratings,
            "Pairs of systems by single ratings (pseudo-replicated: p is too small): signed-rank tests",
            joined(joined(std::move(fields), testFields(result)),
                   Fields<Row>{noteField<Row>(pseudo_replicated)}),
            result.rating_pairs)),
        result);
}

Table authorTrials(const AnalysisResult& result) {
    using Row = AuthorTrialResult;
    return withScales(
        withZ(
            tableOf("author_trials", units::ratings,
                    "Ratings by the author's trial in which the clips were made (pseudo-replicated: p is too "
                    "small): rank-sum tests",
                    joined(joined(trialFields<Row>(), groupFields(result)),
                           Fields<Row>{noteField<Row>(pseudo_replicated)}),
                    result.author_trials)),
        result);
}

Table authorTrialsPaired(const AnalysisResult& result) {
    using Row = MedianComparison;
    auto fields = trialFields<Row>();
    fields.push_back({"mean_difference",
                      [](auto& one) { return known(one.test.n_pairs > 0, one.mean_difference); }, in_files});
    return withScales(
        tableOf("author_trials_by_participants", units::means,
                "Participants' mean ratings by the author's trial in which the clips were made: "
                "signed-rank tests",
                joined(std::move(fields), testFields(result)), result.author_trials_paired),
        result);
}

}  // namespace deixis::results::tables
