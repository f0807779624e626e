// Managing participants in a database: list, show, exclude, include, withdraw.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "results/database/participant_status.hpp"
#include "studies/design/plan.hpp"

namespace deixis::results {

enum class Consent : unsigned char { not_asked, agreed, declined };
[[nodiscard]] std::string_view consentName(Consent consent);  ///< "" where it was not asked

struct ParticipantRow {
    std::string id;
    int number = 0;
    std::string language;
    ParticipantStatus status = ParticipantStatus::active;  ///< without consent nobody is
    std::string reason;
    studies::Groups groups;
    bool synthetic = false;
    int sessions = 0;
    int answered = 0;  ///< units of the plan: trials, practice and pages; no consent that was declined
    int planned = 0;   ///< of the same; further attempts at a practice once they have begun
    int checks_failed = 0;
    double last_utc_s = 0.0;
    Consent consent = Consent::not_asked;
};

/// Whether a session of the participant may begin: only with consent, or to ask for it again.
[[nodiscard]] bool mayTakePart(const ParticipantRow& participant);

struct ParticipantDetails {
    ParticipantRow row;
    std::vector<std::pair<std::string, std::string>> fields;  ///< name and value as text
    std::vector<std::string> sessions;                        ///< one line each, for people
    std::vector<std::string>
        events;  ///< pauses, failed checks, the operator's doings and notes: one line each
};

struct ParticipantList {
    std::vector<ParticipantRow> rows;
    int withdrawn = 0;
    int uncleared = 0;  ///< of `withdrawn`: broken off, free pages still hold traces
};

[[nodiscard]] Result<ParticipantList> listParticipants(const std::filesystem::path& database);
/// Fails if there is no such participant; so do the following.
[[nodiscard]] Result<ParticipantDetails> showParticipant(const std::filesystem::path& database,
                                                         const std::string& participant);
/// Takes the participant's answers out of the analysis; they stay in the database. An empty reason is
/// rejected.
[[nodiscard]] Result<void> excludeParticipant(const std::filesystem::path& database,
                                              const std::string& participant, const std::string& reason);
/// What letting somebody in again came to.
struct Inclusion {
    bool consent_asked_anew = false;      ///< it was declined: nobody counts before it is given
    std::vector<std::string> practice{};  ///< stages that were failed, and are practised again
    int failed_checks_forgiven = 0;       ///< attention checks that no rule counts any more
};

/// Lets an excluded participant or drop-out in again, and resets what led to it: attention checks failed so
/// far no longer count towards a rule, a practice that was failed begins again (its answers stay, marked),
/// and a consent that was declined is asked again. Fails while a session of the participant runs.
[[nodiscard]] Result<Inclusion> includeParticipant(const std::filesystem::path& database,
                                                   const std::string& participant, double utc_s);
enum class Withdrawn : unsigned char {
    erased,
    finished  ///< there was no such participant, but a withdrawal broken off before: its traces are gone now
};
/// Erases every row, tracked frame and text of the person, also from free pages and the write-ahead log, and
/// counts one withdrawal more. Where that breaks off after the rows are erased (full disk, power cut), the
/// next call continues with the rest. Fails while a session of the participant runs.
[[nodiscard]] Result<Withdrawn> withdrawParticipant(const std::filesystem::path& database,
                                                    const std::string& participant, double utc_s);

}  // namespace deixis::results
