// The page that links to the reports of several kinds of station, and compares these.
#pragma once

#include <string>
#include <vector>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// The report of the answers given at one kind of station.
struct StationReport {
    std::string kind;
    std::string page;  ///< file name; empty if none was written
    int participants = 0;
    int answers = 0;
};

/// `between`: the analysis of withStations(). Of its results only the comparison of stations is shown: their
/// answers are nowhere one mean.
[[nodiscard]] std::string renderStations(const AnalysisResult& between,
                                         const std::vector<StationReport>& reports);
[[nodiscard]] std::string stationsJson(const AnalysisResult& between,
                                       const std::vector<StationReport>& reports);

}  // namespace deixis::results
