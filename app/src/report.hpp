#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/analysis.hpp"
#include "results/long_table.hpp"

namespace deixis::app {

/// What a report is written to; an empty name leaves that one out.
struct ReportFiles {
    std::string page{};  ///< HTML
    std::string json{};
    std::string csv{};    ///< a folder
    std::string latex{};  ///< a folder
};

/// Analyses databases of one study, or long tables (CSV) with these factors, and writes the files.
[[nodiscard]] Result<void> writeReport(const std::vector<std::string>& data, const ReportFiles& files,
                                       const results::AnalysisOptions& options = {},
                                       const results::FactorColumns& factors = {});

/// A slip of the names must not cost a study: fails where the file is a database. An empty name passes.
[[nodiscard]] Result<void> checkOutput(const std::string& file);

}  // namespace deixis::app
