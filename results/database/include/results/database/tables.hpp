// What the tables store about a study and about each person: for copying rows from one database to
// another, and for erasing them.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace deixis::results {

/// A table of people's rows, and which of its columns are numbers that each database counts for itself.
struct ParticipantTable {
    const char* name;
    const char* own_id;            ///< counted again in another database; null: none
    const char* session;           ///< column that refers to sessions.id; null: none
    const char* response;          ///< column that refers to responses.id; null: none
    const char* participant_rows;  ///< the rows of a participant (?1)
    /// What tells a row from the participant's others in every copy: columns, separated by ", ". Of a
    /// session, response or event it is its own_id, counted from 1 within the participant.
    const char* key;
    /// Columns that may change once a row is stored, separated by ", "; empty: none.
    const char* changing = "";
    /// Columns that may be NULL at first, and never change after that.
    const char* filled_later = "";
};

/// What describes the study: the same in each of its databases, but for the language of its texts.
inline constexpr std::array<const char*, 7> study_tables{"study",     "stages",    "systems", "layouts",
                                                         "distances", "questions", "scores"};

inline constexpr const char* of_participant = "participant = ?1";
inline constexpr const char* of_sessions = "session IN (SELECT id FROM sessions WHERE participant = ?1)";
inline constexpr const char* of_responses = "response IN (SELECT id FROM responses WHERE participant = ?1)";

/// In an order in which each row finds what it refers to.
inline constexpr std::array<ParticipantTable, 18> participant_tables{{
    {"participants", nullptr, nullptr, nullptr, "id = ?1", "id", "status, reason, registered_utc_s", "token"},
    {"participant_groups", nullptr, nullptr, nullptr, of_participant, "factor"},
    {"participant_fields", nullptr, nullptr, nullptr, of_participant, "field", "value, text"},
    {"plans", nullptr, nullptr, nullptr, of_participant, "participant", "locked_hash"},
    {"trials", nullptr, nullptr, nullptr, of_participant, "trial_index"},
    {"trial_values", nullptr, nullptr, nullptr, of_participant, "trial_index, name"},
    {"trial_stimuli", nullptr, nullptr, nullptr, of_participant, "trial_index, position"},
    {"sessions", "id", nullptr, nullptr, of_participant, "id", "ended_utc_s, outcome"},
    {"session_properties", nullptr, "session", nullptr, of_sessions, "session, name"},
    {"consents", nullptr, "session", nullptr, of_participant, "stage, session",
     "agreed, utc_s, language, text"},
    {"responses", "id", "session", nullptr, of_participant, "id", "superseded, superseded_utc_s, hash"},
    {"response_stimuli", nullptr, nullptr, "response", of_responses, "response, position"},
    {"answers", nullptr, nullptr, "response", of_responses, "response, position"},
    {"response_values", nullptr, nullptr, "response", of_responses, "response, name"},
    {"events", "id", "session", nullptr, of_sessions, "id"},
    {"tracking_blocks", "id", "session", nullptr, of_sessions, "session, first_frame"},
    {"hand_joints", nullptr, "session", nullptr, of_sessions, "session, frame, hand"},
    {"trial_tracking", nullptr, "session", nullptr, of_sessions, "session, trial_index",
     "frames, dropped_frames, samples_missing, max_off_place_m, head_untracked_frames, first_display_time_s, "
     "last_display_time_s"},
}};

/// Whether a list separated by ", " names the column.
[[nodiscard]] constexpr bool isListed(std::string_view list, std::string_view column) {
    while (!list.empty()) {
        const auto comma = list.find(", ");
        if (list.substr(0, comma) == column) return true;
        list = comma == std::string_view::npos ? "" : list.substr(comma + 2);
    }
    return false;
}

}  // namespace deixis::results
