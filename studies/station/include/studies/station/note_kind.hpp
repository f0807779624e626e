// The kinds of notes in the record: one name for each, in databases, traces and documents.
#pragma once

#include <cstdint>
#include <string_view>

namespace deixis::studies {

enum class NoteKind : std::uint8_t {
    // The timeline of a session.
    session_start,
    stage_start,        ///< detail: its name
    instructions_read,  ///< which page
    break_start,
    break_end,
    finished,
    quit,  ///< why
    // Of a trial.
    stimulus_onset,  ///< which stimulus, replay
    motion_end,      ///< which stimulus
    replay,
    check_failed,  ///< what
    warned,
    feedback,
    early_select,  ///< select went down before the answer was open (what was shown, at most once a trial), or
                   ///< so
                   ///< shortly before that it was told afterwards (by how much); it was not an answer
    edit,          ///< of a project that is authored: JSON of what was done
    practice_met,  ///< share correct
    practice_failed,
    // Interruptions.
    pause,   ///< why
    resume,  ///< after how long
    trial_repeated,
    off_place,  ///< how far, "0.42 m"; in a trial once, and once more where it gets worse by 10 cm
    back_on_place,
    pointer_lost,  ///< in a trial, for 2 s while its answer was open
    pointer_found,
    recording_failed,  ///< answers can no longer be kept, and why: for the operator, as no database can hold
                       ///< it
    // The operator's.
    operator_repeat,  ///< why
    operator_skip,
    operator_abort,
    operator_note,  ///< the remark
    operator_saw_trial,
    excluded,  ///< the participant, and why
    // Whatever a station tells.
    xr_state,
    recentre,
    placement,
    input_profile,
    pointing_hand,
    ipd,
    refresh_rate,
    missing_characters,
    sound  ///< how far one that has ended was from its movement
};

/// "session_start", ...: as the enumerators.
[[nodiscard]] std::string_view noteKindName(NoteKind kind);

}  // namespace deixis::studies
