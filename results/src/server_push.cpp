#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "database_open.hpp"
#include "push_people.hpp"
#include "results/server.hpp"
#include "server_schema.hpp"
#include "tables.hpp"
#include "text_check.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

/// Pushes wait for each other, whatever their study: "DXIS" in ASCII.
constexpr const char* one_push_at_a_time = "SELECT pg_advisory_xact_lock(1146636627)";

struct Withdrawal {
    double utc_s = 0.0;
    std::optional<std::string> token;  ///< none: withdrawn before version 5
    auto operator<=>(const Withdrawal&) const = default;
};

struct Person {
    int number = 0;
    std::optional<std::string> token;
};

std::optional<std::string> textOrNone(const SQLite::Column& value) {
    return value.isNull() ? std::nullopt : std::optional(value.getString());
}

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
            return fail(path_.string(), "the database holds no study yet", "Run a session with it first");
        outcome_.study = study.getColumn(0).getString();
        study_hash_ = study.getColumn(1).getString();
        outcome_.schema = schemaOf(outcome_.study, study_hash_);
        const auto entered = enterSchema(server_, address_, {outcome_.schema, outcome_.study, study_hash_});
        if (!entered) return tl::unexpected(entered.error());
        outcome_.upgraded_from = entered->upgraded_from;
        PeoplePush people(file_, path_, server_, address_, outcome_);
        if (entered->made)
            for (const char* table : study_tables) people.pushWhole(table);
        pushWithdrawals();
        eraseWithdrawn();
        if (auto clash = checkNumbers(); !clash) return tl::unexpected(clash.error());
        for (const auto& [id, person] : inFile()) {
            if (isWithdrawn(person))
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
        while (rows.executeStep())
            out[rows.getColumn(0).getString()] = {rows.getColumn(1).getInt(), textOrNone(rows.getColumn(2))};
        return out;
    }

    std::map<std::string, Person> onServer() {
        std::map<std::string, Person> out;
        const pqxx::result rows = server_.run("SELECT id, number, token FROM participants");
        for (int i = 0; i < static_cast<int>(rows.size()); ++i)
            out[*textOf(rows, i, 0)] = {std::stoi(*textOf(rows, i, 1)), textOf(rows, i, 2)};
        return out;
    }

    /// Who begins anew after a withdrawal has another token.
    bool isWithdrawn(const Person& person) const {
        return std::any_of(withdrawals_.begin(), withdrawals_.end(),
                           [&](const Withdrawal& one) { return one.token && one.token == person.token; });
    }

    /// Those of all files together.
    void pushWithdrawals() {
        const pqxx::result there = server_.run("SELECT utc_s, token FROM withdrawals");
        for (int i = 0; i < static_cast<int>(there.size()); ++i)
            withdrawals_.insert({std::stod(*textOf(there, i, 0)), textOf(there, i, 1)});
        Statement rows(file_, "SELECT utc_s, token FROM withdrawals ORDER BY id");
        while (rows.executeStep()) {
            const Withdrawal one{rows.getColumn(0).getDouble(), textOrNone(rows.getColumn(1))};
            if (!withdrawals_.insert(one).second) continue;
            server_.run(fmt::format(
                "INSERT INTO withdrawals SELECT coalesce(max(id), 0) + 1, {}, {} FROM withdrawals", one.utc_s,
                one.token ? server_.quoted(*one.token) : "NULL"));
            ++outcome_.rows;
        }
    }

    void eraseWithdrawn() {
        for (const auto& [id, person] : onServer()) {
            if (!isWithdrawn(person)) continue;
            // What refers to something goes before it.
            for (auto table = people_tables.rbegin(); table != people_tables.rend(); ++table)
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
            if (there.contains(id) || isWithdrawn(person) || other == taken.end()) continue;
            return fail(path_.string(),
                        fmt::format("participant {} has the number {}, which {} has on {}", id, person.number,
                                    other->second, address_.shown),
                        "Give each station ids with numbers of its own, such as A001 and B101");
        }
        return {};
    }

    SQLite::Database& file_;
    const std::filesystem::path& path_;
    ServerTransaction& server_;
    const ServerAddress& address_;
    std::string study_hash_;
    std::set<Withdrawal> withdrawals_;
    PushOutcome outcome_;
};

}  // namespace

Result<PushOutcome> pushDatabase(const std::filesystem::path& database, const std::string& address) {
    const auto place = parseServerAddress(address);
    if (!place) return tl::unexpected(place.error());
    return atServer(*place, [&]() -> Result<PushOutcome> {
        std::optional<ServerTransaction> server;
        // The file may be read a second time, where a session wrote to it meanwhile: then all begins anew,
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
