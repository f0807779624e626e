// What a reader may doubt in a table of answers from elsewhere; private to its reader.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/foreign_csv.hpp"
#include "results/answers/response_table.hpp"

namespace deixis::results {

/// Columns that are not read and look like attention checks or exclusions.
[[nodiscard]] std::optional<std::string> warningOfUnread(const std::vector<std::string>& unread);

/// Adds to the notes: answers that stand twice, numbers that may stand for a missing answer, times that may
/// be milliseconds, names that differ in case, spaces or zeros only, and letters that may be wrong. Changes
/// nothing else.
void addWarnings(const ForeignCsv& csv, ResponseTable& table);

}  // namespace deixis::results
