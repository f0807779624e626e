#include "analysis_json_tests.hpp"

#include "results/tables/json_values.hpp"

namespace deixis::results {

void addTest(nlohmann::ordered_json& out, const AdjustedTest& adjusted, const AnalysisResult& result) {
    const SignedRankTest& test = adjusted.test;
    const bool tested = test.n_pairs > 0;
    out["n"] = test.n_pairs;
    out["n_missing"] = result.participants - test.n_pairs;
    out["n_zero"] = test.n_zero;
    out["n_positive"] = test.n_positive;
    out["n_negative"] = test.n_negative;
    out["ties"] = test.ties;
    out["w_plus"] = test.w_plus;
    out["w_minus"] = test.w_minus;
    out["z"] = numberOrNull(test.z);
    out["p"] = numberOrNull(tested, test.p_two_sided);
    out["p_holm"] = numberOrNull(adjusted.p_holm);
    out["significant"] = adjusted.significant;
    out["method"] = test.method;
    out["family"] = adjusted.family;
    out["family_size"] = adjusted.family_size;
    out["alpha"] = result.alpha;
    out["p_normal"] = numberOrNull(tested, test.normal_p_two_sided);
    out["p_pratt"] = numberOrNull(tested, test.pratt_p_two_sided);
    out["p_holm_pratt"] = numberOrNull(adjusted.p_holm_pratt);
    out["depends_on_zeros"] = adjusted.depends_on_zeros;
    out["p_holm_normal"] = numberOrNull(adjusted.p_holm_normal);
    out["depends_on_approximation"] = adjusted.depends_on_approximation;
    out["smallest_p"] = numberOrNull(tested, test.smallest_p);
    out["out_of_reach"] = adjusted.out_of_reach;
    out["rank_biserial"] = numberOrNull(test.rank_biserial);
    out["paired_superiority"] = numberOrNull(test.paired_superiority);
    const HodgesLehmann& shift = test.hodges_lehmann;
    out["hodges_lehmann"] = {
        {"estimate", numberOrNull(shift.estimate)}, {"lower", numberOrNull(shift.lower)},
        {"upper", numberOrNull(shift.upper)},       {"lower_included", shift.lower_included},
        {"upper_included", shift.upper_included},   {"level", numberOrNull(shift.level)}};
    out["shapiro_wilk"] = {{"w", numberOrNull(adjusted.normality.w)},
                           {"p", numberOrNull(adjusted.normality.p)}};
    if (adjusted.equivalence) out["equivalence"] = equivalenceJson(*adjusted.equivalence);
}

void addGroupTest(nlohmann::ordered_json& out, const GroupTest& one, double alpha) {
    const RankSumTest& test = one.test;
    const HodgesLehmann& shift = test.hodges_lehmann;
    out["n_a"] = test.n_a;
    out["n_b"] = test.n_b;
    out["mean_a"] = numberOrNull(test.n_a > 0, one.mean_a);
    out["mean_b"] = numberOrNull(test.n_b > 0, one.mean_b);
    out["u"] = numberOrNull(test.p_two_sided.has_value(), test.u);
    out["ties"] = test.ties;
    out["z"] = numberOrNull(test.z);
    out["p"] = numberOrNull(test.p_two_sided);
    out["p_holm"] = numberOrNull(one.p_holm);
    out["significant"] = one.significant;
    out["method"] = test.method;
    out["family"] = one.family;
    out["family_size"] = one.family_size;
    out["alpha"] = alpha;
    out["p_normal"] = numberOrNull(test.normal_p_two_sided);
    out["a12"] = numberOrNull(test.a12);
    out["cliffs_delta"] = numberOrNull(test.cliffs_delta);
    out["hodges_lehmann"] = {
        {"estimate", numberOrNull(shift.estimate)}, {"lower", numberOrNull(shift.lower)},
        {"upper", numberOrNull(shift.upper)},       {"lower_included", shift.lower_included},
        {"upper_included", shift.upper_included},   {"level", numberOrNull(shift.level)}};
    if (one.equivalence) out["equivalence"] = equivalenceJson(*one.equivalence);
}

nlohmann::ordered_json equivalenceJson(const Equivalence& one) {
    return {{"bound", one.bound}, {"p", one.p}, {"p_holm", one.p_holm}, {"equivalent", one.equivalent}};
}

}  // namespace deixis::results
