#include "analysis_json_ratings.hpp"

#include "analysis_json_tests.hpp"
#include "results/tables/json_values.hpp"

namespace deixis::results {

namespace {

using RatingsJson = nlohmann::ordered_json;

constexpr const char* pseudo_replicated = "pseudo-replicated: ratings taken as independent";

}  // namespace

void addRatings(RatingsJson& out, const AnalysisResult& result) {
    RatingsJson pairs = RatingsJson::array();
    for (const RatingComparison& one : result.rating_pairs) {
        const bool tested = one.test.n_pairs > 0;
        RatingsJson row{{"measure", one.measure},
                        {"a", one.a},
                        {"b", one.b},
                        {"median_a", numberOrNull(one.median_a)},
                        {"median_b", numberOrNull(one.median_b)},
                        {"participants", one.participants},
                        {"mean_difference", numberOrNull(tested, one.mean_difference)}};
        addTest(row, one, result);
        row["n_missing"] = one.n_missing;
        row["note"] = pseudo_replicated;
        pairs.push_back(std::move(row));
    }
    out["pairwise_ratings"] = std::move(pairs);
    RatingsJson trials = RatingsJson::array();
    for (const AuthorTrialResult& one : result.author_trials) {
        RatingsJson row{{"measure", one.measure},   {"system", one.system},    {"a", one.a}, {"b", one.b},
                        {"median_a", one.median_a}, {"median_b", one.median_b}};
        addGroupTest(row, one, result.alpha);
        row["note"] = pseudo_replicated;
        trials.push_back(std::move(row));
    }
    out["author_trials"] = std::move(trials);
    RatingsJson paired = RatingsJson::array();
    for (const MedianComparison& one : result.author_trials_paired) {
        const bool tested = one.test.n_pairs > 0;
        RatingsJson row{{"measure", one.measure},
                        {"system", one.system},
                        {"a", one.a},
                        {"b", one.b},
                        {"median_a", numberOrNull(one.median_a)},
                        {"median_b", numberOrNull(one.median_b)},
                        {"mean_difference", numberOrNull(tested, one.mean_difference)}};
        addTest(row, one, result);
        paired.push_back(std::move(row));
    }
    out["author_trials_by_participants"] = std::move(paired);
}

}  // namespace deixis::results
