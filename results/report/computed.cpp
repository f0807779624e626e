#include "computed.hpp"

#include <algorithm>

#include "results/analysis/analysis_steps.hpp"

namespace deixis::results {

Computed::Computed(const AnalysisResult& result) {
    for (const SystemResult& system : result.systems)
        for (const Summary& one : system.measures) intervals = intervals || one.interval.has_value();
    if (result.participants < 2) return;
    for (const SystemResult& system : result.systems)
        for (const Summary& one : system.measures) boxes = boxes || !one.by_participant.empty();
    const auto take = [&](bool& kind, const AdjustedTest& one) {
        if (one.test.n_pairs == 0) return;
        kind = true;
        zeros = zeros || one.test.n_zero > 0;
        approximate = approximate || one.test.method == "normal approximation";
        equivalence = equivalence || one.equivalence;
    };
    for (const Comparison& one : result.pairwise) take(pairs, one);
    for (const RatingComparison& one : result.rating_pairs) ratings = ratings || one.test.n_pairs > 0;
    author_trials = !result.author_trials.empty();
    for (const Comparison& one : result.level_tests) take(levels, one);
    for (const PreferenceResult& one : result.preferences) take(preferences, one);
    for (const ChanceResult& one : result.chance) take(chance, one);
    for (const OrderResult& one : result.order) take(halves, one);
    for (const InteractionResult& one : result.interactions) take(interactions, one);
    for (const ScoreChange& one : result.score_changes) take(scores, one);
    for (const Comparison& one : result.time_tests) take(times, one);
    for (const ScoreGroupResult& one : result.score_groups)
        scores_of_groups = scores_of_groups || one.test.p_two_sided;
    for (const BetweenResult& one : result.time_groups)
        times_of_groups = times_of_groups || one.test.p_two_sided;
    for (const BetweenResult& one : result.between) {
        if (!one.test.p_two_sided) continue;
        (one.factor == systems_between ? systems_apart : groups) = true;
        equivalence = equivalence || one.equivalence;
    }
    for (const PreferenceBetweenResult& one : result.preferences_between)
        preferences_of_groups = preferences_of_groups || one.test.p_two_sided;
    interactions = interactions || !result.group_interactions.empty();
    friedman = std::any_of(result.omnibus.begin(), result.omnibus.end(), [&](const OmnibusResult& one) {
        return one.test.chi2.has_value() && tellsFriedman(result, one.measure);
    });
}

bool tellsFriedman(const AnalysisResult& result, const std::string& measure) {
    if (result.table.systems.size() > 2) return true;
    return std::any_of(result.measures.begin(), result.measures.end(),
                       [&](const Measure& one) { return one.name == measure && one.surveyed; });
}

bool isPointing2023(const ResponseTable& table) {
    return !table.study_hash.empty() && table.study_name == "pointing2023";
}

}  // namespace deixis::results
