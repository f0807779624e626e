// What a session is doing in a frame: one name for each state, in traces, pictures and documents.
#pragma once

#include <string_view>

namespace deixis::studies {

enum class PresentedState : unsigned char {
    starting,  ///< nothing has been presented yet; its name is empty
    // Pages.
    instructions,
    consent,
    questionnaire,
    rest,  ///< "break"
    welcome_back,
    practice_again,
    attention,  ///< a warning
    closing,    ///< thanks, or why the session ends
    paused,
    // Trials.
    waiting,
    playing,
    pointing,    ///< the clip's second half
    check,       ///< the same, and a number to be given is shown
    rating,      ///< the answer to a single clip is open
    rated,       ///< an answer given on a board is shown
    watching,    ///< parallel rating: the board is open
    comparing,   ///< a pair: the board is open
    reasons,     ///< for a preference
    choosing,    ///< the game: the ray is on no ball,
    aiming,      ///< or on one
    chosen,      ///< the ball chosen is shown
    feedback,    ///< the target is shown
    confidence,  ///< how sure the choice was
    authoring,   ///< gestures are made in the studio's page
    over
};

/// "instructions", "break", "welcome-back", ...
[[nodiscard]] std::string_view presentedStateName(PresentedState state);

/// Whether a board to be read or filled in stands before the viewer in place of all else, as opposed to one
/// beside a task.
[[nodiscard]] bool isFullPage(PresentedState state);

}  // namespace deixis::studies
