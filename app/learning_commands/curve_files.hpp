// The files beside a training's weights that tell how it went: FILE.curves.csv and FILE.curves.html.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/csv_sheet.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// The table; none where there is none yet.
[[nodiscard]] Result<std::optional<CsvSheet>> readCurveTable(const std::filesystem::path& weights_file);
[[nodiscard]] Result<void> writeCurveFiles(const std::filesystem::path& weights_file, const std::string& csv,
                                           const std::string& page);

}  // namespace deixis::app
