// What the store's parts share.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "core/text.hpp"
#include "results/database/answer_hash.hpp"
#include "results/database/participant_status.hpp"
#include "results/store/store.hpp"
#include "tracking_writer.hpp"

namespace deixis::results {

/// A statement lent for one use: reset at its end, whatever comes, so that it holds no lock.
class Query {
  public:
    explicit Query(SQLite::Statement& statement) : statement_(statement) {
        statement_.tryReset();  // what it failed with before was thrown then
        statement_.clearBindings();
    }
    ~Query() { statement_.tryReset(); }
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;

    /// Binds the next parameter.
    template <typename T>
    Query& operator<<(const T& value) {
        if constexpr (std::is_same_v<T, bool>)
            statement_.bind(++bound_, value ? 1 : 0);
        else if constexpr (std::is_integral_v<T>)
            statement_.bind(++bound_, static_cast<std::int64_t>(value));
        else if constexpr (std::is_floating_point_v<T>)
            statement_.bind(++bound_, static_cast<double>(value));
        else
            bindText(std::string(value));
        return *this;
    }
    template <typename T>
    Query& operator<<(const std::optional<T>& value) {
        return value ? *this << *value : null();
    }
    Query& operator<<(const Vec3& point) { return *this << point.x << point.y << point.z; }
    Query& null(int columns = 1) {
        bound_ += columns;
        return *this;
    }
    /// NULL where there is no text.
    Query& textOrNull(const std::string& text) { return text.empty() ? null() : *this << text; }

    bool next() { return statement_.executeStep(); }
    void run() { statement_.exec(); }
    [[nodiscard]] SQLite::Column operator[](int column) const { return statement_.getColumn(column); }
    [[nodiscard]] std::string text(int column) const { return statement_.getColumn(column).getString(); }

  private:
    /// Text that no server could hold is rejected where it enters; what gets as far as this (a folder's name,
    /// a driver's) is kept as well as can be.
    void bindText(const std::string& text) {
        if (storableText(text))
            statement_.bind(++bound_, text);
        else
            statement_.bind(++bound_, storable(text));
    }

    SQLite::Statement& statement_;
    int bound_ = 0;
};

struct Store::Impl {
    std::filesystem::path path;
    Durability durability;
    SQLite::Database database;
    std::map<std::string, SQLite::Statement> statements{};  ///< prepared once, by their SQL
    std::optional<TrackingWriter> tracking{};               ///< from the first frames on
    long long session = 0;
    std::string session_participant{};
    std::optional<AnswerHasher> hasher{};       ///< from the first answer on
    std::optional<std::uint64_t> last_frame{};  ///< of the session, among those kept
    // In a whole run, where nobody else writes:
    std::optional<studies::GroupSizes> groups_taken{};
    std::optional<studies::GroupSizes> groups_registered{};
    std::optional<std::uint64_t> log_inode{};  ///< of the log's file
    std::optional<Error> moved{};              ///< the files are not where they were

    Impl(std::filesystem::path file, Durability how, SQLite::Database opened)
        : path(std::move(file)), durability(how), database(std::move(opened)) {}

    [[nodiscard]] Query query(const char* sql) {
        return Query(statements.try_emplace(sql, database, sql).first->second);
    }

    [[nodiscard]] bool inTransaction() const { return sqlite3_get_autocommit(database.getHandle()) == 0; }

    /// Runs `writes` as one transaction that is on the disk on return; in a whole run, as part of its one
    /// transaction.
    template <typename Writes>
    void transaction(const Writes& writes) {
        if (durability == Durability::whole_run) {
            if (!inTransaction()) database.exec("BEGIN IMMEDIATE");
            writes();
            return;
        }
        if (moved) throw DatabaseMoved(*moved);
        if (inTransaction()) {  // of exclusively()
            writes();
            return;
        }
        database.exec("BEGIN IMMEDIATE");
        try {
            writes();
            database.exec("COMMIT");
        } catch (...) {
            if (inTransaction()) database.tryExec("ROLLBACK");
            throw;
        }
        checkInPlace();
    }

    /// The same without waiting for the disk: it outlives the process, and a power cut from the next waited
    /// for transaction on.
    template <typename Writes>
    void unwaitedTransaction(const Writes& writes) {
        if (durability == Durability::whole_run) {
            transaction(writes);
            return;
        }
        database.exec("PRAGMA synchronous = NORMAL");
        try {
            transaction(writes);
        } catch (...) {
            database.tryExec("PRAGMA synchronous = FULL");
            throw;
        }
        database.exec("PRAGMA synchronous = FULL");
    }

    /// Once the database's files are not where they were, copies all that is kept to a file of its own and
    /// throws DatabaseMoved.
    void checkInPlace();
    [[nodiscard]] bool inPlace();
    [[nodiscard]] Error rescue();

    /// What stands in the way of storing the plan; none: nothing, or it is stored already.
    [[nodiscard]] std::optional<Error> objection(const studies::Study& study,
                                                 const Registration& registration,
                                                 const studies::StudyPlan& plan,
                                                 const std::string& locked_hash);
    /// Where the database holds another study than this one.
    [[nodiscard]] std::optional<Error> studyObjection(const studies::Study& study);
    void insertStudy(const studies::Study& study, const std::string& locked_hash);
    void insertStage(const studies::Stage& stage, int position, const studies::LanguageTable& words);
    void insertRegistration(const Registration& registration);
    void insertPlan(const studies::StudyPlan& plan, const std::string& json, const std::string& locked_hash);
    void insertTrial(const std::string& participant, const studies::Trial& trial);
    [[nodiscard]] std::optional<studies::StudyPlan> plan(const std::string& participant);
    /// `people`: of which participants, as in a FROM clause.
    [[nodiscard]] studies::GroupSizes countGroups(const std::string& people);

    void insertResponse(const studies::Response& response, const studies::Study& study,
                        const studies::StudyPlan& plan, const ClipRecords& clips);
    void insertConsent(const studies::Answer& answer, const studies::Response& response,
                       const studies::Study& study, const studies::Stage& stage);
    void insertField(const studies::Answer& answer);
    void supersede(const studies::Superseded& superseded);
    /// Once all is stored of the response, or something of it has changed.
    void keepHash(std::int64_t response);
    void exclude(const std::string& reason, const studies::Moment& at);
    void abort(const std::string& reason);
    /// A refusal gives way to the answer that was asked for again.
    void supersedeRejection(int trial_index, const studies::Moment& at);
    void insertNote(const studies::Note& note);
    /// Takes the session's participant out of the analysis, who counted until now.
    void leaveOut(ParticipantStatus status, const std::string& reason);
};

}  // namespace deixis::results
