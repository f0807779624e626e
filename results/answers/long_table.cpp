#include "results/answers/long_table.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <utility>

#include "core/files.hpp"
#include "core/foreign_csv.hpp"
#include "core/parallel.hpp"
#include "long_table_doubts.hpp"
#include "long_table_reader.hpp"
#include "results/database/database_files.hpp"

namespace deixis::results {

namespace {

std::size_t countLines(std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// From the line that begins at or behind `from` up to the one that does so for `to`.
std::string_view linesBetween(std::string_view text, std::size_t from, std::size_t to) {
    const auto lineAt = [&](std::size_t at) {
        return at == 0 ? 0 : std::min(text.find('\n', at - 1), text.size() - 1) + 1;
    };
    return text.substr(lineAt(from), lineAt(to) - lineAt(from));
}

Result<ResponseTable> readWhole(const std::filesystem::path& file, std::string_view text, CsvForm form,
                                const LongTableOptions& options) {
    LongTableReader reader(file, text, form, options);
    if (auto head = reader.readHead(); !head) return tl::unexpected(head.error());
    if (auto rows = reader.readRows(countLines(text)); !rows) return tl::unexpected(rows.error());
    return reader.finish();
}

/// A long text in several parts at the same time; none where anything is wrong with it.
std::optional<ResponseTable> readInParts(const std::filesystem::path& file, std::string_view text,
                                         CsvForm form, const LongTableOptions& options) {
    constexpr std::size_t bytes_worth_a_thread = std::size_t{4} << 20U;
    LongTableReader columns(file, text, form, options);
    // An export has a trial in several lines, which a cut could part.
    if (!columns.readHead() || columns.isExport()) return std::nullopt;
    auto parts = mapRanges(text.size(), bytes_worth_a_thread, [&](std::size_t from, std::size_t to) {
        const std::string_view lines = linesBetween(text, from, to);
        auto part = from == 0 ? std::make_unique<LongTableReader>(file, lines, form, options)
                              : std::make_unique<LongTableReader>(columns, lines);
        const std::size_t expected = countLines(from == 0 ? text : lines);  // the first one takes the others'
        if ((from == 0 && !part->readHead()) || !part->readRows(expected)) part.reset();
        return part;
    });
    for (const auto& part : parts)
        if (!part || (part != parts.front() && !parts.front()->append(*part))) return std::nullopt;
    if (auto table = parts.front()->finish()) return std::move(*table);
    return std::nullopt;
}

}  // namespace

Result<ResponseTable> loadLongTable(const std::filesystem::path& file, const LongTableOptions& options) {
    auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto csv = readForeignCsv(std::move(*bytes), file.string());
    if (!csv) return tl::unexpected(csv.error());
    // A quoted field may go on in the next line: such a text is not cut. Nor is one with an error, which is
    // then told as the first in the file.
    std::optional<ResponseTable> in_parts;
    if (csv->text.find('"') == std::string::npos) in_parts = readInParts(file, csv->text, csv->form, options);
    auto table = in_parts ? Result<ResponseTable>(std::move(*in_parts))
                          : readWhole(file, csv->text, csv->form, options);
    if (table) addDoubts(*csv, *table);
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
