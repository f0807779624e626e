// The analysis as tables: for other programs, for papers, and for the page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/tables/table.hpp"

namespace deixis::results {

enum class TableFormat : unsigned char {
    csv,   ///< full precision, all columns; also the answers and the participants' means
    latex  ///< rounded, one tabular a file, for the booktabs package
};

/// File names ("pairwise.csv") and what to write to them; tables without rows are left out. The columns stand
/// in docs/analysis.md. The same analysis gives the same bytes.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> analysisTables(const AnalysisResult& result,
                                                                              TableFormat format);

/// Each table once; what of it stands in CSV, JSON and print its columns say. Without rows where there is
/// nothing of the kind.
namespace tables {

// Participants' means and single answers.
[[nodiscard]] Table means(const AnalysisResult& result);
/// The same of the systems that are not compared, with what their motion is, and why.
[[nodiscard]] Table notCompared(const AnalysisResult& result);
/// What `means` has of one system and measure, as JSON.
[[nodiscard]] Json summaryJson(const Summary& summary);
/// Of one factor, or all of them. `key`: what its level is called in JSON; "level" has the factor beside it.
[[nodiscard]] Table levels(const AnalysisResult& result, const std::string& factor = "",
                           const char* key = "level");
[[nodiscard]] Table pooledRatings(const AnalysisResult& result);
[[nodiscard]] Table responseTimes(const AnalysisResult& result);
[[nodiscard]] Table items(const AnalysisResult& result);
[[nodiscard]] Table participantMeans(const AnalysisResult& result);
[[nodiscard]] Table settings(const AnalysisResult& result);

// Tests of systems, levels and groups.
[[nodiscard]] Table omnibus(const AnalysisResult& result);
[[nodiscard]] Table pairwise(const AnalysisResult& result);
[[nodiscard]] Table levelTests(const AnalysisResult& result);
[[nodiscard]] Table timeTests(const AnalysisResult& result);
[[nodiscard]] Table interactions(const AnalysisResult& result);
[[nodiscard]] Table groupInteractions(const AnalysisResult& result);
[[nodiscard]] Table preferences(const AnalysisResult& result);
[[nodiscard]] Table abilities(const AnalysisResult& result);
[[nodiscard]] Table order(const AnalysisResult& result);
[[nodiscard]] Table equivalence(const AnalysisResult& result);
[[nodiscard]] Table sensitivity(const AnalysisResult& result);
[[nodiscard]] Table between(const AnalysisResult& result);
[[nodiscard]] Table timeGroups(const AnalysisResult& result);
[[nodiscard]] Table preferencesBetween(const AnalysisResult& result);

// Single ratings, and authors' trials.
[[nodiscard]] Table ratingPairs(const AnalysisResult& result);
[[nodiscard]] Table authorTrials(const AnalysisResult& result);
[[nodiscard]] Table authorTrialsPaired(const AnalysisResult& result);

// The game's choices.
[[nodiscard]] Table chance(const AnalysisResult& result);
[[nodiscard]] Table unanswered(const AnalysisResult& result);
[[nodiscard]] Table confusion(const AnalysisResult& result);
[[nodiscard]] Table angles(const AnalysisResult& result);
[[nodiscard]] Table observers(const std::vector<ObserverReading>& readings, const char* trials = "choices");
[[nodiscard]] Table drift(const AnalysisResult& result);
[[nodiscard]] Table targetSpace(const AnalysisResult& result);
[[nodiscard]] Table measuredSpace(const AnalysisResult& result);

// The objective evaluation of the clips.
[[nodiscard]] Table objectiveMeans(const AnalysisResult& result);  ///< each system and measure
[[nodiscard]] Table objectiveCorrelations(const AnalysisResult& result);

// People: what they told, how carefully they answered, who is left out.
[[nodiscard]] Table scores(const AnalysisResult& result);
[[nodiscard]] Table scoreChanges(const AnalysisResult& result);
[[nodiscard]] Table scoreGroups(const AnalysisResult& result);
[[nodiscard]] Table participantFields(const AnalysisResult& result);
[[nodiscard]] Table sessionTimes(const AnalysisResult& result);
[[nodiscard]] Table reliability(const AnalysisResult& result);
[[nodiscard]] Table quality(const AnalysisResult& result);  ///< every participant
[[nodiscard]] Table checks(const AnalysisResult& result);
[[nodiscard]] Table leftOut(const AnalysisResult& result);

// Several studies.
[[nodiscard]] Table studies(const AnalysisResult& result);
[[nodiscard]] Table studyMedians(const AnalysisResult& result);
/// The rows of one table of each study, with the study's name before them.
[[nodiscard]] Table eachStudy(const AnalysisResult& result, const char* name, const char* caption,
                              Table (*table)(const AnalysisResult&));

}  // namespace tables

[[nodiscard]] Interval intervalOf(const HodgesLehmann& shift);
[[nodiscard]] Interval intervalOf(const std::optional<BootstrapInterval>& interval);

/// Rows of an accuracy have shares as scores: by the column "measure".
[[nodiscard]] Table withScales(Table table, const AnalysisResult& result);

}  // namespace deixis::results
