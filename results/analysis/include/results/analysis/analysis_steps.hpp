// The parts of an analysis; private to it. Each fills in its part of the result, and needs the measures.
#pragma once

#include "results/analysis/analysis.hpp"
#include "results/analysis/tests.hpp"

namespace deixis::results {

/// Takes the systems that are not compared out of the table, with their answers, and summarises them by
/// themselves. Needs the measures.
void setAside(AnalysisResult& result);

/// Means of the levels of each within-participants factor, and tests of all pairs of levels.
void compareLevels(AnalysisResult& result);

/// Of participants' means, resampling participants. Summaries of as many participants are resampled together:
/// each gets what it would get alone, as the seed is the same, and the draws are made once.
void addIntervals(const std::vector<Summary*>& summaries, const BootstrapOptions& options);
[[nodiscard]] Summary summarise(const Cells& cells, const std::string& condition);

/// Participants' means of the levels that compareLevels() found, with their intervals.
void describeLevels(AnalysisResult& result);

/// Sensitivity: the pairs of systems with other participants and trials. Needs pairwise and preferences.
void compareOtherAnswers(AnalysisResult& result);

/// Factors between participants, in the measures and in the preferences of each pair of systems.
void compareGroups(AnalysisResult& result);
void comparePreferencesOfGroups(AnalysisResult& result);

/// The factor under which systems stand that no participant saw both of.
inline constexpr const char* systems_between = "system";

/// Pairs of systems that no participant saw both of, as groups of participants. Needs pairwise.
void compareSystemsBetween(const MeansByMeasure& means, AnalysisResult& result);

/// Pairs of systems by single ratings, where they are asked for.
void compareRatings(AnalysisResult& result);

/// Ratings by the trials in which the clips' authors made them.
void compareAuthorTrials(AnalysisResult& result);

/// Systems and factors that cross. Not in runTests().
void testInteractions(AnalysisResult& result);

/// Questionnaires' scores.
void summariseScores(AnalysisResult& result);

/// What participants told, how long they took, scores before and after and by groups, response times by
/// systems and groups.
void describeParticipants(AnalysisResult& result);

/// Chance, times, order, items, presence and pooled ratings.
void describeAnswers(AnalysisResult& result);

/// Confusion and target space.
void describeChoices(AnalysisResult& result);

/// Answers beside the options' objective evaluation, if there is one. Needs systems.
void compareWithObjective(AnalysisResult& result);

/// The systems by their medians, in each of several studies and pooled. Needs systems and by_study.
void orderMedians(AnalysisResult& result);

}  // namespace deixis::results
