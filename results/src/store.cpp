#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/core.h>
#include <sqlite3.h>

#include <cstdint>
#include <map>
#include <stdexcept>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "database_errors.hpp"
#include "schema.hpp"
#include "tracking_rows.hpp"

namespace deixis::results {

namespace {

constexpr int busy_timeout_ms = 1000;
/// In a session another program's lock is waited for longer: nothing but the next trial waits with it.
constexpr int session_busy_timeout_ms = 30'000;

/// SQLite integers are signed 64 bit.
std::int64_t integer(bool value) {
    return value ? 1 : 0;
}

std::string positionsJson(const std::vector<Vec3>& positions) {
    std::string out = "[";
    for (const Vec3& p : positions) {
        if (out.size() > 1) out += ",";
        out += fmt::format("[{},{},{}]", p.x, p.y, p.z);
    }
    return out + "]";
}

void bindPoint(SQLite::Statement& statement, int first, const Vec3& point) {
    statement.bind(first, point.x);
    statement.bind(first + 1, point.y);
    statement.bind(first + 2, point.z);
}

void bindOrNull(SQLite::Statement& statement, int index, const std::string& text) {
    if (text.empty())
        statement.bind(index);
    else
        statement.bind(index, text);
}

}  // namespace

struct Store::Impl {
    std::filesystem::path path;
    Durability durability;
    SQLite::Database database;
    std::map<std::string, SQLite::Statement> statements;  ///< prepared once, by their SQL
    std::optional<TrackingRows> tracking;                 ///< from the first frames on
    long long session = 0;
    std::string session_participant;

    Impl(const std::filesystem::path& file, Durability how)
        : path(file),
          durability(how),
          database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_timeout_ms) {}

    SQLite::Statement& prepared(const char* sql) {
        const auto [found, _] = statements.try_emplace(sql, database, sql);
        SQLite::Statement& statement = found->second;
        statement.tryReset();  // what it failed with before was thrown then
        statement.clearBindings();
        return statement;
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
        database.exec("BEGIN IMMEDIATE");
        try {
            writes();
            database.exec("COMMIT");
        } catch (...) {
            if (inTransaction()) database.tryExec("ROLLBACK");
            throw;
        }
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

    Result<void> prepareFile();
    void insertStudy(const studies::Study& study);
    void insertPlan(const studies::StudyPlan& plan, const std::string& json, const std::string& hash);
    void insertResponse(const studies::Response& response, const studies::StudyPlan& plan,
                        const std::vector<ClipRecord>& clips_by_trial);
    void insertNote(const studies::Note& note);
};

/// Checks whose file it is before anything is changed in it, then sets it up for writing.
Result<void> Store::Impl::prepareFile() {
    if (const auto whose = identify(database, path); !whose) return tl::unexpected(whose.error());
    if (sqlite3_db_readonly(database.getHandle(), "main") != 0)
        return fail(path.string(), "the database can be read but not written",
                    "Give yourself write permission for the file and its folder, or name another file");
    database.exec("PRAGMA foreign_keys = ON");
    // Switching to WAL answers with the mode in force.
    if (database.execAndGet("PRAGMA journal_mode = WAL").getString() != "wal")
        return fail(path.string(), "the file system does not allow SQLite's write-ahead log",
                    "Keep the database on a local disk");
    database.exec(durability == Durability::each_answer ? "PRAGMA synchronous = FULL"
                                                        : "PRAGMA synchronous = OFF");
    Result<void> outcome{};
    // Asked again under the write lock: another process may have set the file up in between.
    transaction([&] {
        const auto whose = identify(database, path);
        if (!whose) {
            outcome = tl::unexpected(whose.error());
        } else if (whose->version < schema_version) {
            for (const char* step : schemaSteps(whose->version)) database.exec(step);
            database.exec(fmt::format("PRAGMA application_id = {}", application_id));
            database.exec(fmt::format("PRAGMA user_version = {}", schema_version));
        }
    });
    return outcome;
}

Result<Store> Store::open(const std::filesystem::path& path, Durability durability) {
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        return fail(path.string(), fmt::format("the folder '{}' does not exist", folder.string()),
                    "Create it, or name a file elsewhere");
    if (std::filesystem::is_directory(path, ignored))
        return fail(path.string(), "found a folder, expected a database file", "Name a file in it");
    try {
        auto impl = std::make_unique<Impl>(path, durability);
        if (auto ready = impl->prepareFile(); !ready) return tl::unexpected(ready.error());
        return Store(std::move(impl));
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(path, problem));
    }
}

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

std::optional<studies::StudyPlan> Store::plan(const std::string& participant) const {
    SQLite::Statement& query = impl_->prepared("SELECT json FROM plans WHERE participant = ?");
    query.bind(1, participant);
    if (!query.executeStep()) return std::nullopt;
    auto stored = studies::planFromJson(query.getColumn(0).getString());
    query.reset();
    if (!stored)
        throw std::runtime_error(fmt::format("{}: the stored plan of participant {} cannot be read: {}",
                                             impl_->path.string(), participant, stored.error().text()));
    return std::move(*stored);
}

Result<void> Store::storePlan(const studies::Study& study, const studies::StudyPlan& plan) {
    const std::string where = impl_->path.string();
    if (plan.study_hash != study.hash)
        return fail(where,
                    fmt::format("the plan of participant {} was made for another study file (hash {:.12}, "
                                "not {:.12})",
                                plan.participant, plan.study_hash, study.hash));
    const std::string json = studies::planJson(plan);
    const std::string hash = sha256Hex(json);
    Result<void> outcome{};
    impl_->transaction([&] {
        SQLite::Statement& known = impl_->prepared("SELECT name, hash FROM study");
        if (!known.executeStep()) {
            impl_->insertStudy(study);
        } else if (known.getColumn(1).getString() != study.hash) {
            outcome = fail(
                where,
                fmt::format("the database holds study '{}' (hash {:.12}), but this is '{}' (hash {:.12})",
                            known.getColumn(0).getString(), known.getColumn(1).getString(), study.name,
                            study.hash),
                "Use the study file that it was begun with, or another database");
            known.reset();
            return;
        }
        known.reset();
        SQLite::Statement& earlier = impl_->prepared("SELECT hash FROM plans WHERE participant = ?");
        earlier.bind(1, plan.participant);
        if (!earlier.executeStep()) {
            impl_->insertPlan(plan, json, hash);
        } else if (earlier.getColumn(0).getString() != hash) {
            outcome = fail(
                where,
                fmt::format("the database holds another plan for participant {} (hash {:.12}, not {:.12})",
                            plan.participant, earlier.getColumn(0).getString(), hash),
                "Go on with the stored plan, or use another participant id");
        }
        earlier.reset();
    });
    return outcome;
}

void Store::Impl::insertStudy(const studies::Study& study) {
    SQLite::Statement& insert = prepared("INSERT INTO study VALUES (1, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, study.name);
    insert.bind(2, study.title);
    insert.bind(3, study.hash);
    // The file's text is kept only if it is still the one that was read.
    const auto text = readFile(study.file);
    bindOrNull(insert, 4, text && sha256Hex(*text) == study.hash ? *text : std::string());
    insert.bind(5, study.alpha);
    insert.bind(6, static_cast<std::int64_t>(study.rating.labels.size()));
    insert.exec();
    std::int64_t position = 0;
    for (const auto& system : study.systems) {
        SQLite::Statement& row = prepared("INSERT INTO systems VALUES (?, ?, ?, ?)");
        row.bind(1, position++);
        row.bind(2, system.name);
        bindOrNull(row, 3, system.generator);
        bindOrNull(row, 4, system.manifest);
        row.exec();
    }
    position = 0;
    for (const auto& layout : study.layouts) {
        SQLite::Statement& row = prepared("INSERT INTO layouts VALUES (?, ?, ?, ?, ?)");
        row.bind(1, position++);
        row.bind(2, layout.name);
        row.bind(3, layout.viewer_x_m);
        row.bind(4, layout.viewer_z_m);
        row.bind(5, layout.heading_deg);
        row.exec();
    }
}

void Store::Impl::insertPlan(const studies::StudyPlan& plan, const std::string& json,
                             const std::string& hash) {
    SQLite::Statement& participant = prepared("INSERT OR IGNORE INTO participants VALUES (?)");
    participant.bind(1, plan.participant);
    participant.exec();
    SQLite::Statement& row = prepared("INSERT INTO plans VALUES (?, ?, ?, ?)");
    row.bind(1, plan.participant);
    row.bind(2, std::to_string(plan.seed));
    row.bind(3, hash);
    row.bind(4, json);
    row.exec();
    for (const auto& trial : plan.trials) {
        SQLite::Statement& one =
            prepared("INSERT INTO trials VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
        one.bind(1, plan.participant);
        one.bind(2, trial.index);
        one.bind(3, std::string(studies::stageName(trial.stage)));
        one.bind(4, integer(trial.practice));
        one.bind(5, trial.system);
        one.bind(6, trial.target_id);
        one.bind(7, trial.layout);
        bindPoint(one, 8, trial.target);
        one.bind(11, positionsJson(trial.distractors));
        if (trial.stage == studies::StageKind::game) {
            std::vector<Vec3> balls;
            for (std::size_t place = 0; place < trial.ball_order.size(); ++place)
                balls.push_back(trial.ball(static_cast<int>(place)));
            one.bind(12, positionsJson(balls));
            one.bind(13, trial.targetPlace());
        }
        one.exec();
    }
}

std::set<int> Store::answeredTrials(const std::string& participant) const {
    SQLite::Statement& query = impl_->prepared("SELECT trial_index FROM responses WHERE participant = ?");
    query.bind(1, participant);
    std::set<int> answered;
    while (query.executeStep()) answered.insert(query.getColumn(0).getInt());
    query.reset();
    return answered;
}

std::vector<std::string> Store::participants() const {
    SQLite::Statement& query = impl_->prepared("SELECT id FROM participants ORDER BY id");
    std::vector<std::string> ids;
    while (query.executeStep()) ids.push_back(query.getColumn(0).getString());
    query.reset();
    return ids;
}

bool Store::hasSession(const std::string& participant, bool synthetic) const {
    SQLite::Statement& query =
        impl_->prepared("SELECT count(*) FROM sessions WHERE participant = ? AND synthetic = ?");
    query.bind(1, participant);
    query.bind(2, synthetic ? 1 : 0);
    query.executeStep();
    const bool has = query.getColumn(0).getInt() > 0;
    query.reset();
    return has;
}

long long Store::beginSession(const SessionInfo& session) {
    std::int64_t id = 0;
    impl_->transaction([&] {
        SQLite::Statement& insert = impl_->prepared(
            "INSERT INTO sessions (participant, station, station_details, synthetic, program_version, "
            "avatar_hash, "
            "started_utc_s) VALUES (?, ?, ?, ?, ?, ?, ?)");
        insert.bind(1, session.participant);
        insert.bind(2, session.station.kind);
        insert.bind(3, session.station.details);
        insert.bind(4, integer(session.station.synthetic));
        insert.bind(5, session.program_version);
        insert.bind(6, session.avatar_hash);
        insert.bind(7, session.started_utc_s);
        insert.exec();
        id = impl_->database.getLastInsertRowid();
        for (const auto& [name, value] : session.station.properties) {
            SQLite::Statement& property = impl_->prepared("INSERT INTO session_properties VALUES (?, ?, ?)");
            property.bind(1, id);
            property.bind(2, name);
            property.bind(3, value);
            property.exec();
        }
    });
    impl_->database.setBusyTimeout(session_busy_timeout_ms);
    impl_->session = id;
    impl_->session_participant = session.participant;
    return impl_->session;
}

void Store::record(const studies::SessionEvent& event, const studies::StudyPlan& plan,
                   const std::vector<ClipRecord>& clips_by_trial) {
    if (impl_->session == 0) throw std::logic_error("Store::record: no session was begun");
    if (plan.participant != impl_->session_participant)
        throw std::logic_error(fmt::format("Store::record: the session is participant {}'s, the plan is {}'s",
                                           impl_->session_participant, plan.participant));
    if (const auto* response = std::get_if<studies::Response>(&event)) {
        impl_->transaction([&] { impl_->insertResponse(*response, plan, clips_by_trial); });
        return;
    }
    const auto& note = std::get<studies::Note>(event);
    impl_->unwaitedTransaction([&] { impl_->insertNote(note); });
}

void Store::recordTracking(std::span<const TrackedFrame> frames, std::span<const TrialTracking> trials) {
    if (impl_->session == 0) throw std::logic_error("Store::recordTracking: no session was begun");
    if (!impl_->tracking) impl_->tracking.emplace(impl_->database);
    impl_->unwaitedTransaction([&] {
        for (const TrackedFrame& frame : frames) impl_->tracking->insert(impl_->session, frame);
        for (const TrialTracking& trial : trials) impl_->tracking->insert(impl_->session, trial);
    });
}

void Store::Impl::insertResponse(const studies::Response& response, const studies::StudyPlan& plan,
                                 const std::vector<ClipRecord>& clips_by_trial) {
    const auto index = static_cast<std::size_t>(response.trial_index);
    const studies::Trial& trial = plan.trials.at(index);
    const ClipRecord& clip = clips_by_trial.at(index);
    SQLite::Statement& insert = prepared(
        "INSERT INTO responses (participant, trial_index, session, clip_file, clip_hash, rating, "
        "chosen_place, correct, onset_s, onset_utc_s, motion_end_s, motion_end_utc_s, answered_s, "
        "answered_utc_s, response_time_s, replays, pauses, input, head_x_m, head_y_m, head_z_m, head_qw, "
        "head_qx, head_qy, head_qz, ray_x_m, ray_y_m, ray_z_m, ray_dx, ray_dy, ray_dz, paused_s) VALUES "
        "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, plan.participant);
    insert.bind(2, response.trial_index);
    insert.bind(3, static_cast<std::int64_t>(session));
    insert.bind(4, clip.file);
    insert.bind(5, clip.content_hash);
    if (trial.stage == studies::StageKind::game) {
        insert.bind(7, response.chosen_place);
        insert.bind(8, integer(response.correct));
    } else {
        insert.bind(6, response.rating);
    }
    insert.bind(9, response.onset.time_s);
    insert.bind(10, response.onset.utc_s);
    insert.bind(11, response.motion_end.time_s);
    insert.bind(12, response.motion_end.utc_s);
    insert.bind(13, response.answered.time_s);
    insert.bind(14, response.answered.utc_s);
    insert.bind(15, response.response_time_s);
    insert.bind(16, response.replays);
    insert.bind(17, response.pauses);
    insert.bind(18, response.input);
    bindPoint(insert, 19, response.stage_from_head.position);
    const Quat& turn = response.stage_from_head.orientation;
    insert.bind(22, turn.w);
    insert.bind(23, turn.x);
    insert.bind(24, turn.y);
    insert.bind(25, turn.z);
    if (response.pointer) {
        bindPoint(insert, 26, response.pointer->origin);
        bindPoint(insert, 29, response.pointer->direction);
    }
    insert.bind(32, response.paused_s);
    insert.exec();
}

void Store::Impl::insertNote(const studies::Note& note) {
    SQLite::Statement& insert = prepared(
        "INSERT INTO events (session, kind, trial_index, time_s, utc_s, detail) VALUES (?, ?, ?, ?, ?, ?)");
    insert.bind(1, static_cast<std::int64_t>(session));
    insert.bind(2, note.kind);
    if (note.trial_index >= 0) insert.bind(3, note.trial_index);
    insert.bind(4, note.at.time_s);
    insert.bind(5, note.at.utc_s);
    insert.bind(6, note.detail);
    insert.exec();
}

void Store::endSession(const std::string& outcome, double ended_utc_s) {
    impl_->transaction([&] {
        SQLite::Statement& update =
            impl_->prepared("UPDATE sessions SET outcome = ?, ended_utc_s = ? WHERE id = ?");
        update.bind(1, outcome);
        update.bind(2, ended_utc_s);
        update.bind(3, static_cast<std::int64_t>(impl_->session));
        update.exec();
    });
    impl_->session = 0;
    impl_->session_participant.clear();
}

void Store::commit() {
    if (!impl_->inTransaction()) return;
    impl_->database.exec("COMMIT");
    // Written without waiting for the disk so far; now it is waited for, once.
    impl_->database.exec(
        "PRAGMA synchronous = FULL; PRAGMA wal_checkpoint(TRUNCATE); PRAGMA synchronous = OFF");
}

}  // namespace deixis::results
