#include "results/report/stations_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "results/answers/stations.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

/// The tests of stations alone: of each system, and over all.
AnalysisResult onlyStations(AnalysisResult result) {
    std::erase_if(result.between, [](const BetweenResult& one) { return one.factor != station_factor; });
    std::erase_if(result.preferences_between,
                  [](const PreferenceBetweenResult& one) { return one.factor != station_factor; });
    std::erase_if(result.table.between, [](const Factor& one) { return one.name != station_factor; });
    return result;
}

}  // namespace

std::string renderStations(const AnalysisResult& between, const std::vector<StationReport>& reports) {
    const AnalysisResult stations = onlyStations(between);
    std::string out =
        pageStart(between.table.study_title + " \u2013 report", between.table.study_title) +
        paragraphHtml(fmt::format("Answers from {} kinds of station, analysed apart", reports.size()),
                      ParagraphLook::lead);
    Numbering numbering;
    Table table{"stations",
                units::stations,
                "",
                {{"station", ColumnKind::text, {.label = "Station"}},
                 {"participants", ColumnKind::number},
                 {"answers", ColumnKind::number},
                 {"link", ColumnKind::text, {.label = "Report"}}}};
    for (const StationReport& one : reports)
        table.rows.push_back({{one.kind + (one.kind == simulated_station ? " (no people)" : ""),
                               one.participants, one.answers, known(!one.page.empty(), one.page)}});
    out += tableHtml(
        table,
        "A report for each kind of station. Their answers are never averaged; a study may say stations = "
        "\"together\" in [analysis].",
        numbering);
    Section tests = betweenSection(stations, numbering);
    if (tests.html.empty()) out += paragraphHtml("No two kinds of station have people's answers to compare.");
    return withContents(out, {tests, remarksSection(between.table.notes)}) +
           pageEnd("The tables have all its numbers.");
}

std::string stationsJson(const AnalysisResult& between, const std::vector<StationReport>& reports) {
    const AnalysisResult stations = onlyStations(between);
    nlohmann::ordered_json out;
    out["schema"] = {{"name", "deixis-analysis-by-station"}, {"version", 1}};
    out["stations"] = nlohmann::ordered_json::array();
    for (const StationReport& one : reports)
        out["stations"].push_back(
            {{"station", one.kind}, {"participants", one.participants}, {"answers", one.answers}});
    out["between"] = tableJson(tables::between(stations));
    out["preferences_between"] = tableJson(tables::preferencesBetween(stations));
    return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace deixis::results
