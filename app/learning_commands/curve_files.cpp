#include "curve_files.hpp"

#include <utility>

#include "core/files.hpp"

namespace deixis::app {

Result<std::optional<CsvSheet>> readCurveTable(const std::filesystem::path& weights_file) {
    const std::filesystem::path file = weights_file.string() + ".curves.csv";
    std::error_code code;
    if (!std::filesystem::exists(file, code)) return std::optional<CsvSheet>();
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    auto sheet = parseCsvSheet(*bytes, file.string());
    if (!sheet) return tl::unexpected(sheet.error());
    return std::optional(std::move(*sheet));
}

Result<void> writeCurveFiles(const std::filesystem::path& weights_file, const std::string& csv,
                             const std::string& page) {
    if (const auto written = writeFile(weights_file.string() + ".curves.csv", csv); !written) return written;
    return writeFile(weights_file.string() + ".curves.html", page);
}

}  // namespace deixis::app
