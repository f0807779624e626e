#include "results/copies/anonymous_copy.hpp"

#include <regex>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "anonymous_columns.hpp"
#include "anonymous_names.hpp"
#include "core/hash.hpp"
#include "results/database/answer_hash.hpp"
#include "results/database/copied_value.hpp"
#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"
#include "results/database/locked_history.hpp"
#include "results/database/tables.hpp"
#include "results/database/tracking_blocks.hpp"
#include "studies/design/plan.hpp"
#include "studies/session/events.hpp"

namespace deixis::results {

namespace {

namespace fs = std::filesystem;
using SQLite::Statement;

using CopiedRow = std::map<std::string, CopiedValue>;

const ColumnHandling& handlingOf(const std::string& table) {
    const auto found = std::find_if(column_handling.begin(), column_handling.end(),
                                    [&](const ColumnHandling& one) { return table == one.table; });
    if (found == column_handling.end())
        throw std::logic_error(
            fmt::format("copyAnonymously: what becomes of table {} is not decided", table));
    return *found;
}

/// NULL, or nothing where there must be something.
CopiedValue nothingIn(const std::string& type, bool must) {
    if (!must) return {};
    if (type == "TEXT") return CopiedValue(std::string());
    return type == "REAL" ? CopiedValue(0.0) : CopiedValue(std::int64_t{0});
}

bool wordedByProgram(const std::string& reason) {
    return reason.starts_with(studies::check_failed_reason) ||
           reason.starts_with(studies::practice_failed_reason) || reason == declined_reason ||
           reason == asked_anew_reason || reason == operator_ended_reason;
}

class AnonymousCopier {
  public:
    AnonymousCopier(SQLite::Database& from, SQLite::Database& to, const AnonymousOptions& options)
        : from_(from), to_(to), options_(options), naming_(from, true) {
        Statement free(from_,
                       "SELECT DISTINCT stage, question FROM questions WHERE kind IN ('choice', 'choices')");
        while (free.executeStep())
            chosen_.emplace(free.getColumn(0).getString(), free.getColumn(1).getString());
    }

    Result<AnonymousCounts> copy() {
        for (const char* table : study_tables) copyTable(table, "?1 = ?1", "");
        withdrawals();
        lockedChanges();
        for (const std::string& id : naming_.participants()) participant(id);
        if (problem_) return tl::unexpected(*problem_);
        hashAnswers();
        return counts_;
    }

  private:
    void participant(const std::string& id) {
        ++counts_.participants;
        Statement asked(from_, fmt::format("SELECT {}", declinedConsent(quotedSql(id))));
        asked.executeStep();
        const bool declined = asked.getColumn(0).getInt() != 0;
        counts_.declined += declined ? 1 : 0;
        for (const ParticipantTable& table : participant_tables) {
            if (declined && !isListed(tables_of_decline, table.name)) continue;
            const std::string_view name = table.name;
            if (!options_.tracking &&
                (name == "tracking_blocks" || name == "hand_joints" || name == "trial_tracking"))
                continue;
            copyTable(table.name, table.participant_rows, id);
        }
    }

    void copyTable(const std::string& table, const std::string& which, const std::string& id) {
        const ColumnHandling& handling = handlingOf(table);
        Statement rows(from_, fmt::format("SELECT * FROM {} WHERE {} ORDER BY 1, 2", table, which));
        rows.bind(1, id);
        if (!rows.executeStep()) return;
        std::vector<std::string> names;
        std::string places;
        for (int i = 0; i < rows.getColumnCount(); ++i) {
            names.emplace_back(rows.getColumnName(i));
            places += i > 0 ? ", ?" : "?";
        }
        Statement insert(
            to_, fmt::format("INSERT INTO {} ({}) VALUES ({})", table, fmt::join(names, ", "), places));
        do {
            CopiedRow row;
            for (std::size_t i = 0; i < names.size(); ++i)
                row[names[i]] = CopiedValue(rows.getColumn(static_cast<int>(i)));
            if (!change(handling, id, row)) continue;
            for (std::size_t i = 0; i < names.size(); ++i)
                row.at(names[i]).bind(insert, static_cast<int>(i) + 1);
            insert.exec();
            insert.reset();
            if (table == "responses") responses_[old_id_] = to_.getLastInsertRowid();
        } while (rows.executeStep());
    }

    /// False: the row is left out.
    bool change(const ColumnHandling& handling, const std::string& id, CopiedRow& row) {
        const std::string table = handling.table;
        std::int64_t session = 0;
        if (const auto of = row.find(table == "sessions" ? "id" : "session"); of != row.end())
            session = of->second.whole;
        if (const auto own = row.find("id"); own != row.end() && own->second.kind == CopiedValue::Kind::whole)
            old_id_ = own->second.whole;
        const auto& columns = columnsOf(table);
        if (table == "session_properties" && !isListed(properties_kept, row.at("name").text)) return false;
        if (table == "answers" && !row.at("text").isNull()) answerText(row);
        for (auto& [name, value] : row) {
            if (isListed(handling.kept, name)) continue;
            if (isListed(handling.left_out, name))
                value = columns.at(name);
            else if (isListed(handling.clock, name) || isListed(handling.utc, name))
                count(value, isListed(handling.utc, name) ? startUtc(session) : startClock(session));
            else if (isListed(handling.made, name))
                make(table, name, id, row, value);
            else
                throw std::logic_error(
                    fmt::format("copyAnonymously: what becomes of {}.{} is not decided", table, name));
        }
        if (table == "tracking_blocks") repack(row, startClock(session));
        return true;
    }

    /// Columns with rules of their own.
    void make(const std::string& table, const std::string& name, const std::string& id, const CopiedRow& row,
              CopiedValue& value) {
        if (name == "participant" || (table == "participants" && name == "id")) {
            value = CopiedValue(naming_.nameOf(id));
        } else if (name == "number") {
            value = CopiedValue(static_cast<std::int64_t>(counts_.participants));
        } else if (name == "session" || (table == "sessions" && name == "id")) {
            value = CopiedValue(static_cast<std::int64_t>(naming_.nameOfSession(value.whole)));
        } else if (name == "id") {
            value = CopiedValue();  // the next free one
        } else if (name == "response") {
            value = CopiedValue(responses_.at(value.whole));
        } else if (name == "locked_hash") {
            if (!value.isNull()) value = CopiedValue(lockedAs(value.text));
        } else if (name == "source") {
            value.text = withoutWholePaths(value.text);
        } else if (name == "manifest") {
            if (!value.isNull()) value.text = fmt::format("clips/{}/manifest.csv", row.at("name").text);
        } else if (table == "plans") {
            plan(id, row, name, value);
        } else if (table == "session_properties") {
            // The kernel's name behind it may be a machine's.
            if (row.at("name").text == "operating_system")
                value.text = value.text.substr(0, value.text.find(','));
        } else if (name == "reason") {
            experimentersReason(table, value);
        } else if (name == "superseded") {
            counts_.reasons += value.text.empty() ? 0 : 1;
            if (!value.isNull()) value = CopiedValue(std::string());
        } else if (name == "hash") {
            if (!value.isNull()) value = CopiedValue(std::string("anew"));  // hashAnswers()
        } else if (name == "clip_file") {
            if (!options_.locked_files.contains(value.text))
                value.text = fs::path(value.text).filename().string();
        } else if (name == "author") {
            const auto known = options_.authors.find(value.text);
            if (!value.isNull())
                value = known == options_.authors.end() ? CopiedValue() : CopiedValue(known->second);
        } else if (name == "detail") {
            if (isListed(events_kept_whole, row.at("kind").text)) return;
            counts_.reasons += row.at("kind").text.starts_with("operator_") && !value.text.empty() ? 1 : 0;
            value = CopiedValue(std::string());
        } else if (table == "participant_fields") {
            if (!options_.free_text && !fieldIsChosen(row.at("field").text)) value = CopiedValue();
        }
        // "text" of answers and "data" of frames: see change().
    }

    void plan(const std::string& id, const CopiedRow& row, const std::string& name, CopiedValue& value) {
        // By name the hash comes before the JSON that it is of.
        auto stored = studies::planFromJson(row.at("json").text);
        if (!stored) {
            problem_ = stored.error();
            return;
        }
        stored->participant = naming_.nameOf(id);
        stored->number = counts_.participants;
        stored->number_in_cell.reset();
        const std::string json = studies::planJson(*stored);
        value = CopiedValue(name == "hash" ? sha256Hex(json) : json);
    }

    void answerText(CopiedRow& row) {
        if (row.at("question").text == "consent") return;
        Statement stage(from_,
                        "SELECT t.stage FROM responses AS r JOIN trials AS t USING (participant, "
                        "trial_index) WHERE r.id = ?");
        stage.bind(1, static_cast<std::int64_t>(row.at("response").whole));
        if (stage.executeStep() &&
            chosen_.contains({stage.getColumn(0).getString(), row.at("question").text}))
            return;
        if (options_.free_text) return;
        ++counts_.free_texts;
        row.at("text") = CopiedValue();
    }

    [[nodiscard]] bool fieldIsChosen(const std::string& field) const {
        return std::any_of(chosen_.begin(), chosen_.end(),
                           [&](const auto& one) { return one.second == field; });
    }

    void experimentersReason(const std::string& table, CopiedValue& value) {
        if (value.isNull() || wordedByProgram(value.text)) return;
        ++counts_.reasons;
        value = table == "participants" ? CopiedValue(std::string("by the experimenter")) : CopiedValue();
    }

    void repack(CopiedRow& row, double start_s) {
        auto frames = unpackTracking(row.at("data").text);
        if (!frames) {
            problem_ = frames.error();
            return;
        }
        for (studies::TrackingSample& frame : *frames)
            for (double* time : {&frame.display_time_s, &frame.begun_s, &frame.submitted_s}) *time -= start_s;
        row.at("data").text = packTracking(*frames);
        counts_.frames += static_cast<int>(frames->size());
    }

    static void count(CopiedValue& value, double from_s) {
        if (value.kind == CopiedValue::Kind::number) value.number -= from_s;
        if (value.kind == CopiedValue::Kind::whole)
            value = CopiedValue(static_cast<double>(value.whole) - from_s);
    }

    // Whole seconds, so that no difference of times changes in its last bits.
    [[nodiscard]] double startClock(std::int64_t session) const {
        return std::floor(naming_.startOfSession(session));
    }
    double startUtc(std::int64_t session) {
        const auto known = started_.find(session);
        if (known != started_.end()) return known->second;
        Statement row(from_, "SELECT started_utc_s FROM sessions WHERE id = ?");
        row.bind(1, session);
        return started_[session] = row.executeStep() ? std::floor(row.getColumn(0).getDouble()) : 0.0;
    }

    std::string lockedAs(const std::string& hash) {
        const auto found = options_.locked.find(hash);
        if (found != options_.locked.end()) return found->second;
        problem_ = Error{"", fmt::format("the locked study {:.16} was not copied", hash), ""};
        return {};
    }

    void withdrawals() {
        const int n = from_.execAndGet("SELECT count(*) FROM withdrawals").getInt();
        for (int i = 0; i < n; ++i) to_.exec("INSERT INTO withdrawals (utc_s) VALUES (0.0)");
    }

    void lockedChanges() {
        Statement rows(from_, "SELECT what FROM locked_changes ORDER BY utc_s, id");
        Statement insert(to_, "INSERT INTO locked_changes (utc_s, what, reason) VALUES (0.0, ?, ?)");
        while (rows.executeStep()) {
            nlohmann::ordered_json what{{"changes", {"its files (not named here)"}}};
            if (const auto before = lockedBefore(rows.getColumn(0).getString()))
                if (const auto known = options_.locked.find(*before); known != options_.locked.end())
                    what["from"] = known->second;
            insert.bind(1, what.dump());
            insert.bind(2, "the reason is left out here");
            insert.exec();
            insert.reset();
            ++counts_.reasons;
        }
    }

    void hashAnswers() {
        std::vector<HashedAnswer> all;
        AnswerHasher hasher(to_, AnswerHasher::Scope::all);
        while (auto one = hasher.next()) all.push_back(std::move(*one));
        Statement update(to_, "UPDATE responses SET hash = ? WHERE id = ? AND hash IS NOT NULL");
        for (const HashedAnswer& one : all) {
            update.bind(1, one.computed);
            update.bind(2, one.id);
            update.exec();
            update.reset();
        }
    }

    /// Of each column, what stands where it is left out.
    const std::map<std::string, CopiedValue>& columnsOf(const std::string& table) {
        auto& columns = nothing_[table];
        if (!columns.empty()) return columns;
        Statement info(from_, fmt::format("SELECT name, type, \"notnull\" FROM pragma_table_info({})",
                                          quotedSql(table)));
        while (info.executeStep())
            columns[info.getColumn(0).getString()] =
                nothingIn(info.getColumn(1).getString(), info.getColumn(2).getInt() != 0);
        return columns;
    }

    SQLite::Database& from_;
    SQLite::Database& to_;
    const AnonymousOptions& options_;
    AnonymousNames naming_;
    AnonymousCounts counts_;
    std::optional<Error> problem_;
    std::int64_t old_id_ = 0;
    std::map<std::int64_t, std::int64_t> responses_;
    std::map<std::int64_t, double> started_;
    std::map<std::string, std::map<std::string, CopiedValue>> nothing_;
    std::set<std::pair<std::string, std::string>> chosen_;  ///< stage, question: answered by options alone
};

}  // namespace

Result<AnonymousCounts> copyAnonymously(const fs::path& database, const fs::path& copy,
                                        const AnonymousOptions& options) {
    return readDatabase(database, [&](SQLite::Database& from) -> Result<AnonymousCounts> {
        // It may be read a second time, where a session wrote to it meanwhile.
        std::error_code code;
        for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(copy.string() + suffix, code);
        auto to = openToWrite(copy, Missing::create);
        if (!to) return tl::unexpected(to.error());
        to->exec("BEGIN");
        auto counts = AnonymousCopier(from, *to, options).copy();
        if (!counts) return counts;
        to->exec("COMMIT");
        to->exec("PRAGMA journal_mode = DELETE");
        to->exec("VACUUM");
        return counts;
    });
}

Result<std::map<std::string, std::string>> anonymousAuthors(const fs::path& database,
                                                            const std::set<std::string>& authors) {
    return readDatabase(
        database, [&](SQLite::Database& opened) -> Result<std::map<std::string, std::string>> {
            return AnonymousNames(opened, true).namesFor({authors.begin(), authors.end()}, "author");
        });
}

std::string withoutWholePaths(std::string_view text) {
    static const std::regex path(R"((["'])(?:/|~/|[A-Za-z]:[/\\])[^"'\n]*[/\\]([^"'\n/\\]*)(["']))");
    return std::regex_replace(std::string(text), path, "$1$2$3");
}

}  // namespace deixis::results
