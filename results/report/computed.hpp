// What of an analysis was computed, so that the page speaks of that and of nothing else; private to the
// report.
#pragma once

#include "results/analysis/analysis.hpp"

namespace deixis::results {

struct Computed {
    bool pairs = false;    ///< signed-rank tests of pairs of systems; like all tests from two participants on
    bool ratings = false;  ///< single ones, of pairs of systems
    bool author_trials = false;
    bool friedman = false;  ///< that is told
    bool levels = false;    ///< of within-participants factors
    bool preferences = false;
    bool chance = false;
    bool halves = false;         ///< first against second
    bool systems_apart = false;  ///< systems that no participant saw both of
    bool groups = false;
    bool preferences_of_groups = false;
    bool scores = false;  ///< of a questionnaire asked again
    bool times = false;   ///< response times of pairs of systems
    bool scores_of_groups = false;
    bool times_of_groups = false;
    bool interactions = false;
    bool equivalence = false;
    bool intervals = false;    ///< of means, by bootstrap
    bool boxes = false;        ///< drawn
    bool zeros = false;        ///< some signed-rank test met differences of zero
    bool approximate = false;  ///< some signed-rank test has no exact p

    explicit Computed(const AnalysisResult& result);

    [[nodiscard]] bool signedRank() const {
        return pairs || levels || preferences || chance || halves || scores || times;
    }
    [[nodiscard]] bool rankSum() const {
        return systems_apart || groups || preferences_of_groups || scores_of_groups || times_of_groups;
    }
};

/// Whether Friedman's test of a measure is told: of two systems the pair says as much, but a questionnaire's
/// ratings are reported by it (Yoon et al. 2021, 7.1.2).
[[nodiscard]] bool tellsFriedman(const AnalysisResult& result, const std::string& measure);

/// The study that Deichler et al. (2023) ran, as it ships or changed in what a study file may change.
[[nodiscard]] bool isPointing2023(const ResponseTable& table);

}  // namespace deixis::results
