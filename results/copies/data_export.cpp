#include "results/copies/data_export.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "anonymous_names.hpp"
#include "core/staging.hpp"
#include "export_files.hpp"
#include "export_tables.hpp"
#include "results/database/database_open.hpp"

namespace deixis::results {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool leftOut(const ExportColumn& column, bool anonymise) {
    return anonymise && column.privacy == Privacy::left_out;
}

ExportedFile fillTable(SQLite::Database& database, const ExportTable& table, const AnonymousNames& naming,
                       bool anonymise) {
    std::vector<ColumnSpec> specs;
    std::vector<Privacy> privacies;
    std::string query = "SELECT ";
    for (const ExportColumn& column : table.columns) {
        if (leftOut(column, anonymise)) continue;
        if (!specs.empty()) query += ", ";
        query += anonymise && !column.anonymous_sql.empty() ? column.anonymous_sql : column.sql;
        specs.push_back(column.spec);
        privacies.push_back(column.privacy);
    }
    ExportedFile out{table.file, table.description, CsvTable(std::move(specs))};
    SQLite::Statement rows(database, query + " " + table.from);
    for (const std::string& participant : naming.participants()) {
        rows.reset();
        rows.bind(1, participant);
        while (rows.executeStep()) {
            long long session = 0;
            for (std::size_t i = 0; i < privacies.size(); ++i) {
                const SQLite::Column value = rows.getColumn(static_cast<int>(i));
                if (privacies[i] == Privacy::participant) {
                    out.table.text(naming.nameOf(participant));
                } else if (privacies[i] == Privacy::session) {
                    session = value.getInt64();
                    out.table.whole(naming.nameOfSession(session));
                } else if (privacies[i] == Privacy::clock && !value.isNull()) {
                    out.table.number(value.getDouble() - naming.startOfSession(session));
                } else {
                    out.table.cell(value);
                }
            }
            out.table.endRow();
        }
    }
    return out;
}

const char* schemaType(ColumnType type) {
    switch (type) {
        case ColumnType::text:
            return "string";
        case ColumnType::number:
            return "number";
        case ColumnType::whole:
            return "integer";
        case ColumnType::truth:
            return "boolean as 0 or 1";
    }
    return "";
}

// As Psych-DS describes variables, file by file.
std::string codebook(SQLite::Database& database, const std::vector<ExportedFile>& files, bool anonymise) {
    SQLite::Statement study(database, "SELECT name, title, hash FROM study");
    study.executeStep();
    const bool synthetic = database.execAndGet("SELECT count(*) FROM sessions WHERE synthetic").getInt() > 0;
    Json out{{"@context", "https://schema.org/"},
             {"@type", "Dataset"},
             {"name", study.getColumn(0).getString()},
             {"description", study.getColumn(1).getString()},
             {"identifier", "sha256:" + study.getColumn(2).getString()},
             {"anonymised", anonymise},
             {"contains_synthetic_answers", synthetic}};
    out["hasPart"] = Json::array();
    for (const ExportedFile& file : files) {
        Json variables = Json::array();
        std::string before;
        for (const ColumnSpec& column : file.table.columns()) {
            // What needs no description of its own shares the one before.
            const std::string& description = column.description.empty() ? before : column.description;
            before = description;
            Json variable{{"@type", "PropertyValue"},
                          {"name", column.name},
                          {"description", description},
                          {"valueType", schemaType(column.type)}};
            if (!column.unit.empty()) variable["unitText"] = column.unit;
            variables.push_back(std::move(variable));
        }
        out["hasPart"].push_back({{"@type", "DataDownload"},
                                  {"name", file.name},
                                  {"encodingFormat", "text/csv"},
                                  {"description", file.description},
                                  {"rows", file.table.rows()},
                                  {"variableMeasured", std::move(variables)}});
    }
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// In it all files are written first, and then moved to their places in the export's folder.
constexpr const char* staging_name = ".export-under-way";

// A folder of ours may be written over, anything else may not. One that was interrupted has its staging yet.
Result<void> checkFolder(const fs::path& folder) {
    std::error_code code;
    if (!fs::exists(folder, code)) return {};
    if (!fs::is_directory(folder, code))
        return fail(folder.string(), "found a file, expected a folder to write to",
                    "Name another one with -o");
    if (fs::is_empty(folder, code) || fs::exists(folder / "codebook.json", code) ||
        fs::exists(folder / staging_name, code))
        return {};
    return fail(folder.string(), "the folder is not empty and does not contain an earlier export",
                "Name another one with -o");
}

constexpr const char* tracking_name = "tracking.csv";

/// Tracked frames, too many to be held, go into the folder at once.
Result<std::vector<ExportedFile>> readAll(SQLite::Database& database, const ExportOptions& options,
                                          const fs::path& folder, std::string& description) {
    const AnonymousNames naming(database, options.anonymise && !options.ids_stand);
    std::vector<ExportedFile> files;
    for (const ExportTable& table : exportTables(database))
        files.push_back(fillTable(database, table, naming, options.anonymise));
    files.push_back(participantsFile(database, naming, options.anonymise));
    files.push_back(scoresFile(database, naming));
    files.push_back(questionsFile(database));
    if (options.tracking) {
        auto tracking = trackingFile(database, naming, options.anonymise, folder / tracking_name);
        if (!tracking) return tl::unexpected(tracking.error());
        if (tracking->table.rows() > 0) files.push_back(std::move(*tracking));
    }
    description = codebook(database, files, options.anonymise);
    return files;
}

}  // namespace

Result<std::vector<std::string>> exportCsv(const fs::path& database, const fs::path& folder,
                                           const ExportOptions& options) {
    if (auto checked = checkFolder(folder); !checked) return tl::unexpected(checked.error());
    auto staging = Staging::within(folder, staging_name);
    if (!staging) return tl::unexpected(staging.error());
    std::string description;
    const auto files = readDatabase(database, [&](SQLite::Database& opened) {
        return readAll(opened, options, staging->path(), description);
    });
    if (!files) return tl::unexpected(files.error());
    std::vector<std::string> names;
    for (const ExportedFile& file : *files) {
        names.push_back(file.name);
        if (file.name == tracking_name) continue;
        if (auto written = staging->add(file.name, file.table.bytes()); !written)
            return tl::unexpected(written.error());
    }
    names.emplace_back("codebook.json");
    if (auto written = staging->add(names.back(), description); !written)
        return tl::unexpected(written.error());
    // Of an earlier export nothing is left beside them. The codebook, which makes the folder an export, comes
    // last; until then it is known as one by the staging.
    if (auto moved =
            staging->moveHome({names.begin(), names.end()},
                              {"codebook.json", "responses.csv", "trials.csv", "sessions.csv", "events.csv",
                               "participants.csv", "scores.csv", "questions.csv", "tracking.csv"},
                              true);
        !moved)
        return tl::unexpected(moved.error());
    return names;
}

}  // namespace deixis::results
