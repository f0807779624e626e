#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/analysis.hpp"

namespace deixis::app {

/// What a report is written to; an empty name leaves that one out.
struct ReportFiles {
    std::string page{};  ///< HTML
    std::string json{};
    std::string csv{};    ///< a folder
    std::string latex{};  ///< a folder
    std::string r{};      ///< a folder: the tables as CSV and analysis.R, which computes them anew
};

/// Analyses databases of one study, long tables (CSV), or a study on a server, and writes the files.
[[nodiscard]] Result<void> writeReport(const std::vector<std::string>& data, const ReportFiles& files,
                                       const results::AnalysisOptions& options = {},
                                       const std::string& study = {});

/// The answers of all of them as one table. `study`: which of a server's, its name or how its hash begins;
/// empty where the server holds one.
[[nodiscard]] Result<results::ResponseTable> loadAll(const std::vector<std::string>& data,
                                                     const std::string& study = {});

/// A slip of the names must not cost a study: fails where the file is a database. An empty name passes.
[[nodiscard]] Result<void> checkOutput(const std::string& file);

}  // namespace deixis::app
