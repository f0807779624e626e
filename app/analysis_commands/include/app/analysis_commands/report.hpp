// Writing a report from databases, CSV files or a server: for the command, and at the end of a session.
#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/analysis/analysis.hpp"
#include "results/analysis/several_studies.hpp"
#include "results/answers/long_table.hpp"

namespace deixis::app {

/// What a report is written to; an empty name leaves that one out.
struct ReportFiles {
    std::string page{};  ///< HTML
    std::string json{};
    std::string csv{};    ///< a folder
    std::string latex{};  ///< a folder
    std::string r{};      ///< a folder: the tables as CSV and analysis.R, which computes them again
    bool force = false;   ///< also over files in these folders that are no earlier versions of the same
};

/// Which of the answers that the data hold.
struct DataChoice {
    std::string study{};              ///< of a server's, its name or how its hash begins; empty: its only one
    results::LongTableOptions csv{};  ///< how long tables are read
    std::string stimuli{};  ///< folder of the clips that databases' sessions showed; empty: where they were
    std::string evaluation{};    ///< file of an objective evaluation; empty: none
    bool without_clips = false;  ///< they are not looked at
    /// "apart", "together" or one kind of station; empty: as the study says, apart where it does not.
    std::string stations{};
    results::JoinChoice join{};  ///< of several data
};

/// Analyses databases of one or several studies, long tables (CSV), or a study on a server, and writes the
/// files.
[[nodiscard]] Result<void> writeReport(const std::vector<std::string>& data, const ReportFiles& files,
                                       const results::AnalysisOptions& options = {},
                                       const DataChoice& choice = {});

/// The answers of all of them as one table; of one study.
[[nodiscard]] Result<results::ResponseTable> loadAll(const std::vector<std::string>& data,
                                                     const DataChoice& choice = {});

}  // namespace deixis::app
