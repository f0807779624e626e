// Stations' files, what is in them, and what is on the server that they were pushed to.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <map>

#include "postgres_server.hpp"

namespace deixis::tests {

inline void change(const std::string& database, const std::string& sql) {
    SQLite::Database(database, SQLite::OPEN_READWRITE).exec(sql);
}

inline constexpr const char* tables_of_sessions[]{"events",         "tracking_blocks",    "hand_joints",
                                                  "trial_tracking", "session_properties", "consents"};
inline constexpr const char* tables_of_participants[]{
    "trial_stimuli",      "trial_values",       "trials",  "plans",
    "participant_fields", "participant_groups", "sessions"};

/// Leaves out people, as if they had never been there.
inline void leaveOut(const std::string& database, const std::string& ids) {
    const std::string who = " IN (" + ids + ")";
    std::string sql;
    for (const char* table : {"answers", "response_values", "response_stimuli"})
        sql += std::string("DELETE FROM ") + table +
               " WHERE response IN (SELECT id FROM responses WHERE participant" + who + ");";
    sql += "DELETE FROM responses WHERE participant" + who + ";";
    for (const char* table : tables_of_sessions)
        sql += std::string("DELETE FROM ") + table +
               " WHERE session IN (SELECT id FROM sessions WHERE participant" + who + ");";
    for (const char* table : tables_of_participants)
        sql += std::string("DELETE FROM ") + table + " WHERE participant" + who + ";";
    change(database, sql + "DELETE FROM participants WHERE id" + who);
}

/// Two stations' files of one study, three simulated participants each, the second with tracked frames of 8
/// MB.
struct Stations {
    Scratch folder{WithSharedStimuli{}};
    std::string a = folder / "a.sqlite";
    std::string b = folder / "b.sqlite";
    std::string both = folder / "both.sqlite";

    Stations() {
        const auto made = program("simulate pointing2023-stand-ins --participants 6 --db " + a);
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const std::string rest = folder / "rest.sqlite";
        fs::copy_file(a, rest);
        fs::copy_file(a, folder / "same.sqlite");
        leaveOut(a, "'S004', 'S005', 'S006'");
        leaveOut(rest, "'S001', 'S002', 'S003'");
        change(
            rest,
            "INSERT INTO tracking_blocks SELECT NULL, id, 1, 1, 3, 0.25, 1.5, x'00ff275c0a' FROM sessions;"
            "INSERT INTO trial_tracking SELECT id, 1, 3, 0, 0, 0.1, 0, 0.25, 1.5 FROM sessions;"
            "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 3000) "
            "INSERT INTO hand_joints SELECT id, i, 'left', randomblob(832), randomblob(26) FROM sessions, n");
        // Joined with itself it counts its sessions and responses from 1, as a station's file does.
        fs::copy_file(rest, folder / "copy.sqlite");
        for (const auto& [from, to] :
             {std::pair{rest + " " + (folder / "copy.sqlite"), b}, {a + " " + b, both}}) {
            const auto joined = program("merge " + from + " -o " + to);
            REQUIRE_MESSAGE(joined.status == 0, joined.err);
        }
    }
};

inline const Stations& stations() {
    static const Stations made;
    return made;
}

inline Finished push(const std::string& database, const std::string& url) {
    return program("push " + database + " '" + url + "'");
}

inline void pushed(const std::string& database, const std::string& url) {
    const auto done = push(database, url);
    REQUIRE_MESSAGE(done.status == 0, done.err);
}

inline std::string schemaIn(const PostgresServer& server, const std::string& database) {
    std::string name = server.sql(database, "SELECT nspname FROM pg_namespace WHERE nspname LIKE 'deixis%'");
    return name.substr(0, name.find('\n'));
}

inline constexpr const char* answers_sql =
    "SELECT participant, trial_index, system, item, chosen_place, correct, text, answered_utc, value, "
    "response_time_s, head_qw FROM responses_flat ORDER BY 1, 2, 3, 4, 9";

inline std::string onServer(const PostgresServer& server, const std::string& database,
                            const std::string& sql) {
    return server.sql(database, "SET search_path = " + schemaIn(server, database) + "; " + sql);
}

inline std::string inFile(const std::string& database, const std::string& sql) {
    SQLite::Database open(database, SQLite::OPEN_READONLY);
    SQLite::Statement rows(open, sql);
    std::string out;
    while (rows.executeStep())
        for (int i = 0; i < rows.getColumnCount(); ++i) {
            const auto value = rows.getColumn(i);
            out += value.isNull()    ? "\\N"
                   : value.isFloat() ? fmt::format("{}", value.getDouble())
                                     : value.getString();
            out += i + 1 < rows.getColumnCount() ? "|" : "\n";
        }
    return out;
}

/// What there is of every table of the file, but for those that describe the study.
inline std::map<std::string, std::string> counts(const std::string& database) {
    std::map<std::string, std::string> out;
    for (const char* table : {"participants", "plans", "trials", "trial_stimuli", "sessions", "responses",
                              "answers", "response_stimuli", "events", "hand_joints", "tracking_blocks",
                              "trial_tracking", "stages", "systems", "layouts", "questions"})
        out[table] = inFile(database, std::string("SELECT count(*) FROM ") + table);
    return out;
}

inline void checkCounts(const PostgresServer& server, const std::string& database, const std::string& file) {
    for (const auto& counted : counts(file)) {
        INFO(counted.first);
        CHECK(onServer(server, database, "SELECT count(*) FROM " + counted.first) == counted.second);
    }
}
}  // namespace deixis::tests
