#include <fmt/core.h>

#include <map>

#include "push_participants.hpp"
#include "results/database/database_open.hpp"
#include "results/database/locked_history.hpp"
#include "results/database/tables.hpp"
#include "results/database/text_check.hpp"
#include "results/database/withdrawals.hpp"
#include "results/server/server.hpp"
#include "server_schema.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

/// Pushes wait for each other, whatever their study: "DXIS" in ASCII.
constexpr const char* one_push_at_a_time = "SELECT pg_advisory_xact_lock(1146636627)";

struct Person {
    int number = 0;
    std::optional<std::string> token;
};

/// One push of one file, within one transaction.
class StudyPush {
  public:
    StudyPush(SQLite::Database& file, const std::filesystem::path& path, ServerTransaction& server,
              const ServerAddress& address)
        : file_(file), path_(path), server_(server), address_(address) {}

    Result<PushOutcome> run() {
        server_.run(one_push_at_a_time);
        Statement study(file_, "SELECT name, hash FROM study");
        if (!study.executeStep())
            return fail(path_.string(), "the database has no study yet", "Run a session with it first");
        outcome_.study = study.getColumn(0).getString();
        study_hash_ = study.getColumn(1).getString();
        outcome_.schema = schemaOf(outcome_.study, study_hash_);
        const auto entered = enterSchema(server_, address_, {outcome_.schema, outcome_.study, study_hash_});
        if (!entered) return tl::unexpected(entered.error());
        outcome_.upgraded_from = entered->upgraded_from;
        ParticipantPush people(file_, path_, server_, address_, outcome_);
        if (entered->made)
            for (const char* table : study_tables) people.pushWhole(table);
        if (auto locked = pushLocked(); !locked) return tl::unexpected(locked.error());
        pushWithdrawals();
        eraseWithdrawn();
        if (auto clash = checkNumbers(); !clash) return tl::unexpected(clash.error());
        for (const auto& [id, person] : inFile()) {
            if (withdrawals_.include(person.token))
                outcome_.withdrawn.push_back(id);
            else if (auto done = people.push(id); !done)
                return tl::unexpected(done.error());
        }
        return outcome_;
    }

  private:
    std::map<std::string, Person> inFile() {
        std::map<std::string, Person> out;
        Statement rows(file_, "SELECT id, number, token FROM participants");
        while (rows.executeStep()) {
            Person& person = out[rows.getColumn(0).getString()];
            person.number = rows.getColumn(1).getInt();
            if (!rows.getColumn(2).isNull()) person.token = rows.getColumn(2).getString();
        }
        return out;
    }

    std::map<std::string, Person> onServer() {
        std::map<std::string, Person> out;
        const pqxx::result rows = server_.run("SELECT id, number, token FROM participants");
        for (int i = 0; i < static_cast<int>(rows.size()); ++i)
            out[*textOf(rows, i, 0)] = {numberIn<int>(*textOf(rows, i, 1)), textOf(rows, i, 2)};
        return out;
    }

    /// The set in force is that of the file or of the server which has had the other's.
    Result<void> pushLocked() {
        const LockedHistory here = readLockedHistory(file_);
        LockedHistory there;
        there.in_force = server_.value("SELECT coalesce(max(locked_hash), '') FROM study").value_or("");
        there.had.insert(there.in_force);
        const pqxx::result changes = server_.run("SELECT what FROM locked_changes");
        for (int i = 0; i < static_cast<int>(changes.size()); ++i)
            if (auto before = lockedBefore(textOf(changes, i, 0).value_or("")))
                there.had.insert(std::move(*before));
        if (!here.includes(there)) {
            if (there.includes(here)) return {};
            return fail(path_.string(),
                        fmt::format("its study was locked with other files ({:.16}) than that on {} ({:.16})",
                                    here.in_force, address_.shown, there.in_force),
                        "Use one of these files at all stations with 'deixis run --accept-changes'");
        }
        if (here.in_force != there.in_force) {
            server_.run("UPDATE study SET locked_hash = " + server_.quoted(here.in_force));
            ++outcome_.changed;
        }
        Statement rows(file_, "SELECT utc_s, what, reason FROM locked_changes ORDER BY id");
        while (rows.executeStep()) {
            const std::string what = server_.quoted(rows.getColumn(1).getString());
            const std::string reason =
                rows.getColumn(2).isNull() ? "NULL" : server_.quoted(rows.getColumn(2).getString());
            const double utc_s = rows.getColumn(0).getDouble();
            if (server_
                    .value(
                        fmt::format("SELECT count(*) FROM locked_changes WHERE what = {} AND utc_s = {} AND "
                                    "reason IS NOT DISTINCT FROM {}",
                                    what, utc_s, reason))
                    .value_or("0") != "0")
                continue;
            server_.run(
                fmt::format("INSERT INTO locked_changes (id, utc_s, what, reason) SELECT coalesce(max(id), "
                            "0) + 1, {}, {}, "
                            "{} FROM locked_changes",
                            utc_s, what, reason));
            ++outcome_.rows;
        }
        return {};
    }

    /// Those of all files together.
    void pushWithdrawals() {
        const pqxx::result there = server_.run("SELECT utc_s, token FROM withdrawals");
        for (int i = 0; i < static_cast<int>(there.size()); ++i)
            withdrawals_.add({numberIn<double>(*textOf(there, i, 0)), textOf(there, i, 1)});
        for (const Withdrawal& one : withdrawals_.addFrom(file_)) {
            server_.run(
                fmt::format("INSERT INTO withdrawals (id, utc_s, token) SELECT coalesce(max(id), 0) + 1, "
                            "{}, {} FROM withdrawals",
                            one.utc_s, one.token ? server_.quoted(*one.token) : "NULL"));
            ++outcome_.rows;
        }
    }

    void eraseWithdrawn() {
        for (const auto& [id, person] : onServer()) {
            if (!withdrawals_.include(person.token)) continue;
            // What refers to something goes before it.
            for (auto table = participant_tables.rbegin(); table != participant_tables.rend(); ++table)
                server_.run(
                    fmt::format("DELETE FROM {} WHERE {}", table->name, rowsOf(*table, server_.quoted(id))));
            outcome_.erased.push_back(id);
        }
    }

    Result<void> checkNumbers() {
        const auto there = onServer();
        std::map<int, std::string> taken;
        for (const auto& [id, person] : there) taken[person.number] = id;
        for (const auto& [id, person] : inFile()) {
            const auto other = taken.find(person.number);
            if (there.contains(id) || withdrawals_.include(person.token) || other == taken.end()) continue;
            return fail(path_.string(),
                        fmt::format("participant {} has the number {}, which {} has on {}", id, person.number,
                                    other->second, address_.shown),
                        "Give each station its own ids and numbers, such as A001 and B101");
        }
        return {};
    }

    SQLite::Database& file_;
    const std::filesystem::path& path_;
    ServerTransaction& server_;
    const ServerAddress& address_;
    std::string study_hash_;
    Withdrawals withdrawals_;
    PushOutcome outcome_;
};

}  // namespace

Result<PushOutcome> pushDatabase(const std::filesystem::path& database, const std::string& address) {
    const auto place = parseServerAddress(address);
    if (!place) return tl::unexpected(place.error());
    return atServer(*place, [&]() -> Result<PushOutcome> {
        std::optional<ServerTransaction> server;
        // The file may be read a second time, where a session wrote to it meanwhile: then all begins again,
        // and only what was read whole is committed.
        auto outcome = readDatabase(database, [&](SQLite::Database& file) -> Result<PushOutcome> {
            server.reset();
            if (auto texts = checkTexts(file, database); !texts) return tl::unexpected(texts.error());
            auto begun = ServerTransaction::begin(*place, ServerTransaction::Purpose::write);
            if (!begun) return tl::unexpected(begun.error());
            server.emplace(std::move(*begun));
            return StudyPush(file, database, *server, *place).run();
        });
        if (outcome) server->commit();
        return outcome;
    });
}

}  // namespace deixis::results
