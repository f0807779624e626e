// What happens in a session, as the session tells it and the store keeps it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/pose.hpp"
#include "studies/plan.hpp"

namespace deixis::studies {

/// A moment on the station's clock and as UTC.
struct Moment {
    double time_s = 0.0;
    double utc_s = 0.0;
};

/// An answer, complete: the store writes it in one transaction.
struct Response {
    int trial_index = 0;
    int rating = 0;                ///< 1..n in the naturalness stage; 0 else
    int chosen_place = -1;         ///< which ball, by place; -1 in the naturalness stage
    bool correct = false;          ///< game only
    Moment onset{};                ///< first frame of the clip's last play, as shown
    Moment motion_end{};           ///< last frame of the clip shown; selection opened here
    Moment answered{};             ///< when select, or the key, went down
    double response_time_s = 0.0;  ///< answered - motion_end, less paused time
    double paused_s = 0.0;         ///< how long the session was paused while this answer was open
    int replays = 0;
    int pauses = 0;          ///< interruptions: during the clip, which then started over, or while choosing
    std::string input;       ///< "ray", "key"
    Pose stage_from_head{};  ///< at the answer
    std::optional<Ray> pointer{};  ///< at the answer
};

/// Anything else worth keeping. Kinds, with their details:
/// - the course: "session_start", "stage_start" (name), "instructions_read" (page), "break_start",
///   "break_end", "finished", "quit" (reason);
/// - of a trial: "stimulus_onset" (replay), "motion_end", "practice_answer" (what), "replay";
/// - interruptions: "pause" (reason), "resume" (after how long), "trial_repeated";
/// - "early_select": select went down in a trial before its answer was open (what was shown, at most once a
///   trial), or so shortly before that it was told afterwards (by how much); it was no answer;
/// - "off_place" (how far, "0.42 m"; in a trial once, and once more where it gets worse by 10 cm),
///   "back_on_place";
/// - "pointer_lost" (in a trial, for 2 s while its answer was open), "pointer_found";
/// - whatever the station told, see StationNote.
struct Note {
    std::string kind;
    int trial_index = -1;  ///< of the trial under way; -1: none
    Moment at{};
    std::string detail{};
};

using SessionEvent = std::variant<Response, Note>;

}  // namespace deixis::studies
