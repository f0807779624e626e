// Which of the analysis' tables become files.
#include "results/outputs/analysis_tables.hpp"

#include <string_view>

#include "answers_csv.hpp"

namespace deixis::results {

namespace {

std::vector<Table> tablesOfOneStudy(const AnalysisResult& result) {
    std::vector<Table> out;
    for (Table (*const table)(const AnalysisResult&) : {tables::omnibus,
                                                        tables::pairwise,
                                                        tables::levelTests,
                                                        tables::interactions,
                                                        tables::preferences,
                                                        tables::abilities,
                                                        tables::chance,
                                                        tables::order,
                                                        tables::responseTimes,
                                                        tables::checks,
                                                        tables::ratingPairs,
                                                        tables::authorTrials,
                                                        tables::authorTrialsPaired,
                                                        tables::groupInteractions,
                                                        tables::equivalence,
                                                        tables::sensitivity,
                                                        tables::unanswered,
                                                        tables::between,
                                                        tables::preferencesBetween,
                                                        tables::confusion,
                                                        tables::drift})
        out.push_back(table(result));
    return out;
}

std::vector<Table> tablesOfStudies(const AnalysisResult& result) {
    using namespace tables;
    if (result.by_study.empty()) return {};
    return {
        studies(result),
        studyMedians(result),
        eachStudy(result, "study_means", "Means of participants' means in each study", means),
        eachStudy(result, "study_omnibus", "Friedman's test over all systems in each study", omnibus),
        eachStudy(result, "study_pairwise",
                  "Pairs of systems in each study: signed-rank tests of participants' means", pairwise),
        eachStudy(result, "study_pairwise_ratings",
                  "Pairs of systems in each study by single ratings (pseudo-replicated: p is too small): "
                  "signed-rank tests",
                  ratingPairs),
        eachStudy(result, "study_author_trials",
                  "Ratings in each study by the author's trial in which the clips were made "
                  "(pseudo-replicated: p is too small): rank-sum tests",
                  authorTrials),
        eachStudy(result, "study_author_trials_by_participants",
                  "Participants' mean ratings in each study by the author's trial in which the clips were "
                  "made: signed-rank tests",
                  authorTrialsPaired),
        eachStudy(result, "study_preferences", "Preferences between systems in each study", preferences)};
}

void append(std::vector<Table>& out, std::vector<Table> more) {
    for (Table& table : more) out.push_back(std::move(table));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> analysisTables(const AnalysisResult& result,
                                                                TableFormat format) {
    const bool csv = format == TableFormat::csv;
    std::vector<Table> all{tables::means(result), tables::levels(result)};
    append(all, {tables::notCompared(result)});
    append(all, tablesOfOneStudy(result));
    append(all, {tables::observers(result.observers), tables::angles(result), tables::targetSpace(result),
                 tables::measuredSpace(result), tables::objectiveMeans(result),
                 tables::objectiveCorrelations(result), tables::pooledRatings(result), tables::scores(result),
                 tables::reliability(result)});
    if (!result.by_study.empty())
        for (Table& table : all)
            for (const std::string_view pooled : {"means", "omnibus", "pairwise", "preferences"})
                if (table.name == pooled) table.caption += ", all studies pooled";
    append(all, tablesOfStudies(result));
    if (csv)
        append(all, {tables::items(result), tables::leftOut(result), tables::participantMeans(result),
                     tables::quality(result), tables::settings(result)});
    std::vector<std::pair<std::string, std::string>> out;
    for (const Table& table : all)
        if (!table.rows.empty())
            out.emplace_back(table.name + (csv ? ".csv" : ".tex"), csv ? csvText(table) : latexText(table));
    if (csv && !result.table.rows.empty()) out.emplace_back("answers.csv", answersCsv(result.table));
    return out;
}

}  // namespace deixis::results
