// The analysis of Deichler et al. 2023, section 3.1, for the measures of any study, and its outputs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/bootstrap.hpp"
#include "results/bradley_terry.hpp"
#include "results/friedman.hpp"
#include "results/proportion.hpp"
#include "results/response_table.hpp"
#include "results/shapiro_wilk.hpp"
#include "results/signed_rank.hpp"

namespace deixis::results {

struct AnalysisOptions {
    std::optional<double> alpha{};  ///< in (0, 1); none: the study's
    double level = 0.95;            ///< of intervals, in (0, 1)
    int resamples = 10000;          ///< of bootstraps, at least 1
    std::uint64_t seed = 1;         ///< of bootstraps
};

struct Summary {
    double mean = 0.0;                     ///< of participants' means
    double sd_participants = 0.0;          ///< over participants' means
    double sd_trials = 0.0;                ///< over single trials
    int n = 0;                             ///< trials
    std::vector<double> by_participant{};  ///< participants' means, participants in order
    std::optional<BootstrapInterval>
        interval{};  ///< of the mean, resampling participants; BCa, or percentile
                     ///< where there is none; from two participants on
};

struct SystemResult {
    std::string system;
    std::vector<Summary> measures;  ///< in the order of AnalysisResult::measures
};

/// One level of a factor within a measure.
struct LevelResult {
    std::string measure;
    std::string factor;  ///< "layout" or "distance"
    std::string system;  ///< "all" for the first rows of a measure and factor
    std::string level;
    double mean = 0.0;  ///< over trials, as in the paper's Table 1
    double sd_trials = 0.0;
    int n = 0;
};

/// A signed-rank test of participants' means in its family of Holm's correction.
struct AdjustedTest {
    SignedRankTest test{};  ///< n_pairs: the participants who have both conditions
    std::string family{};
    int family_size = 0;                   ///< tests of the family that have a p
    std::optional<double> p_holm{};        ///< none where no participant has both
    std::optional<double> p_holm_pratt{};  ///< the family corrected with Pratt's p of each test
    bool significant = false;              ///< p_holm <= alpha
    bool depends_on_zeros = false;         ///< the decision would be another with Pratt's p
    /// Even the smallest p that so many differences can give, times the family's size, exceeds alpha.
    bool out_of_reach = false;
    ShapiroWilk normality{};  ///< of the differences; for description only
};

struct Comparison : AdjustedTest {
    std::string measure;
    std::string factor{};  ///< empty: a and b are systems; else levels of it, within `system`
    std::string system{};
    std::string a, b;
    double mean_difference = 0.0;       ///< a - b, mean over the participants paired
    std::vector<double> differences{};  ///< a - b of each of them, participants in order
};

/// Friedman's test over all systems, of the participants who have answers under each of them.
struct OmnibusResult {
    std::string measure;
    FriedmanTest test;  ///< mean ranks in the order of the systems; 1 is the lowest score
};

/// How often one system was preferred to another; over trials. The test is of participants' mean preferences
/// against 0.
struct PreferenceResult : AdjustedTest {
    std::string a, b;
    int prefers_a = 0;
    int ties = 0;
    int prefers_b = 0;
    double mean = 0.0;  ///< of participants' mean preferences; positive: for a, up to 2
};

/// A questionnaire's score over participants.
struct ScoreResult {
    std::string stage;
    std::string score;
    double mean = 0.0;
    double sd = 0.0;
    int n = 0;
};

/// A system's choices against chance, all taken as independent: clustering by participant and item is
/// ignored.
struct ChanceResult {
    std::string system;
    Proportion proportion;  ///< chance 1 / balls, where it is known
};

/// Response times of a system in one measure, seconds; answers without one are left out.
struct TimeResult {
    std::string measure;
    std::string system;
    int n = 0;
    double q25_s = 0.0, median_s = 0.0, q75_s = 0.0;
};

/// Whether answers change while a participant goes on: the means of the first and the second half of each
/// participant's answers on a measure, in their order; the middle one of an odd number belongs to the first.
struct OrderResult : AdjustedTest {  ///< of second - first, over participants
    std::string measure;
    double first = 0.0;  ///< mean of participants' means
    double second = 0.0;
};

/// One target or stimulus, over all systems and participants.
struct ItemResult {
    std::string measure;
    std::string item;
    double mean = 0.0;
    int n = 0;
};

/// How many answers of a participant there are on each of AnalysisResult::measures, for each system.
struct PresenceRow {
    std::string participant;
    std::vector<std::vector<int>> answers{};  ///< [measure][system]
};

struct AnalysisResult {
    ResponseTable table;
    AnalysisOptions options;
    double alpha = 0.01;
    int participants = 0;
    bool synthetic = false;         ///< some answers come from simulated participants
    std::vector<Measure> measures;  ///< accuracy and ratings; preferences stand apart
    std::vector<SystemResult> systems;
    std::vector<LevelResult> levels;
    std::vector<OmnibusResult> omnibus;
    std::vector<Comparison> pairwise;
    std::vector<Comparison> level_tests;
    std::vector<PreferenceResult> preferences;
    BradleyTerry bradley_terry;
    std::vector<ScoreResult> scores;
    std::vector<ChanceResult> chance;  ///< where there is a game
    std::vector<TimeResult> times;
    std::vector<OrderResult> order;  ///< where the answers' order is known
    std::vector<ItemResult> items;   ///< by measure, lowest mean first
    std::vector<PresenceRow> presence;
    std::vector<std::string>
        remarks;  ///< what a reader must know: missing answers, exclusions from a test, ...
};

/// Participants' means are compared, as in the paper; a participant without answers under one of the two
/// conditions is left out of that comparison. Holm's families: all pairs of systems in one measure, all pairs
/// of levels of one factor over the systems (accuracy only), and all pairs in preference.
[[nodiscard]] AnalysisResult analyse(const ResponseTable& table, const AnalysisOptions& options = {});
/// The tests of analyse() alone, without bootstraps and descriptions, for who asks very often: fills in
/// alpha, measures, omnibus, pairwise, levels, level_tests and preferences from the result's table and
/// options.
void runTests(AnalysisResult& result);
/// One JSON object; its keys stand in docs/analysis.md. Numbers in full precision, fixed order: the same
/// table gives the same bytes. What is not defined is null.
[[nodiscard]] std::string analysisJson(const AnalysisResult& result);
/// A whole, self-contained HTML page (also well-formed XML), without outside file or date: the same table
/// gives the same bytes. Its figures are Vega-Lite specifications, which the script in it draws.
[[nodiscard]] std::string renderReport(const AnalysisResult& result);

}  // namespace deixis::results
