#include "analysis_table_parts.hpp"

namespace deixis::results {

using enum ColumnType;

namespace {

std::vector<PlainColumn> shiftColumns() {
    return {{"hodges_lehmann", number, Print::plain, "shift"},
            {"hodges_lehmann_lower", number, Print::range, "interval"},
            {"hodges_lehmann_upper", number},
            {"hodges_lehmann_lower_included", truth},
            {"hodges_lehmann_upper_included", truth},
            {"hodges_lehmann_level", number}};
}

std::vector<PlainCell> shiftCells(const HodgesLehmann& shift) {
    return {plainCell(shift.estimate),       plainCell(shift.lower),          plainCell(shift.upper),
            PlainCell(shift.lower_included), PlainCell(shift.upper_included), plainCell(shift.level)};
}

}  // namespace

std::vector<PlainColumn> testColumns() {
    return withMore(withMore<PlainColumn>({{"n", whole, Print::plain, "$n$"},
                                           {"n_zero", whole, Print::plain, "zeros"},
                                           {"n_positive", whole},
                                           {"n_negative", whole},
                                           {"ties", whole},
                                           {"w_plus", number, Print::rank, "$W^+$"},
                                           {"w_minus", number},
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
                                           {"out_of_reach", truth}},
                                          shiftColumns()),
                    {{"rank_biserial", number, Print::plain, "$r$"},
                     {"paired_superiority", number},
                     {"shapiro_w", number},
                     {"shapiro_p", number},
                     {"method", text},
                     {"family", text},
                     {"family_size", whole}});
}

std::vector<PlainCell> testCells(const AdjustedTest& one) {
    const SignedRankTest& test = one.test;
    const bool tested = test.n_pairs > 0;
    return withMore(
        withMore<PlainCell>(
            {wholeCell(test.n_pairs), wholeCell(test.n_zero), wholeCell(test.n_positive),
             wholeCell(test.n_negative), wholeCell(test.ties), PlainCell(test.w_plus),
             PlainCell(test.w_minus), plainCell(test.z), knownCell(tested, test.p_two_sided),
             plainCell(one.p_holm), knownCell(tested, test.normal_p_two_sided),
             knownCell(tested, test.pratt_p_two_sided), plainCell(one.p_holm_pratt),
             plainCell(one.p_holm_normal), knownCell(tested, test.smallest_p), PlainCell(one.significant),
             PlainCell(one.depends_on_zeros), PlainCell(one.out_of_reach)},
            shiftCells(test.hodges_lehmann)),
        {plainCell(test.rank_biserial), plainCell(test.paired_superiority), plainCell(one.normality.w),
         plainCell(one.normality.p), PlainCell(test.method), PlainCell(one.family),
         wholeCell(one.family_size)});
}

std::vector<PlainColumn> groupColumns() {
    return withMore(withMore<PlainColumn>({{"n_a", whole, Print::plain, "$n_a$"},
                                           {"n_b", whole, Print::plain, "$n_b$"},
                                           {"mean_a", number},
                                           {"mean_b", number},
                                           {"u", number, Print::rank, "$U$"},
                                           {"ties", whole},
                                           {"z", number},
                                           {"p", number, Print::p_value, "$p$"},
                                           {"p_holm", number, Print::p_value, "$p_\\mathrm{Holm}$"},
                                           {"p_normal", number},
                                           {"significant", truth}},
                                          shiftColumns()),
                    {{"cliffs_delta", number, Print::plain, "$\\delta$"},
                     {"a12", number},
                     {"method", text},
                     {"family", text},
                     {"family_size", whole}});
}

std::vector<PlainCell> groupCells(const GroupTest& one) {
    const RankSumTest& test = one.test;
    return withMore(
        withMore<PlainCell>(
            {wholeCell(test.n_a), wholeCell(test.n_b), knownCell(test.n_a > 0, one.mean_a),
             knownCell(test.n_b > 0, one.mean_b), knownCell(test.p_two_sided.has_value(), test.u),
             wholeCell(test.ties), plainCell(test.z), plainCell(test.p_two_sided), plainCell(one.p_holm),
             plainCell(test.normal_p_two_sided), PlainCell(one.significant)},
            shiftCells(test.hodges_lehmann)),
        {plainCell(test.cliffs_delta), plainCell(test.a12), test.method, one.family,
         wholeCell(one.family_size)});
}

std::vector<PlainColumn> contrastColumns() {
    return {
        {"measure", text, Print::heading}, {"factor", text, Print::heading},       {"a", text, Print::plain},
        {"b", text, Print::plain},         {"other_factor", text, Print::heading}, {"c", text, Print::plain},
        {"d", text, Print::plain}};
}

}  // namespace deixis::results
