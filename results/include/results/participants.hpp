// Looking after participants in a database: list, show, exclude, withdraw.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "studies/plan.hpp"

namespace deixis::results {

struct ParticipantRow {
    std::string id;
    int number = 0;
    std::string language;
    std::string status;  ///< "active", "excluded", "dropped"
    std::string reason;
    studies::Groups groups;
    bool synthetic = false;
    int sessions = 0;
    int answered = 0;  ///< trials, practice and pages included
    int planned = 0;
    int checks_failed = 0;
    double last_utc_s = 0.0;
    std::string consent;  ///< "agreed", "declined", "" where none was asked
};

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
/// Fails where there is no such participant; so do the following.
[[nodiscard]] Result<ParticipantDetails> showParticipant(const std::filesystem::path& database,
                                                         const std::string& participant);
/// Takes the participant's answers out of the analysis; they stay in the database. An empty reason is
/// refused.
[[nodiscard]] Result<void> excludeParticipant(const std::filesystem::path& database,
                                              const std::string& participant, const std::string& reason);
/// Undoes it.
[[nodiscard]] Result<void> includeParticipant(const std::filesystem::path& database,
                                              const std::string& participant);
enum class Withdrawn : unsigned char {
    erased,
    finished  ///< there was no such participant, but a withdrawal broken off before: its traces are gone now
};
/// Erases every row, tracked frame and text of the person, also from free pages and the write-ahead log, and
/// counts one withdrawal more. Where that breaks off after the rows are erased (full disk, power cut), the
/// next call goes on with the rest. Fails while a session of the participant runs.
[[nodiscard]] Result<Withdrawn> withdrawParticipant(const std::filesystem::path& database,
                                                    const std::string& participant, double utc_s);

}  // namespace deixis::results
