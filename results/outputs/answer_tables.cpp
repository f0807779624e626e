// Tables of participants' means and of single answers.
#include <fmt/format.h>

#include <algorithm>

#include "results/answers/motion_origin.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/statistics/descriptive.hpp"
#include "test_fields.hpp"

namespace deixis::results {

Table withScales(Table table, const AnalysisResult& result) {
    const std::size_t place = table.at("measure");
    for (Table::Row& row : table.rows)
        row.percent = std::any_of(
            result.table.measures.begin(), result.table.measures.end(), [&](const Measure& measure) {
                return measure.kind == MeasureKind::accuracy && measure.name == row.cells[place].text();
            });
    return table;
}

namespace tables {

namespace {

struct SystemMeasure {
    std::string system;
    const Measure* measure = nullptr;
    const Summary* of = nullptr;
};

Cell boxJson(const Summary& summary) {
    const auto box = boxSummary(summary.by_participant);
    if (!box) return {};
    return Json{{"q05", box->q05},
                {"q25", box->q25},
                {"median", box->median},
                {"q75", box->q75},
                {"q95", box->q95},
                {"notch_low", box->notch_low},
                {"notch_high", box->notch_high}};
}

Fields<SystemMeasure> meanFields() {
    const auto people = [](const SystemMeasure& one) { return one.of->by_participant.size(); };
    return {{"mean", [](auto& one) { return known(one.of->n > 0, one.of->mean); }},
            {"median", [](auto& one) { return known(one.of->n > 0, one.of->median); }, {.in = in_data}},
            {"interval",
             [](auto& one) {
                 Interval out = intervalOf(one.of->interval);
                 if (one.of->interval_falls_short) out.mark = " \u2021";
                 return out;
             }},
            {"interval_falls_short", [](auto& one) { return one.of->interval_falls_short; }, {.in = in_json}},
            {"box", [](auto& one) { return boxJson(*one.of); }, {.in = in_json}},
            {"sd_participants",
             [=](auto& one) { return known(people(one) > 1, one.of->sd_participants); },
             {.place = 2}},
            {"sd_trials", [](auto& one) { return known(one.of->n > 1, one.of->sd_trials); }, {.place = 2}},
            {"participants", people, {.place = 1}},
            {"answers", [](auto& one) { return one.of->n; }, {.label = "n", .json = "n", .place = 3}}};
}

}  // namespace

Json summaryJson(const Summary& summary) {
    const auto fields = meanFields();
    return rowJson(columnsOf(fields), cellsOf(fields, SystemMeasure{"", nullptr, &summary}));
}

Table means(const AnalysisResult& result) {
    std::vector<SystemMeasure> rows;
    for (std::size_t m = 0; m < result.measures.size(); ++m)
        for (const SystemResult& system : result.systems)
            rows.push_back({system.system, &result.measures[m], &system.measures[m]});
    Fields<SystemMeasure> fields{
        {"measure", [](auto& one) { return one.measure->name; }, {.heading = true}},
        {"system", &SystemMeasure::system},
        {"median_of_many_steps",
         [](auto& one) { return known(one.of->n > 0 && hasManySteps(*one.measure), one.of->median); },
         {.label = "Median", .format = Format::score, .in = page_only}}};
    return withScales(tableOf("means", units::means,
                              fmt::format("Means of participants' means, {:g} % bootstrap intervals over "
                                          "participants, and standard deviations",
                                          100.0 * result.level),
                              joined(std::move(fields), meanFields()), rows),
                      result);
}

Table notCompared(const AnalysisResult& result) {
    std::vector<SystemMeasure> rows;
    for (std::size_t m = 0; m < result.measures.size(); ++m)
        for (const SystemResult& system : result.not_compared)
            rows.push_back({system.system, &result.measures[m], &system.measures[m]});
    Fields<SystemMeasure> fields{
        {"measure", [](auto& one) { return one.measure->name; }, {.heading = true}},
        {"system", &SystemMeasure::system},
        {"motion", [&](auto& one) { return motionText(result.table, one.system); }},
        {"remark", [&](auto& one) { return result.table.not_compared.at(one.system); }}};
    return withScales(
        tableOf("not_compared", units::means, "Systems that are not compared: means of participants' means",
                joined(std::move(fields), meanFields()), rows),
        result);
}

Table levels(const AnalysisResult& result, const std::string& factor, const char* key) {
    const Fields<LevelResult> fields{
        {"measure", &LevelResult::measure, {.heading = true}},
        {"factor", &LevelResult::factor, {.in = in_csv | in_print, .heading = true}},
        {"system", &LevelResult::system},
        {"factor", &LevelResult::factor, {.in = std::string(key) == "level" ? in_json : page_only}},
        {"level", &LevelResult::level, {.json = key}},
        {"mean", [](auto& one) { return known(one.n > 0, one.mean); }},
        {"sd_trials", [](auto& one) { return known(one.n > 1, one.sd_trials); }},
        {"answers", &LevelResult::n, {.json = "n"}},
        {"mean_participants",
         [](auto& one) { return known(one.over_participants.n > 0, one.over_participants.mean); },
         {.in = in_data}},
        {"interval", [](auto& one) { return intervalOf(one.over_participants.interval); }, {.in = in_data}},
        {"participants",
         [](auto& one) { return one.over_participants.by_participant.size(); },
         {.in = in_data}}};
    Table out = tableOf("levels", units::answers,
                        "Means and standard deviations over trials, by the levels of within factors", fields,
                        result.levels);
    return factor.empty() ? out : out.where("factor", factor);
}

Table pooledRatings(const AnalysisResult& result) {
    return withScales(
        tableOf<PooledResult>("pooled_ratings", hasRatingsOnly(result) ? units::ratings : units::answers,
                              hasRatingsOnly(result) ? "Single ratings (pseudo-replicated)"
                                                     : "Single answers (pseudo-replicated)",
                              {{"measure", &PooledResult::measure, {.heading = true}},
                               {"system", &PooledResult::system},
                               {"n", &PooledResult::n},
                               {"mean", &PooledResult::mean},
                               {"sd", [](auto& one) { return known(one.n > 1, one.sd); }},
                               {"q05", &PooledResult::q05},
                               {"q25", &PooledResult::q25},
                               {"median", &PooledResult::median},
                               {"q75", &PooledResult::q75},
                               {"q95", &PooledResult::q95},
                               noteField<PooledResult>("pseudo-replicated: answers treated as independent")},
                              result.pooled),
        result);
}

Table responseTimes(const AnalysisResult& result) {
    return tableOf<TimeResult>("response_times", units::answers, "Response times over answers, seconds",
                               {{"measure", &TimeResult::measure, {.heading = true}},
                                {"system", &TimeResult::system},
                                {"n", &TimeResult::n},
                                {"q25_s", &TimeResult::q25_s},
                                {"median_s", &TimeResult::median_s},
                                {"q75_s", &TimeResult::q75_s}},
                               result.times);
}

Table items(const AnalysisResult& result) {
    return withScales(tableOf<ItemResult>("items", units::answers, "Items over systems and participants",
                                          {{"measure", &ItemResult::measure},
                                           {"item", &ItemResult::item, {.label = "Item"}},
                                           {"mean", &ItemResult::mean},
                                           {"answers", &ItemResult::n, {.label = "n", .json = "n"}}},
                                          result.items),
                      result);
}

/// One line for each participant, measure and system that has answers.
Table participantMeans(const AnalysisResult& result) {
    Table out{"participant_means", units::means, "Participants' means"};
    for (const char* name : {"participant", "measure", "system"})
        out.columns.push_back({name, ColumnKind::text});
    for (const char* name : {"mean", "answers"}) out.columns.push_back({name, ColumnKind::number});
    for (std::size_t m = 0; m < result.measures.size(); ++m) {
        // Of each system, which participant with answers is next.
        std::vector<std::size_t> next(result.systems.size(), 0);
        for (const PresenceRow& row : result.presence)
            for (std::size_t s = 0; s < result.systems.size(); ++s)
                if (const int answers = row.answers[m][s]; answers > 0)
                    out.rows.push_back({{row.participant, result.measures[m].name, result.systems[s].system,
                                         result.systems[s].measures[m].by_participant[next[s]++], answers}});
    }
    return out;
}

/// What the tables depend on and do not tell.
Table settings(const AnalysisResult& result) {
    Table out{"settings", units::none, "Settings"};
    out.columns = {{"name", ColumnKind::text}, {"value", ColumnKind::number}};
    out.rows = {{{"alpha", result.alpha}},
                {{"level", result.level}},
                {{"resamples", static_cast<double>(result.options.resamples)}},
                {{"seed", static_cast<double>(result.options.seed)}}};
    return out;
}

}  // namespace tables

}  // namespace deixis::results
