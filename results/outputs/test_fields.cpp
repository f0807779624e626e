#include "test_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace deixis::results {

namespace {

constexpr std::array<std::string_view, 31> json_order{"n",
                                                      "n_missing",
                                                      "n_zero",
                                                      "n_positive",
                                                      "n_negative",
                                                      "n_a",
                                                      "n_b",
                                                      "mean_a",
                                                      "mean_b",
                                                      "u",
                                                      "ties",
                                                      "w_plus",
                                                      "w_minus",
                                                      "z",
                                                      "p",
                                                      "p_holm",
                                                      "significant",
                                                      "method",
                                                      "family",
                                                      "family_size",
                                                      "alpha",
                                                      "p_normal",
                                                      "p_pratt",
                                                      "p_holm_pratt",
                                                      "depends_on_zeros",
                                                      "p_holm_normal",
                                                      "depends_on_approximation",
                                                      "smallest_p",
                                                      "out_of_reach",
                                                      "rank_biserial",
                                                      "paired_superiority"};

/// In JSON a test's keys stand in another order than its columns in CSV.
template <typename Row>
Fields<Row> inJsonOrder(Fields<Row> fields, std::initializer_list<std::string_view> last) {
    for (Field<Row>& field : fields) {
        Column& column = field.column;
        const auto place = [&](const auto& names) {
            return static_cast<int>(std::find(names.begin(), names.end(), column.name) - names.begin());
        };
        column.place = 1 + place(json_order);
        if (column.place > static_cast<int>(json_order.size())) column.place += place(last);
    }
    return fields;
}

Json equivalenceJson(const Equivalence& one) {
    return {{"bound", one.bound}, {"p", one.p}, {"p_holm", one.p_holm}, {"equivalent", one.equivalent}};
}

template <typename Test>
Fields<Test> endOfTest(const AnalysisResult& result) {
    return {{"method", [](auto& one) { return one.test.method; }, {.in = in_data}},
            {"family", &Test::family, {.in = in_data}},
            {"family_size", &Test::family_size, {.in = in_data}},
            {"alpha", [alpha = result.alpha](auto&) { return alpha; }, {.in = in_json}},
            {"equivalence",
             [](auto& one) { return one.equivalence ? Cell(equivalenceJson(*one.equivalence)) : Cell(); },
             {.in = in_json, .sparse = true}}};
}

}  // namespace

Interval intervalOf(const HodgesLehmann& shift) {
    return {shift.lower,          shift.upper,    shift.lower_included,
            shift.upper_included, shift.estimate, shift.level};
}

Interval intervalOf(const std::optional<BootstrapInterval>& interval) {
    return interval ? Interval{interval->lower, interval->upper} : Interval{};
}

std::string decisionText(const AdjustedTest& one, const char* without_pairs) {
    if (one.test.n_pairs == 0) return without_pairs;
    if (!one.significant) return "not significant";
    return one.test.w_plus > one.test.w_minus ? "A higher" : "B higher";
}

Fields<AdjustedTest> testFields(const AnalysisResult& result) {
    const auto of = [](auto member) { return [=](const AdjustedTest& one) { return one.test.*member; }; };
    const auto tested = [](auto member) {
        return [=](const AdjustedTest& one) { return known(one.test.n_pairs > 0, one.test.*member); };
    };
    const Show in_files{.in = in_data};
    Fields<AdjustedTest> fields{
        {"n", of(&SignedRankTest::n_pairs)},
        {"n_missing",
         [all = result.participants](auto& one) { return all - one.test.n_pairs; },
         {.in = in_json}},
        {"n_zero", of(&SignedRankTest::n_zero)},
        {"n_positive", of(&SignedRankTest::n_positive), in_files},
        {"n_negative", of(&SignedRankTest::n_negative), in_files},
        {"ties", of(&SignedRankTest::ties), in_files},
        {"w_plus", of(&SignedRankTest::w_plus)},
        {"w_minus", of(&SignedRankTest::w_minus), in_files},
        {"z", of(&SignedRankTest::z), in_files},
        {"p", tested(&SignedRankTest::p_two_sided)},
        {"p_holm", &AdjustedTest::p_holm},
        {"p_normal", tested(&SignedRankTest::normal_p_two_sided), in_files},
        {"p_pratt", tested(&SignedRankTest::pratt_p_two_sided), in_files},
        {"p_holm_pratt", &AdjustedTest::p_holm_pratt, in_files},
        {"p_holm_normal", &AdjustedTest::p_holm_normal, in_files},
        {"smallest_p", tested(&SignedRankTest::smallest_p), in_files},
        {"significant", &AdjustedTest::significant, in_files},
        {"depends_on_zeros", &AdjustedTest::depends_on_zeros, in_files},
        {"depends_on_approximation", &AdjustedTest::depends_on_approximation, {.in = in_json}},
        {"out_of_reach", &AdjustedTest::out_of_reach, in_files},
        {"hodges_lehmann", [](auto& one) { return intervalOf(one.test.hodges_lehmann); }, {.estimate = true}},
        {"rank_biserial", of(&SignedRankTest::rank_biserial)},
        {"paired_superiority", of(&SignedRankTest::paired_superiority), in_files},
        {"shapiro_w", [](auto& one) { return one.normality.w; }, {.in = in_data, .json = "shapiro_wilk/w"}},
        {"shapiro_p", [](auto& one) { return one.normality.p; }, {.in = in_data, .json = "shapiro_wilk/p"}},
        {"verdict",
         [](auto& one) {
             const char* mark = one.test.n_pairs == 0  ? ""
                                : one.depends_on_zeros ? " \u2020"
                                : one.out_of_reach     ? " \u2021"
                                                       : "";
             return decisionText(one, "no participant has both") + mark;
         },
         {.in = page_only, .marked = true}}};
    return inJsonOrder(joined(std::move(fields), endOfTest<AdjustedTest>(result)),
                       {"hodges_lehmann", "shapiro_w", "shapiro_p", "equivalence"});
}

Fields<GroupTest> groupFields(const AnalysisResult& result) {
    const auto of = [](auto member) { return [=](const GroupTest& one) { return one.test.*member; }; };
    const Show in_files{.in = in_data};
    Fields<GroupTest> fields{
        {"n_a", of(&RankSumTest::n_a)},
        {"n_b", of(&RankSumTest::n_b)},
        {"n_both",
         [](auto& one) { return fmt::format("{}, {}", one.test.n_a, one.test.n_b); },
         {.label = "n", .in = page_only, .right = true}},
        {"mean_a", [](auto& one) { return known(one.test.n_a > 0, one.mean_a); }, in_files},
        {"mean_b", [](auto& one) { return known(one.test.n_b > 0, one.mean_b); }, in_files},
        {"u", [](auto& one) { return known(one.test.p_two_sided.has_value(), one.test.u); }},
        {"ties", of(&RankSumTest::ties), in_files},
        {"z", of(&RankSumTest::z), in_files},
        {"p", of(&RankSumTest::p_two_sided)},
        {"p_holm", &GroupTest::p_holm, {.marked = true}},
        {"p_normal", of(&RankSumTest::normal_p_two_sided), in_files},
        {"significant", &GroupTest::significant, in_files},
        {"hodges_lehmann", [](auto& one) { return intervalOf(one.test.hodges_lehmann); }, {.estimate = true}},
        {"cliffs_delta", of(&RankSumTest::cliffs_delta)},
        {"a12", of(&RankSumTest::a12), in_files}};
    return inJsonOrder(joined(std::move(fields), endOfTest<GroupTest>(result)),
                       {"a12", "cliffs_delta", "hodges_lehmann", "equivalence"});
}

}  // namespace deixis::results
