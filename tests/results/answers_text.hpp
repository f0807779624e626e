// Answers given as the text of a CSV file, analysed.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/long_table.hpp"
#include "results/outputs/analysis_tables.hpp"

namespace fixtures {

inline results::AnalysisResult analyseText(const std::string& text,
                                           const results::LongTableOptions& choice = {},
                                           const results::AnalysisOptions& options = {}) {
    const Folder folder;
    REQUIRE(writeFile(folder / "answers.csv", text).has_value());
    const auto table = results::loadAnswers(folder / "answers.csv", choice);
    REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().text()));
    return results::analyse(*table, options);
}

/// One of the tables as CSV; empty where it has no rows.
inline std::string csvOf(const results::AnalysisResult& result, const std::string& file) {
    for (const auto& [name, bytes] : results::analysisTables(result, results::TableFormat::csv))
        if (name == file) return bytes;
    return "";
}

}  // namespace fixtures
