#include "results/answers/long_table.hpp"

#include <fstream>
#include <utility>

#include "core/files.hpp"
#include "core/foreign_csv.hpp"
#include "long_table_reader.hpp"
#include "long_table_warnings.hpp"
#include "results/database/database_files.hpp"

namespace deixis::results {

namespace {

Result<ResponseTable> readWhole(const std::filesystem::path& file, std::string_view text, CsvForm form,
                                const LongTableOptions& options) {
    LongTableReader reader(file, text, form, options);
    if (auto head = reader.readHead(); !head) return tl::unexpected(head.error());
    if (auto rows = reader.readRows(); !rows) return tl::unexpected(rows.error());
    return reader.finish();
}

}  // namespace

Result<ResponseTable> loadLongTable(const std::filesystem::path& file, const LongTableOptions& options) {
    auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto csv = readForeignCsv(std::move(*bytes), file.string());
    if (!csv) return tl::unexpected(csv.error());
    auto table = readWhole(file, csv->text, csv->form, options);
    if (table) addWarnings(*csv, *table);
    return table;
}

Result<ResponseTable> loadAnswers(const std::filesystem::path& file, const LongTableOptions& options) {
    std::error_code code;
    const auto status = std::filesystem::status(file, code);
    // What a pipe gives is gone once it is looked at; and a database is no pipe.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return loadLongTable(file, options);
    if (!std::filesystem::exists(status)) {
        // A database that was moved from beside its log.
        if (auto orphan = orphanBeside(file)) return tl::unexpected(std::move(*orphan));
        return fail(file.string(), "no such file, expected a database or a CSV file with answers",
                    "Check the path; a run prints the path of its database");
    }
    std::ifstream in(file, std::ios::binary);
    std::string start(15, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (in.is_open() && in.gcount() == 0)
        return fail(file.string(),
                    "the file is empty (0 bytes); expected a database or a CSV file with answers");
    const bool csv = in.gcount() > 0 && start != "SQLite format 3";
    if (csv) return loadLongTable(file, options);
    if (!options.between.empty() || !options.within.empty() || !options.columns.empty() ||
        !options.scales.empty())
        return fail(file.string(),
                    "--between, --within, --column and --scale are for CSV files, and this is a database",
                    "Leave them out: its study names its factors and scales");
    return loadResponses(file);
}

}  // namespace deixis::results
