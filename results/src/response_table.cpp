#include "results/response_table.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/core.h>

#include <cctype>

#include "database_errors.hpp"

namespace deixis::results {

namespace {

namespace fs = std::filesystem;

/// A writer is, or was when it died, at work on the database: its latest answers stand in the log.
bool hasLog(const fs::path& database) {
    fs::path log = database;
    log += "-wal";
    std::error_code missing;
    const auto size = fs::file_size(log, missing);
    return !missing && size > 0;
}

std::string immutableUri(const fs::path& database) {
    std::string uri = "file:";
    for (const char c : fs::absolute(database).string()) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '/' || c == '-' || c == '_' || c == '.')
            uri += c;
        else
            uri += fmt::format("%{:02X}", byte);
    }
    return uri + "?immutable=1";
}

std::vector<std::string> column(SQLite::Database& database, const char* sql) {
    std::vector<std::string> out;
    SQLite::Statement query(database, sql);
    while (query.executeStep()) out.push_back(query.getColumn(0).getString());
    return out;
}

void readStudy(SQLite::Database& database, ResponseTable& table) {
    SQLite::Statement study(database, "SELECT name, title, hash, alpha, rating_steps FROM study");
    study.executeStep();
    table.study_name = study.getColumn(0).getString();
    table.study_title = study.getColumn(1).getString();
    table.study_hash = study.getColumn(2).getString();
    table.alpha = study.getColumn(3).getDouble();
    table.rating_steps = study.getColumn(4).getInt();
    table.systems = column(database, "SELECT name FROM systems ORDER BY position");
    table.layouts = column(database,
                           "SELECT name FROM layouts WHERE name IN (SELECT layout FROM trials "
                           "WHERE stage = 'game' AND NOT practice) ORDER BY position");
    SQLite::Statement planned(
        database,
        "SELECT coalesce(sum(stage = 'naturalness'), 0), coalesce(sum(stage = 'game'), 0), "
        "count(DISTINCT participant), coalesce(max(json_array_length(balls)), 0) FROM trials WHERE NOT "
        "practice");
    planned.executeStep();
    table.planned_ratings = planned.getColumn(0).getInt();
    table.planned_choices = planned.getColumn(1).getInt();
    table.planned_participants = planned.getColumn(2).getInt();
    table.balls = planned.getColumn(3).getInt();
}

void readSessions(SQLite::Database& database, ResponseTable& table) {
    SQLite::Statement stations(database,
                               "SELECT station, station_details, synthetic, count(*) FROM sessions "
                               "GROUP BY 1, 2, 3 ORDER BY 1, 2, 3");
    while (stations.executeStep())
        table.stations.push_back({stations.getColumn(0).getString(), stations.getColumn(1).getString(),
                                  stations.getColumn(2).getInt() != 0, stations.getColumn(3).getInt()});
    table.program_versions = column(database, "SELECT DISTINCT program_version FROM sessions ORDER BY 1");
    table.avatar_hashes = column(database, "SELECT DISTINCT avatar_hash FROM sessions ORDER BY 1");
}

void readRows(SQLite::Database& database, ResponseTable& table) {
    SQLite::Statement rows(database,
                           "SELECT participant, stage, system, layout, target_id, rating, correct, "
                           "response_time_s, synthetic, pauses FROM responses_flat WHERE NOT practice "
                           "ORDER BY participant, trial_index");
    while (rows.executeStep()) {
        ResponseRow& row = table.rows.emplace_back();
        row.participant = rows.getColumn(0).getString();
        row.stage = rows.getColumn(1).getString();
        row.system = rows.getColumn(2).getString();
        row.layout = rows.getColumn(3).getString();
        row.target_id = rows.getColumn(4).getString();
        row.rating = rows.getColumn(5).getDouble();
        row.correct = rows.getColumn(6).getInt() != 0;
        row.response_time_s = rows.getColumn(7).getDouble();
        row.synthetic = rows.getColumn(8).getInt() != 0;
        row.pauses = rows.getColumn(9).getInt();
    }
}

Result<ResponseTable> load(const fs::path& path, SQLite::Database&& database) {
    const auto whose = identify(database, path);
    if (!whose) return tl::unexpected(whose.error());
    if (whose->version == 0 || database.execAndGet("SELECT count(*) FROM study").getInt() == 0)
        return fail(path.string(), "the database holds no study yet", "Run a session with it first");
    database.exec("BEGIN");  // one moment of the database, should somebody be writing
    ResponseTable table;
    table.database = path.filename().string();
    readStudy(database, table);
    readSessions(database, table);
    readRows(database, table);
    if (table.rows.empty())
        return fail(path.string(),
                    fmt::format("the database holds no answers yet ({} participants planned)",
                                table.planned_participants),
                    "Run a session with it first");
    return table;
}

}  // namespace

Result<ResponseTable> loadResponses(const fs::path& database) {
    std::error_code problem;
    if (!fs::is_regular_file(database, problem))
        return fail(database.string(), "no such file, expected a database made by deixis",
                    "Check the path; a run prints the path of its database");
    try {
        // Without a log the file is all there is. Read as immutable it needs no files beside it, and so no
        // permission to write. Should a writer begin in just that moment, it is read again.
        if (!hasLog(database)) {
            const auto before = fs::last_write_time(database, problem);
            auto table = load(
                database, SQLite::Database(immutableUri(database), SQLite::OPEN_READONLY | SQLite::OPEN_URI));
            if (!hasLog(database) && fs::last_write_time(database, problem) == before) return table;
        }
        return load(database, SQLite::Database(database.string(), SQLite::OPEN_READONLY, 1000));
    } catch (const SQLite::Exception& caught) {
        return tl::unexpected(describe(database, caught));
    }
}

}  // namespace deixis::results
