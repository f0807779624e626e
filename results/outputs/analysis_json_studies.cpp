#include "analysis_json_studies.hpp"

#include "analysis_json_ratings.hpp"
#include "results/outputs/analysis_json_groups.hpp"
#include "results/tables/json_values.hpp"

namespace deixis::results {

namespace {

using StudyJson = nlohmann::ordered_json;

StudyJson dataJson(const AnalysisResult& result, const std::string& study) {
    StudyJson out = StudyJson::array();
    for (const DataOrigin& one : result.table.origins)
        if (one.study == study)
            out.push_back(
                {{"file", one.data},
                 {"title", one.title},
                 {"study_hash", one.study_hash},
                 {"answers_hash", one.answers_hash},
                 {"schema_version", one.schema_version > 0 ? StudyJson(one.schema_version) : StudyJson()},
                 {"recorded_by", one.program_versions},
                 {"recorded_on", one.operating_systems},
                 {"avatar_hashes", one.avatar_hashes},
                 {"people", one.people},
                 {"simulated", one.simulated},
                 {"answers", one.answers},
                 {"left_out", one.left_out},
                 {"withdrawn", one.withdrawn}});
    return out;
}

}  // namespace

StudyJson byStudyJson(const AnalysisResult& result) {
    StudyJson out = StudyJson::array();
    for (const AnalysisResult& one : result.by_study) {
        StudyJson row{{"study", one.table.study_name},       {"data", dataJson(result, one.table.study_name)},
                      {"participants", one.participants},    {"synthetic", one.synthetic},
                      {"answers", one.table.rows.size()},    {"systems", systemsJson(one)},
                      {"omnibus", omnibusJson(one)},         {"pairwise", pairwiseJson(one)},
                      {"preferences", preferencesJson(one)}, {"between", betweenJson(one)}};
        addRatings(row, one);
        out.push_back(std::move(row));
    }
    return out;
}

StudyJson mediansJson(const AnalysisResult& result) {
    StudyJson out = StudyJson::array();
    for (const MedianResult& one : result.medians)
        out.push_back({{"measure", one.measure},
                       {"study", one.study},
                       {"place", one.place},
                       {"system", one.system},
                       {"median", one.median},
                       {"median_of_ratings", numberOrNull(one.answers_median)},
                       {"participants", one.participants},
                       {"answers", one.answers}});
    return out;
}

}  // namespace deixis::results
