// The events of a session, as the session reports them and the store records them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/pose.hpp"
#include "studies/design/plan.hpp"
#include "studies/station/note_kind.hpp"

namespace deixis::studies {

/// A moment on the station's clock and as UTC.
struct Moment {
    double time_s = 0.0;
    double utc_s = 0.0;
};

/// One answered question.
struct Answer {
    /// "rating" (single and parallel), "preference" (-2 clearly left .. 2 clearly right), "confidence",
    /// "reasons", "consent" (1, 0), or a questionnaire's Question::id.
    std::string question;
    int stimulus = -1;              ///< rating: which of the trial's; else -1
    std::optional<double> value{};  ///< a number, a scale's value; choice: the option's place from 0
    std::string text{};             ///< text; choice: the option's id; choices: ids, separated by ';'
};

enum class ResponseStatus : unsigned char {
    answered,
    timed_out,  ///< the time limit passed; there may be no answers
    skipped     ///< by the operator, with Response::reason; there are no answers
};
/// "answered", "timed_out", "skipped", as databases have it.
[[nodiscard]] std::string_view responseStatusName(ResponseStatus status);
/// Throws std::invalid_argument for any other name.
[[nodiscard]] ResponseStatus responseStatusNamed(std::string_view name);

/// An answered unit, complete: the store writes it in one transaction. Practice is kept in the same way,
/// marked by its trial.
struct Response {
    int trial_index = 0;
    ResponseStatus status = ResponseStatus::answered;
    std::vector<Answer> answers{};
    std::vector<KeptValue> values{};     ///< what its kind keeps beside, as it declares
    std::optional<bool> check_passed{};  ///< of an attention check
    Moment onset{};                ///< first frame of the last clip's last play, as shown; pages: when shown
    Moment motion_end{};           ///< last frame of that clip shown; selection opened here; pages: as onset
    Moment answered{};             ///< when select, or the key, went down
    double response_time_s = 0.0;  ///< answered - motion_end, less paused time
    double paused_s = 0.0;         ///< how long the session was paused while this answer was open
    int replays = 0;
    std::vector<int> plays{};  ///< by stimulus: how often its clip was shown to the end
    int pauses = 0;            ///< interruptions: during the clip, which then started over, or while choosing
    bool begun_before = false;     ///< its clip had been begun in an earlier session, which was interrupted
    std::string reason{};          ///< skipped: why
    std::string exclusion{};       ///< why the participant leaves the analysis with it; empty: does not
    std::string input;             ///< "ray", "key"; "" where nothing was answered
    Pose stage_from_head{};        ///< at the answer
    std::optional<Ray> pointer{};  ///< at the answer
    ViewerPlace viewer{};          ///< where the participant was asked to stand

    /// Of kinds with wrong answers; false if nothing was chosen.
    [[nodiscard]] bool correct() const { return keptNumber(values, "correct") == 1.0; }
    /// Of kinds with balls: which was chosen, by its place; -1: none.
    [[nodiscard]] int chosenPlace() const { return keptPlace(values, "chosen_place"); }
};

/// The operator has the last answered trial done again: its answer is kept, and marked.
struct Superseded {
    int trial_index = 0;
    std::string reason;
    Moment at{};
};

/// Reasons of an exclusion begin with one of these; after it stand the stage's name and, of a check, the
/// trial.
inline constexpr std::string_view check_failed_reason = "attention check failed: ";
inline constexpr std::string_view practice_failed_reason = "practice failed: ";

/// The participant's answers leave the analysis, for what an earlier session left (else Response::exclusion).
struct Exclusion {
    std::string reason;  ///< such as "practice failed: game-practice"
    Moment at{};
};

/// Anything else worth keeping.
struct Note {
    NoteKind kind = NoteKind::session_start;
    int trial_index = -1;  ///< of the trial under way; -1: none
    Moment at{};
    std::string detail{};
};

using SessionEvent = std::variant<Response, Superseded, Exclusion, Note>;

}  // namespace deixis::studies
