// The analysis of Deichler et al. 2023, section 3.1, for the measures of any study, and its outputs.
#pragma once

#include <string>
#include <vector>

#include "results/response_table.hpp"
#include "results/signed_rank.hpp"

namespace deixis::results {

struct Summary {
    double mean = 0.0;                     ///< of participants' means
    double sd_participants = 0.0;          ///< over participants' means
    double sd_trials = 0.0;                ///< over single trials
    int n = 0;                             ///< trials
    std::vector<double> by_participant{};  ///< participants' means, participants in order
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

struct Comparison {
    std::string measure;
    std::string factor{};  ///< empty: a and b are systems; else levels of it, within `system`
    std::string system{};
    std::string a, b;
    double mean_difference = 0.0;  ///< a - b, mean over the participants paired
    SignedRankTest test;           ///< of participants' means, a - b; n is the number of participants paired
    double p_holm = 1.0;
    bool significant = false;
};

/// How often one system was preferred to another; over trials.
struct PreferenceResult {
    std::string a, b;
    int prefers_a = 0;
    int ties = 0;
    int prefers_b = 0;
    double mean = 0.0;    ///< of participants' mean preferences; positive: for a, up to 2
    SignedRankTest test;  ///< of participants' mean preferences against 0
    double p_holm = 1.0;
    bool significant = false;
};

/// A questionnaire's score over participants.
struct ScoreResult {
    std::string stage;
    std::string score;
    double mean = 0.0;
    double sd = 0.0;
    int n = 0;
};

struct AnalysisResult {
    ResponseTable table;
    int participants = 0;
    bool synthetic = false;         ///< some answers come from simulated participants
    std::vector<Measure> measures;  ///< accuracy and ratings; preferences stand apart
    std::vector<SystemResult> systems;
    std::vector<LevelResult> levels;
    std::vector<Comparison> pairwise;
    std::vector<Comparison> level_tests;
    std::vector<PreferenceResult> preferences;
    std::vector<ScoreResult> scores;
    std::vector<std::string>
        remarks;  ///< what a reader must know: missing answers, exclusions from a test, ...
};

/// Participants' means are compared, as in the paper; a participant without answers under one of the two
/// conditions is left out of that comparison. Holm's families: all pairs of systems in one measure, all pairs
/// of levels of one factor over the systems (accuracy only), and all pairs in preference. Significant: p_holm
/// <= alpha.
[[nodiscard]] AnalysisResult analyse(const ResponseTable& table);
/// One JSON object: program, study, participants, synthetic, alpha, systems, layouts, distances, pairwise,
/// layout_tests, distance_tests, preferences, scores, checks, left_out, remarks. Numbers in full precision,
/// fixed order: the same table gives the same bytes. A mean of no answers and a standard deviation of fewer
/// than two values are null.
[[nodiscard]] std::string analysisJson(const AnalysisResult& result);
/// A whole, self-contained HTML page (also well-formed XML), without script, outside file or date: the same
/// table gives the same bytes.
[[nodiscard]] std::string renderReport(const AnalysisResult& result);

}  // namespace deixis::results
