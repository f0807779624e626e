#include "database_check.hpp"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "results/database/answer_hash.hpp"
#include "results/database/check_progress.hpp"
#include "results/database/schema.hpp"

namespace deixis::results {

namespace {

CheckObserver& theWatch() {
    static CheckObserver watch;
    return watch;
}

/// On one line.
std::string flat(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

tl::unexpected<Error> damaged(const std::filesystem::path& path, const std::string& what) {
    return fail(path.string(), fmt::format("the database is damaged: {}", what),
                "Nothing was read from it or written to it. Continue with a copy from before the damage; the "
                "sqlite3 shell's .recover writes what can be saved to a new file");
}

Result<void> checkStructure(SQLite::Database& database, const std::filesystem::path& path) {
    const std::string found = database.execAndGet("PRAGMA integrity_check(1)").getString();
    if (found != "ok") return damaged(path, flat(found));
    return {};
}

Result<void> checkReferences(SQLite::Database& database, const std::filesystem::path& path) {
    SQLite::Statement row(database, "SELECT \"table\", rowid, parent FROM pragma_foreign_key_check LIMIT 1");
    if (!row.executeStep()) return {};
    const auto number = row.getColumn(1);
    return damaged(
        path, fmt::format("table {}, {} refers to a row of {} that is missing", row.getColumn(0).getString(),
                          number.isNull() ? "a row" : fmt::format("row {}", number.getInt64()),
                          row.getColumn(2).getString()));
}

Result<void> checkAnswers(SQLite::Database& database, const std::filesystem::path& path) {
    AnswerHasher answers(database, AnswerHasher::Scope::all);
    while (const auto answer = answers.next()) {
        if (!answer->stored || *answer->stored == answer->computed) continue;
        return fail(
            path.string(),
            fmt::format("table responses, row {} (participant {}, trial {}): this answer is not as it "
                        "was written: the file is damaged, or another program has changed it",
                        answer->id, answer->participant, answer->trial_index),
            fmt::format("Nothing was read from it or written to it. Continue with an earlier copy; if the "
                        "change is intended: UPDATE responses SET hash = NULL WHERE id = {}",
                        answer->id));
    }
    return {};
}

Result<void> checkAtOneMoment(SQLite::Database& database, const std::filesystem::path& path, int version) {
    if (auto structure = checkStructure(database, path); !structure) return structure;
    if (version != schema_version) return {};  // references are looked at after bringing it up to date
    if (auto references = checkReferences(database, path); !references) return references;
    return checkAnswers(database, path);
}

}  // namespace

void observeChecks(CheckObserver watch) {
    theWatch() = std::move(watch);
}

Result<void> checkWhole(SQLite::Database& database, const std::filesystem::path& path, int version) {
    const std::shared_ptr<void> watched = theWatch() ? theWatch()(path) : nullptr;
    // All of it at one moment, whoever writes meanwhile.
    database.exec("BEGIN");
    try {
        auto sound = checkAtOneMoment(database, path, version);
        database.exec("COMMIT");
        return sound;
    } catch (...) {
        database.tryExec("ROLLBACK");
        throw;
    }
}

}  // namespace deixis::results
