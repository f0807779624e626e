// Tables of several studies that are analysed together.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/outputs/analysis_tables.hpp"

namespace deixis::results::tables {

Table eachStudy(const AnalysisResult& result, const char* name, const char* caption,
                Table (*table)(const AnalysisResult&)) {
    Table out{name, units::none, caption, {{"study", ColumnKind::text, {.heading = true}}}};
    for (const AnalysisResult& study : result.by_study) {
        Table one = table(study);
        out.unit = one.unit;
        if (out.columns.size() == 1)
            out.columns.insert(out.columns.end(), one.columns.begin(), one.columns.end());
        for (Table::Row& row : one.rows) {
            row.cells.insert(row.cells.begin(), study.table.study_name);
            out.rows.push_back(std::move(row));
        }
    }
    return out;
}

Table studyMedians(const AnalysisResult& result) {
    return withScales(
        tableOf<MedianResult>("study_medians", units::means_beside_ratings,
                              "Medians in order, in each study and pooled",
                              {{"measure", &MedianResult::measure, {.heading = true}},
                               {"study", &MedianResult::study, {.heading = true}},
                               {"place", &MedianResult::place, {.label = "Place"}},
                               {"system", &MedianResult::system},
                               {"median", &MedianResult::median, {.latex = "median (participants)"}},
                               {"median_of_ratings",
                                &MedianResult::answers_median,
                                {"of ratings", "median (ratings)", Format::score}},
                               {"participants", &MedianResult::participants, {.label = "n"}},
                               {"answers", &MedianResult::answers, {.label = "Answers"}}},
                              result.medians),
        result);
}

Table studies(const AnalysisResult& result) {
    Fields<DataOrigin> fields{{"study", &DataOrigin::study, {.in = in_csv | in_print, .heading = true}},
                              {"data", &DataOrigin::data, {.json = "file"}},
                              {"title", &DataOrigin::title, {.in = in_data}},
                              {"study_hash", &DataOrigin::study_hash, {.in = in_data}},
                              {"answers_hash", &DataOrigin::answers_hash, {.in = in_data}},
                              {"schema_version",
                               [](auto& one) { return known(one.schema_version > 0, one.schema_version); },
                               {.latex = "schema"}}};
    const auto add = [&](const char* name, std::vector<std::string> DataOrigin::*of) {
        fields.push_back(
            {name, [=](auto& one) { return fmt::format("{}", fmt::join(one.*of, "; ")); }, {.in = in_csv}});
        fields.push_back({name, [=](auto& one) { return Json(one.*of); }, {.in = in_json}});
    };
    add("recorded_by", &DataOrigin::program_versions);
    add("recorded_on", &DataOrigin::operating_systems);
    add("avatar_hashes", &DataOrigin::avatar_hashes);
    for (const auto& [name, of] : {std::pair{"people", &DataOrigin::people},
                                   {"simulated", &DataOrigin::simulated},
                                   {"answers", &DataOrigin::answers},
                                   {"left_out", &DataOrigin::left_out},
                                   {"withdrawn", &DataOrigin::withdrawn}})
        fields.push_back({name, of});
    return tableOf("studies", units::participants, "The studies, and the data of each", fields,
                   result.table.origins);
}

}  // namespace deixis::results::tables
