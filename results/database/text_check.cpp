#include "results/database/text_check.hpp"

#include <fmt/core.h>

#include <string>

#include "core/text.hpp"
#include "results/database/tables.hpp"

namespace deixis::results {

namespace {

/// "trial_index 12, position 0": by the columns that `key` lists, or the first.
std::string rowName(const SQLite::Statement& row, std::string_view key) {
    std::string out;
    for (int i = 0; i < row.getColumnCount(); ++i) {
        const std::string name = row.getColumnName(i);
        if (name != "participant" && !isListed(key, name) && !(key.empty() && i == 0)) continue;
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name, storable(row.getColumn(i).getString()));
    }
    return out;
}

Result<void> checkTable(SQLite::Database& database, const std::filesystem::path& path, const char* table,
                        std::string_view key) {
    SQLite::Statement row(database, fmt::format("SELECT * FROM {}", table));
    while (row.executeStep())
        for (int i = 0; i < row.getColumnCount(); ++i) {
            const SQLite::Column value = row.getColumn(i);
            if (!value.isText() || storableText(value.getString())) continue;
            return fail(
                path.string(),
                fmt::format("table {}, row with {}: the column {} has '{}', which is not UTF-8 text and "
                            "cannot be stored on a server",
                            table, rowName(row, key), row.getColumnName(i), storable(value.getString())),
                "Correct it in a copy with an SQLite browser, and push that");
        }
    return {};
}

}  // namespace

Result<void> checkTexts(SQLite::Database& database, const std::filesystem::path& path) {
    for (const char* table : study_tables)
        if (auto checked = checkTable(database, path, table, ""); !checked) return checked;
    for (const ParticipantTable& table : participant_tables)
        if (auto checked = checkTable(database, path, table.name, table.key); !checked) return checked;
    return {};
}

}  // namespace deixis::results
