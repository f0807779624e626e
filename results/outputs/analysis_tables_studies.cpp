#include "analysis_tables_studies.hpp"

#include "analysis_tables_ratings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace deixis::results {

namespace {

using enum ColumnType;

/// The rows of one table of each study, with the study's name before them.
PlainTable eachStudy(const AnalysisResult& result, const std::string& name, const std::string& caption,
                     PlainTable (*table)(const AnalysisResult&)) {
    PlainTable out{name, table(result).unit, caption, {{"study", text, Print::heading}}};
    for (const AnalysisResult& study : result.by_study) {
        PlainTable one = table(study);
        if (out.columns.size() == 1)
            out.columns.insert(out.columns.end(), one.columns.begin(), one.columns.end());
        for (auto& row : one.rows) {
            row.insert(row.begin(), PlainCell(study.table.study_name));
            out.rows.push_back(std::move(row));
        }
    }
    return out;
}

PlainTable mediansTable(const AnalysisResult& result) {
    PlainTable out{"study_medians",
                   units::means_beside_ratings,
                   "Medians in order, in each study and pooled",
                   {{"measure", text, Print::heading},
                    {"study", text, Print::heading},
                    {"place", whole, Print::plain},
                    {"system", text, Print::plain},
                    {"median", number, Print::plain, "median (participants)"},
                    {"median_of_ratings", number, Print::plain, "median (ratings)"},
                    {"participants", whole, Print::plain},
                    {"answers", whole, Print::plain}}};
    for (const MedianResult& one : result.medians)
        out.rows.push_back({one.measure, one.study, wholeCell(one.place), one.system, PlainCell(one.median),
                            plainCell(one.answers_median), wholeCell(one.participants),
                            wholeCell(one.answers)});
    return out;
}

PlainTable originsTable(const AnalysisResult& result) {
    PlainTable out{"studies",
                   units::participants,
                   "The studies, and the data of each",
                   {{"study", text, Print::heading},
                    {"data", text, Print::plain},
                    {"title", text},
                    {"study_hash", text},
                    {"answers_hash", text},
                    {"schema_version", whole, Print::plain, "schema"},
                    {"recorded_by", text},
                    {"recorded_on", text},
                    {"avatar_hashes", text},
                    {"people", whole, Print::plain},
                    {"simulated", whole, Print::plain},
                    {"answers", whole, Print::plain},
                    {"left_out", whole, Print::plain, "left out"},
                    {"withdrawn", whole, Print::plain}}};
    const auto joined = [](const std::vector<std::string>& texts) {
        return PlainCell(fmt::format("{}", fmt::join(texts, "; ")));
    };
    for (const DataOrigin& one : result.table.origins)
        out.rows.push_back({one.study, one.data, one.title, one.study_hash, one.answers_hash,
                            one.schema_version > 0 ? wholeCell(one.schema_version) : PlainCell(),
                            joined(one.program_versions), joined(one.operating_systems),
                            joined(one.avatar_hashes), wholeCell(one.people), wholeCell(one.simulated),
                            wholeCell(one.answers), wholeCell(one.left_out), wholeCell(one.withdrawn)});
    return out;
}

}  // namespace

std::vector<PlainTable> studyTables(const AnalysisResult& result) {
    if (result.by_study.empty()) return {};
    return {
        originsTable(result),
        mediansTable(result),
        eachStudy(result, "study_means", "Means of participants' means in each study", meansTable),
        eachStudy(result, "study_omnibus", "Friedman's test over all systems in each study", omnibusTable),
        eachStudy(result, "study_pairwise",
                  "Pairs of systems in each study: signed-rank tests of participants' means", pairwiseTable),
        eachStudy(result, "study_pairwise_ratings",
                  "Pairs of systems in each study by single ratings (pseudo-replicated: p is too small): "
                  "signed-rank tests",
                  ratingPairsTable),
        eachStudy(result, "study_author_trials",
                  "Ratings in each study by the author's trial in which the clips were made "
                  "(pseudo-replicated: p is too small): rank-sum tests",
                  authorTrialsTable),
        eachStudy(result, "study_author_trials_by_participants",
                  "Participants' mean ratings in each study by the author's trial in which the clips were "
                  "made: signed-rank tests",
                  authorTrialsPairedTable),
        eachStudy(result, "study_preferences", "Preferences between systems in each study",
                  preferencesTable)};
}

}  // namespace deixis::results
