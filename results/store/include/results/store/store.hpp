// The SQLite store: one file has the participants, plans, sessions, responses and events of a study. The
// schema is documented in docs/database.md. Failing SQLite calls inside a session throw; what a user can
// meet on opening (a newer version, a locked or read-only file, not a database) is a Result.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "studies/design/plan.hpp"
#include "studies/session/events.hpp"
#include "studies/session/session.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::results {

/// What a stimulus was: stored with each response.
struct ClipRecord {
    std::string file;
    std::string content_hash;    ///< SHA-256 of the file's bytes
    std::string author{};        ///< who made it, as the manifest says; empty: not known
    std::optional<int> trial{};  ///< which of the author's trials it came from
};

/// By stimulus, for all that a plan shows.
using ClipRecords = std::map<studies::Stimulus, ClipRecord>;

/// Somebody who takes part, as registered before the first session.
struct Registration {
    std::string participant;
    int number = 1;
    std::string language;
    studies::Groups groups{};
};

/// An open session of one participant.
struct SessionInfo {
    std::string participant;
    studies::StationInfo station;
    std::string program_version;
    std::string avatar_hash;
    double started_utc_s = 0.0;
};

/// A tracking sample, and the trial that was under way.
struct TrackedFrame {
    studies::TrackingSample sample;
    int trial_index = -1;  ///< -1: none
};

/// What the tracking of one trial came to, the missing samples included.
struct TrialTracking {
    int trial_index = 0;
    long long frames = 0;
    long long dropped_frames = 0;
    long long samples_missing = 0;  ///< of `frames`: measured, but not kept
    double max_off_place_m = 0.0;
    long long head_untracked_frames = 0;  ///< of `frames`: the head was not measured
    double first_display_time_s = 0.0;
    double last_display_time_s = 0.0;
};

enum class Durability : unsigned char {
    each_answer,  ///< synchronous=FULL: an answer is on the disk before the next trial starts
    whole_run,    ///< one transaction for all (simulations, which can be run again)
};

/// Thrown by whatever writes, once the database's file or its log is not where it was: somebody has renamed,
/// moved, replaced or deleted it. what() says where all that was kept until then lies now.
class DatabaseMoved : public std::runtime_error {
  public:
    explicit DatabaseMoved(const Error& why) : std::runtime_error(why.text()) {}
};

/// How long a lock is waited for.
inline constexpr std::chrono::milliseconds store_patience{30'000};

class Store {
  public:
    /// Opens or creates; a database of an older version is brought to the newest one, with all that it holds.
    /// Errors: not a database, newer user_version, locked for longer than `patience`, read-only folder or
    /// file, the log of a database that is not there beside it.
    [[nodiscard]] static Result<Store> open(const std::filesystem::path& path, Durability durability,
                                            std::chrono::milliseconds patience = store_patience);
    /// Gives `look` a store of a database that is only read, as it is at one moment: nothing in it or beside
    /// it is changed, and an older version is updated in memory. May call it twice, where a writer
    /// came in between. Errors: its own, no such file, damaged, nothing in it yet.
    [[nodiscard]] static Result<void> read(const std::filesystem::path& path,
                                           const std::function<Result<void>(const Store&)>& look);
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;
    ~Store();

    // Who there is.
    [[nodiscard]] std::optional<Registration> registration(const std::string& participant) const;
    [[nodiscard]] std::vector<std::string> participants() const;
    [[nodiscard]] int firstFreeNumber() const;  ///< one more than the highest
    [[nodiscard]] bool numberTaken(int number) const;
    /// Of everybody who counts for the balance: neither excluded nor dropped out, consent not refused.
    [[nodiscard]] studies::GroupSizes groupsTaken() const;
    [[nodiscard]] studies::GroupSizes groupsRegistered() const;  ///< of everybody, drop-outs too
    /// The stored plan of a participant, if any.
    [[nodiscard]] std::optional<studies::StudyPlan> plan(const std::string& participant) const;
    /// Stores study, registration and plan, all or nothing. `locked_hash` is of the locked set that the plan
    /// was made from; where it is empty, nothing was locked. Fails if the database holds another study
    /// (another locked set in force, or another hash where nothing was locked), another plan of the
    /// participant, or the number for somebody else.
    [[nodiscard]] Result<void> storePlan(const studies::Study& study, const Registration& registration,
                                         const studies::StudyPlan& plan, const std::string& locked_hash = {});
    /// Runs `work` under the database's write lock, all or nothing: what it reads still holds when it stores
    /// a plan. Nothing is kept where it fails.
    [[nodiscard]] Result<void> exclusively(const std::function<Result<void>()>& work);

    // What is locked of the study (docs/database.md).
    /// Hash of the locked set in force; empty: nothing was locked when the study began. None: there is no
    /// study yet.
    [[nodiscard]] std::optional<std::string> lockedHash() const;
    /// The set that a participant's stored plan was made from; none if no plan is stored.
    [[nodiscard]] std::optional<std::string> lockedHashOf(const std::string& participant) const;
    /// Fails if the database holds another study than this one (other hash), and says how they differ.
    [[nodiscard]] Result<void> checkStudy(const studies::Study& study) const;
    /// Of a study that began with nothing locked: study and plans are of this set from now on.
    void lockOlder(const std::string& hash);
    /// Another set is in force from now on: `what` (JSON) has changed, for a reason. Fails if `from` is
    /// not the one in force.
    [[nodiscard]] Result<void> changeLocked(const std::string& from, const std::string& to,
                                            const std::string& what, const std::string& reason, double utc_s);
    /// Of the study with which the database began: its file's text.
    [[nodiscard]] std::string studySource() const;
    /// Each target that any stored plan shows, once by item and place.
    [[nodiscard]] std::vector<studies::TargetItem> plannedTargets() const;
    /// By system, the file of a clip that was shown.
    [[nodiscard]] std::map<std::string, std::string> shownClips() const;
    /// What earlier sessions left; `now_utc_s` gives the gap.
    [[nodiscard]] studies::Resume resume(const std::string& participant, double now_utc_s) const;
    /// Whether the participant has had a session with a simulated participant (`synthetic`) or with a person.
    [[nodiscard]] bool hasSession(const std::string& participant, bool synthetic) const;
    /// Median seconds that one answered unit of each stage took in finished sessions, from its start to the
    /// next one's: for the estimate of the time left. Stages without any are missing.
    [[nodiscard]] std::map<std::string, double> secondsPerUnit() const;

    /// Starts a session; later records belong to it. Returns its id. The station's properties must have
    /// different names.
    long long beginSession(const SessionInfo& session);
    /// Keeps an event. A response is one transaction with all that it holds and all that follows from it: an
    /// exclusion, or that consent was declined, which makes the participant a drop-out until it is given. It
    /// is durable on return; so are what supersedes one, an exclusion, and an operator's abort, which makes
    /// the participant a drop-out. Throws DatabaseMoved once the event is
    /// kept.
    void record(const studies::SessionEvent& event, const studies::Study& study,
                const studies::StudyPlan& plan, const ClipRecords& clips);
    /// Keeps frames of the session, each number once, and tallies of trials that are over (added to those of
    /// the same trial kept before), in one transaction. The disk is not waited for: a power cut may take what
    /// was written since the last response.
    void recordTracking(std::span<const TrackedFrame> frames, std::span<const TrialTracking> trials);
    void endSession(studies::SessionOutcome outcome, double ended_utc_s);
    /// Commits a whole_run store. Nothing is kept of it without this call.
    void commit();

  private:
    struct Impl;
    explicit Store(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace deixis::results
