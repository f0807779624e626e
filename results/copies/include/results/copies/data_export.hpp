// Data out: tidy CSV tables with a codebook.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

struct ExportOptions {
    /// Other ids (A001, A002, ..., in an order that does not follow the old ones), no free text, no
    /// operator's notes, no dates: times count from the session's start.
    bool anonymise = false;
    bool tracking = true;
    bool ids_stand = false;  ///< anonymise: of a copy that is anonymous already, whose ids stay
};

/// Writes responses.csv, trials.csv, participants.csv, sessions.csv, events.csv, scores.csv, questions.csv,
/// tracking.csv (where there is any) and codebook.json (Psych-DS style column descriptions) into `folder`,
/// which is made and must be empty or hold an earlier export, also one that was interrupted. All is written
/// aside first, in the folder's `.export-under-way`: where that fails an earlier export stays as it is. RFC
/// 4180, UTF-8; a text that a spreadsheet would take for a formula is written with a leading apostrophe.
/// Returns the names of the files written. The same database gives the same bytes.
[[nodiscard]] Result<std::vector<std::string>> exportCsv(const std::filesystem::path& database,
                                                         const std::filesystem::path& folder,
                                                         const ExportOptions& options);

}  // namespace deixis::results
