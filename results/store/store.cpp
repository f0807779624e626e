#include "results/store/store.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "results/database/database_open.hpp"
#include "results/database/participant_token.hpp"
#include "store_impl.hpp"

namespace deixis::results {

Result<Store> Store::open(const std::filesystem::path& path, Durability durability,
                          std::chrono::milliseconds patience) {
    try {
        auto database = openToWrite(path, Missing::create, patience);
        if (!database) return tl::unexpected(database.error());
        database->setBusyTimeout(static_cast<int>(patience.count()));
        auto impl = std::make_unique<Impl>(path, durability, std::move(*database));
        if (durability == Durability::whole_run) {
            impl->database.exec("PRAGMA synchronous = OFF");
            impl->transaction([] {});  // keeps others out from the start
        }
        return Store(std::move(impl));
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(path, problem));
    }
}

Result<void> Store::read(const std::filesystem::path& path,
                         const std::function<Result<void>(const Store&)>& look) {
    return readDatabase(path, [&](SQLite::Database& opened) -> Result<void> {
        const Store store(std::make_unique<Impl>(path, Durability::each_answer, std::move(opened)));
        auto looked = look(store);
        store.impl_->statements.clear();
        opened = std::move(store.impl_->database);
        return looked;
    });
}

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

long long Store::beginSession(const SessionInfo& session) {
    std::int64_t id = 0;
    impl_->transaction([&] {
        auto insert = impl_->query(
            "INSERT INTO sessions (participant, station, station_details, synthetic, program_version, "
            "avatar_hash, started_utc_s) VALUES (?, ?, ?, ?, ?, ?, ?)");
        insert << session.participant << studies::stationKindName(session.station.kind)
               << session.station.details << session.station.synthetic << session.program_version
               << session.avatar_hash << session.started_utc_s;
        insert.run();
        id = impl_->database.getLastInsertRowid();
        for (const auto& [name, value] : session.station.properties) {
            auto property = impl_->query("INSERT INTO session_properties VALUES (?, ?, ?)");
            property << id << name << value;
            property.run();
        }
        auto registered = impl_->query(
            "UPDATE participants SET registered_utc_s = ? WHERE id = ? AND registered_utc_s = 0.0");
        registered << session.started_utc_s << session.participant;
        registered.run();
        // Who was registered before there were tokens, and begins now.
        auto token = impl_->query("UPDATE participants SET token = ? WHERE id = ? AND token IS NULL");
        token << drawToken() << session.participant;
        token.run();
    });
    impl_->session = id;
    impl_->session_participant = session.participant;
    impl_->last_frame.reset();
    return impl_->session;
}

void Store::record(const studies::SessionEvent& event, const studies::Study& study,
                   const studies::StudyPlan& plan, const ClipRecords& clips) {
    if (impl_->session == 0) throw std::logic_error("Store::record: no session was begun");
    if (plan.participant != impl_->session_participant)
        throw std::logic_error(fmt::format("Store::record: the session is participant {}'s, the plan is {}'s",
                                           impl_->session_participant, plan.participant));
    if (const auto* note = std::get_if<studies::Note>(&event)) {
        const bool abort = note->kind == studies::NoteKind::operator_abort;
        const auto keep = [&] {
            impl_->insertNote(*note);
            if (abort) impl_->abort(note->detail);
        };
        if (abort)
            impl_->transaction(keep);
        else
            impl_->unwaitedTransaction(keep);
        return;
    }
    impl_->transaction([&] {
        if (const auto* response = std::get_if<studies::Response>(&event))
            impl_->insertResponse(*response, study, plan, clips);
        else if (const auto* superseded = std::get_if<studies::Superseded>(&event))
            impl_->supersede(*superseded);
        else if (const auto* exclusion = std::get_if<studies::Exclusion>(&event))
            impl_->exclude(exclusion->reason, exclusion->at);
    });
}

void Store::recordTracking(std::span<const TrackedFrame> frames, std::span<const TrialTracking> trials) {
    if (impl_->session == 0) throw std::logic_error("Store::recordTracking: no session was begun");
    auto last = impl_->last_frame;
    for (const TrackedFrame& frame : frames) {
        if (last && frame.sample.frame <= *last)
            throw std::logic_error(fmt::format("Store::recordTracking: frame {} comes after frame {}",
                                               frame.sample.frame, *last));
        last = frame.sample.frame;
    }
    if (!impl_->tracking) impl_->tracking.emplace(impl_->database);
    impl_->unwaitedTransaction([&] {
        impl_->tracking->insert(impl_->session, frames);
        for (const TrialTracking& trial : trials) impl_->tracking->insert(impl_->session, trial);
    });
    impl_->last_frame = last;
}

void Store::Impl::leaveOut(ParticipantStatus status, const std::string& reason) {
    auto update = query("UPDATE participants SET status = ?, reason = ? WHERE id = ? AND status = 'active'");
    update << participantStatusName(status) << reason << session_participant;
    update.run();
    groups_taken.reset();
}

void Store::endSession(studies::SessionOutcome outcome, double ended_utc_s) {
    if (outcome == studies::SessionOutcome::running)
        throw std::logic_error("Store::endSession: the session is running");
    impl_->transaction([&] {
        auto update = impl_->query("UPDATE sessions SET outcome = ?, ended_utc_s = ? WHERE id = ?");
        update << std::string(studies::sessionOutcomeName(outcome)) << ended_utc_s << impl_->session;
        update.run();
    });
    impl_->session = 0;
    impl_->session_participant.clear();
}

void Store::commit() {
    if (!impl_->inTransaction()) return;
    impl_->database.exec("COMMIT");
    // Written without waiting for the disk so far; now it is waited for, once.
    impl_->database.exec(
        "PRAGMA synchronous = FULL; PRAGMA main.wal_checkpoint(TRUNCATE); PRAGMA synchronous = OFF");
}

}  // namespace deixis::results
