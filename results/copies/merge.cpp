// Several stations' databases of one study as one.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/hash.hpp"
#include "core/staging.hpp"
#include "results/copies/merge.hpp"
#include "results/database/database_files.hpp"
#include "results/database/database_open.hpp"
#include "results/database/locked_history.hpp"
#include "results/database/tables.hpp"
#include "results/database/withdrawals.hpp"

namespace deixis::results {

namespace {

namespace fs = std::filesystem;
using SQLite::Statement;

void bindSame(Statement& to, int place, const SQLite::Column& value) {
    if (value.isNull())
        to.bind(place);
    else if (value.isInteger())
        to.bind(place, value.getInt64());
    else if (value.isFloat())
        to.bind(place, value.getDouble());
    else if (value.isBlob())
        to.bind(place, value.getBlob(), value.getBytes());
    else
        to.bind(place, value.getString());
}

/// Of participants: 'active', or another and why. It may be changed in one copy of a database only.
struct Standing {
    std::string status;
    std::string reason;
};

/// A change of locked files that was accepted, as the table has it.
struct LockedChange {
    double utc_s = 0.0;
    std::string what;
    std::optional<std::string> reason;
    friend auto operator<=>(const LockedChange&, const LockedChange&) = default;
};

/// NULL where there is none.
template <typename Value>
void bindIfAny(Statement& to, int place, const std::optional<Value>& value) {
    if (value)
        to.bind(place, *value);
    else
        to.bind(place);
}

struct Source {
    fs::path path;
    std::string study_hash;
    std::string study_name;
    LockedHistory locked;
    std::vector<std::string> participants;
    std::map<std::string, int> numbers;
    std::map<std::string, std::optional<std::string>> tokens;
    std::vector<Withdrawal> withdrawals;
    std::map<std::string, Standing> standings;
    std::vector<LockedChange> changes;
    std::map<std::string, std::string> kept;  ///< by participant: a hash of all else that is kept of them
};

// All that is kept of a participant but the standing, whatever numbers a database counts by itself.
std::string contentHash(SQLite::Database& database, const std::string& participant) {
    std::string content;
    const auto add = [&](const ParticipantTable& table) {
        Statement rows(database, fmt::format("SELECT * FROM {} WHERE {} ORDER BY 1, 2", table.name,
                                             table.participant_rows));
        rows.bind(1, participant);
        content += fmt::format("[{}]", table.name);
        while (rows.executeStep())
            for (int i = 0; i < rows.getColumnCount(); ++i) {
                const std::string name = rows.getColumnName(i);
                const auto is = [&](const char* counted) { return counted != nullptr && name == counted; };
                if (is(table.own_id) || is(table.session) || is(table.response)) continue;
                if (std::string_view(table.name) == "participants" && (name == "status" || name == "reason"))
                    continue;
                const SQLite::Column value = rows.getColumn(i);
                content += fmt::format("{}:{};", value.getBytes(),
                                       std::string(static_cast<const char*>(value.getBlob()),
                                                   static_cast<std::size_t>(value.getBytes())));
            }
    };
    for (const ParticipantTable& table : participant_tables) add(table);
    return sha256Hex(content);
}

Result<Source> readSource(const fs::path& path) {
    return readDatabase(path, [&](SQLite::Database& database) -> Result<Source> {
        Source source;
        source.path = path;
        Statement study(database, "SELECT name, hash FROM study");
        if (!study.executeStep()) return fail(path.string(), "the database has no study yet", "Leave it out");
        source.study_name = study.getColumn(0).getString();
        source.study_hash = study.getColumn(1).getString();
        source.withdrawals = Withdrawals().addFrom(database);
        source.locked = readLockedHistory(database);
        Statement changes(database, "SELECT utc_s, what, reason FROM locked_changes");
        while (changes.executeStep()) {
            LockedChange& one = source.changes.emplace_back();
            one.utc_s = changes.getColumn(0).getDouble();
            one.what = changes.getColumn(1).getString();
            if (!changes.getColumn(2).isNull()) one.reason = changes.getColumn(2).getString();
        }
        Statement people(
            database, "SELECT id, number, token, status, coalesce(reason, '') FROM participants ORDER BY id");
        while (people.executeStep()) {
            const std::string id = people.getColumn(0).getString();
            source.participants.push_back(id);
            source.numbers[id] = people.getColumn(1).getInt();
            if (!people.getColumn(2).isNull()) source.tokens[id] = people.getColumn(2).getString();
            source.standings[id] = {people.getColumn(3).getString(), people.getColumn(4).getString()};
            source.kept[id] = contentHash(database, id);
        }
        return source;
    });
}

// Leaves out whoever withdrew, in that database or another.
std::vector<std::string> leaveOutWithdrawn(std::vector<Source>& sources, const Withdrawals& withdrawals) {
    std::set<std::string> out;
    for (Source& source : sources)
        std::erase_if(source.participants, [&](const std::string& id) {
            const bool withdrawn = withdrawals.include(source.tokens[id]);
            if (withdrawn) out.insert(id);
            return withdrawn;
        });
    return {out.begin(), out.end()};
}

// The one whose locked set the joined database has: it has had all the others' sets.
std::vector<Source>::const_iterator newest(const std::vector<Source>& sources) {
    return std::find_if(sources.begin(), sources.end(), [&](const Source& one) {
        return std::all_of(sources.begin(), sources.end(),
                           [&](const Source& other) { return one.locked.includes(other.locked); });
    });
}

// Everything for which the databases cannot be joined.
std::vector<Error> findClashes(const std::vector<Source>& sources) {
    std::vector<Error> problems;
    struct Known {
        const Source* source;
        std::string participant;
    };
    if (newest(sources) == sources.end()) {
        std::string sets;
        for (const Source& source : sources)
            sets += fmt::format("{}{} has {:.16}", sets.empty() ? "" : ", ", source.path.string(),
                                source.locked.in_force);
        problems.push_back({"", "the databases' studies were locked with other files: " + sets,
                            "Compare the lists locked.sha256 in the folders NAME.locked beside them, and use "
                            "one of these files at all stations with 'deixis run --accept-changes'"});
    }
    std::map<std::string, const Source*> by_id;
    std::map<int, Known> by_number;
    for (const Source& source : sources) {
        const Source& first = sources.front();
        if (source.study_hash != first.study_hash)
            problems.push_back(
                {source.path.string(),
                 fmt::format("has the study '{}' ({}), but {} has '{}' ({})", source.study_name,
                             source.study_hash.substr(0, 12), first.path.string(), first.study_name,
                             first.study_hash.substr(0, 12)),
                 "Only databases of one unchanged study file can be joined"});
        for (const std::string& id : source.participants) {
            const auto [same, is_new] = by_id.emplace(id, &source);
            if (!is_new) {
                if (same->second->kept.at(id) != source.kept.at(id))
                    problems.push_back({source.path.string(),
                                        fmt::format("participant {} is also in {}, with other answers", id,
                                                    same->second->path.string()),
                                        "Two people must not share an id"});
                continue;
            }
            const int number = source.numbers.at(id);
            const auto [other, free] = by_number.emplace(number, Known{&source, id});
            if (!free)
                problems.push_back(
                    {source.path.string(),
                     fmt::format("participant {} has the number {}, which {} of {} also has", id, number,
                                 other->second.participant, other->second.source->path.string()),
                     "Give each station its own ids and numbers, such as A001 and B101"});
        }
    }
    return problems;
}

// Copies rows and gives counted numbers again.
class Copier {
  public:
    Copier(SQLite::Database& from, SQLite::Database& to) : from_(from), to_(to) {}

    void study() {
        for (const char* table : study_tables) copy({table, nullptr, nullptr, nullptr, "?1 = ?1", ""}, "");
    }
    void participant(const std::string& id) {
        for (const ParticipantTable& table : participant_tables) copy(table, id);
    }

  private:
    void copy(const ParticipantTable& table, const std::string& participant) {
        Statement rows(
            from_, fmt::format("SELECT * FROM {} WHERE {} ORDER BY 1", table.name, table.participant_rows));
        rows.bind(1, participant);
        std::string names, places;
        for (int i = 0; i < rows.getColumnCount(); ++i) {
            names += (i > 0 ? ", " : "") + std::string(rows.getColumnName(i));
            places += i > 0 ? ", ?" : "?";
        }
        Statement insert(to_, fmt::format("INSERT INTO {} ({}) VALUES ({})", table.name, names, places));
        while (rows.executeStep()) {
            long long old_id = 0;
            for (int i = 0; i < rows.getColumnCount(); ++i) {
                const std::string name = rows.getColumnName(i);
                const SQLite::Column value = rows.getColumn(i);
                if (table.own_id != nullptr && name == table.own_id) {
                    old_id = value.getInt64();
                    insert.bind(i + 1);  // the next free one
                } else if (table.session != nullptr && name == table.session) {
                    insert.bind(i + 1, static_cast<std::int64_t>(sessions_.at(value.getInt64())));
                } else if (table.response != nullptr && name == table.response) {
                    insert.bind(i + 1, static_cast<std::int64_t>(responses_.at(value.getInt64())));
                } else {
                    bindSame(insert, i + 1, value);
                }
            }
            insert.exec();
            insert.reset();
            if (std::string_view(table.name) == "sessions") sessions_[old_id] = to_.getLastInsertRowid();
            if (std::string_view(table.name) == "responses") responses_[old_id] = to_.getLastInsertRowid();
        }
    }

    SQLite::Database& from_;
    SQLite::Database& to_;
    std::map<long long, long long> sessions_;
    std::map<long long, long long> responses_;
};

void writeWithdrawals(SQLite::Database& database, const Withdrawals& withdrawals) {
    Statement insert(database, "INSERT INTO withdrawals (utc_s, token) VALUES (?, ?)");
    for (const Withdrawal& one : withdrawals.all()) {
        insert.bind(1, one.utc_s);
        bindIfAny(insert, 2, one.token);
        insert.exec();
        insert.reset();
    }
}

// Those of all databases, each once, in the order of time.
void writeLockedChanges(SQLite::Database& database, const std::vector<Source>& sources) {
    std::set<LockedChange> all;
    for (const Source& source : sources) all.insert(source.changes.begin(), source.changes.end());
    Statement insert(database, "INSERT INTO locked_changes (utc_s, what, reason) VALUES (?, ?, ?)");
    for (const LockedChange& one : all) {
        insert.bind(1, one.utc_s);
        insert.bind(2, one.what);
        bindIfAny(insert, 3, one.reason);
        insert.exec();
        insert.reset();
    }
}

// Who is excluded or has dropped out in one copy is so in the joined database, too. Returns of whom copies
// differ.
std::vector<std::string> settleStandings(SQLite::Database& database, const std::vector<Source>& sources) {
    std::map<std::string, std::set<std::string>> said;
    std::map<std::string, Standing> strictest;
    for (const Source& source : sources)
        for (const std::string& id : source.participants) {
            const Standing& here = source.standings.at(id);
            said[id].insert(here.status + "\n" + here.reason);
            const auto [known, is_new] = strictest.emplace(id, here);
            if (!is_new && known->second.status == "active") known->second = here;
        }
    std::vector<std::string> differ;
    Statement update(database, "UPDATE participants SET status = ?, reason = nullif(?, '') WHERE id = ?");
    for (const auto& [id, standing] : strictest) {
        if (said.at(id).size() < 2) continue;
        differ.push_back(id);
        update.bind(1, standing.status);
        update.bind(2, standing.reason);
        update.bind(3, id);
        update.exec();
        update.reset();
    }
    return differ;
}

Result<std::vector<std::string>> writeJoined(const std::vector<Source>& sources,
                                             const Withdrawals& withdrawals, const fs::path& partial) {
    auto joined = openToWrite(partial, Missing::create);
    if (!joined) return tl::unexpected(joined.error());
    joined->exec("BEGIN");
    writeWithdrawals(*joined, withdrawals);
    std::set<std::string> there;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        // It may be read a second time, where a session wrote to it meanwhile.
        const std::set<std::string> before = there;
        joined->exec("SAVEPOINT source");
        const auto copied = readDatabase(sources[i].path, [&](SQLite::Database& from) -> Result<int> {
            joined->exec("ROLLBACK TO source");
            there = before;
            Copier copier(from, *joined);
            if (i == 0) copier.study();
            for (const std::string& id : sources[i].participants)
                if (there.insert(id).second) copier.participant(id);
            return 0;
        });
        if (!copied) return tl::unexpected(copied.error());
    }
    writeLockedChanges(*joined, sources);
    std::vector<std::string> differ = settleStandings(*joined, sources);
    joined->exec("COMMIT");
    // One file, without a log beside it.
    joined->exec("PRAGMA journal_mode = DELETE");
    return differ;
}

}  // namespace

tl::expected<MergeOutcome, std::vector<Error>> mergeDatabases(const std::vector<fs::path>& databases,
                                                              const fs::path& output) {
    std::vector<Error> problems;
    std::error_code code;
    if (fs::exists(output, code))
        problems.push_back(
            {output.string(), "exists already and is not overwritten", "Name another file with -o"});
    else if (auto orphan = orphanBeside(output))
        problems.push_back(std::move(*orphan));
    std::vector<Source> sources;
    for (const fs::path& path : databases) {
        auto source = readSource(path);
        if (!source)
            problems.push_back(source.error());
        else
            sources.push_back(std::move(*source));
    }
    Withdrawals withdrawals;
    for (const Source& source : sources)
        for (const Withdrawal& one : source.withdrawals) withdrawals.add(one);
    MergeOutcome outcome{leaveOutWithdrawn(sources, withdrawals), {}};
    for (Error& clash : findClashes(sources)) problems.push_back(std::move(clash));
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    const auto first = newest(sources) - sources.begin();
    std::rotate(sources.begin(), sources.begin() + first, sources.begin() + first + 1);

    // Written beside and renamed at the end: no half database.
    PartialFile partial(output);
    auto differ = writeJoined(sources, withdrawals, partial.path());
    if (!differ) return tl::unexpected(std::vector<Error>{differ.error()});
    outcome.excluded_in_one = std::move(*differ);
    if (auto moved = partial.finish(); !moved) return tl::unexpected(std::vector<Error>{moved.error()});
    return outcome;
}

}  // namespace deixis::results
