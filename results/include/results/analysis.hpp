// The analysis of Deichler et al. 2023, section 3.1, and its outputs.
#pragma once

#include <string>
#include <vector>

#include "results/response_table.hpp"
#include "results/statistics.hpp"

namespace deixis::results {

struct Summary {
    double mean = 0.0;             ///< of participants' means
    double sd_participants = 0.0;  ///< over participants' means
    double sd_trials = 0.0;        ///< over single trials
    int n = 0;                     ///< trials
};

struct SystemResult {
    std::string system;
    Summary accuracy;
    Summary naturalness;
    std::vector<double> accuracy_by_participant;  ///< participants' means, participants in order
    std::vector<double> naturalness_by_participant;
};

struct LayoutResult {
    std::string system;  ///< "all" for the first rows
    std::string layout;
    double mean = 0.0;  ///< over trials, as in the paper's Table 1
    double sd_trials = 0.0;
    int n = 0;
};

struct Comparison {
    std::string
        measure;  ///< "accuracy", "naturalness", or "layout" (a and b are then layouts, within `system`)
    std::string system{};
    std::string a, b;
    double mean_difference = 0.0;  ///< a - b, mean over the participants paired
    SignedRankTest test;           ///< of participants' means, a - b; n is the number of participants paired
    double p_holm = 1.0;
    bool significant = false;
};

struct AnalysisResult {
    ResponseTable table;
    int participants = 0;
    bool synthetic = false;  ///< some answers come from simulated participants
    std::vector<SystemResult> systems;
    std::vector<LayoutResult> layouts;
    std::vector<Comparison> pairwise;
    std::vector<Comparison> layout_tests;
    std::vector<std::string>
        remarks;  ///< what a reader must know: missing answers, exclusions from a test, ...
};

/// Participants' means are compared, as in the paper; a participant without answers under one of the two
/// conditions is left out of that comparison. Holm's families: all pairs of systems in one measure, and all
/// layout tests. Significant: p_holm <= alpha.
[[nodiscard]] AnalysisResult analyse(const ResponseTable& table);
/// One JSON object: program, study, participants, synthetic, alpha, systems, layouts, pairwise, layout_tests,
/// remarks. Numbers in full precision, fixed order: the same table gives the same bytes. A mean of no answers
/// and a standard deviation of fewer than two values are null.
[[nodiscard]] std::string analysisJson(const AnalysisResult& result);
/// A whole, self-contained HTML page (also well-formed XML), without script, outside file or date: the same
/// table gives the same bytes.
[[nodiscard]] std::string renderReport(const AnalysisResult& result);

}  // namespace deixis::results
