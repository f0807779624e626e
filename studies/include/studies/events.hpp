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
    int rating = 0;         ///< 1..n in the naturalness stage; 0 else
    int chosen_place = -1;  ///< which ball, by place; -1 in the naturalness stage
    bool correct = false;   ///< game only
    Moment onset{};         ///< first frame of the clip's last play, as shown
    Moment motion_end{};    ///< last frame of the clip shown; selection opened here
    Moment answered{};
    double response_time_s = 0.0;  ///< answered - motion_end, less paused time
    double paused_s = 0.0;         ///< how long the session was paused while this answer was open
    int replays = 0;
    int pauses = 0;          ///< interruptions: during the clip, which then started over, or while choosing
    std::string input;       ///< "ray", "key"
    Pose stage_from_head{};  ///< at the answer
    std::optional<Ray> pointer{};  ///< at the answer
};

/// Anything else worth keeping: stages, instructions read, pauses, resumes, onsets, practice answers.
struct Note {
    std::string kind;  ///< "session_start", "stage_start", "instructions_read", "stimulus_onset",
                       ///< "motion_end", "practice_answer", "replay", "pause", "resume", "break_start",
                       ///< "break_end", "finished", "quit"
    int trial_index = -1;
    Moment at{};
    std::string detail{};
};

using SessionEvent = std::variant<Response, Note>;

}  // namespace deixis::studies
