// What the operator's panel says, in words, and the question asked twice: plain logic.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace deixis::app {

/// A session's status line, taken apart: "game 12/40, paused: focus lost".
struct StudyProgress {
    std::string stage;   ///< "Game"
    int trial = 0;       ///< 12: the trial under way; 0 where the status counts none
    int trials = 0;      ///< 40; 0 likewise
    std::string remark;  ///< "Paused: focus lost"; empty: none

    /// How much lies behind: the trial under way does not. None where nothing is counted.
    [[nodiscard]] std::optional<double> done() const;
};

[[nodiscard]] StudyProgress studyProgress(std::string_view status);

/// PresentedFrame::state for somebody who knows the study but not the program: "aiming-side-by-side" ->
/// "Aims at a ball (side-by-side)". An unknown state comes back as it is.
[[nodiscard]] std::string stateInWords(std::string_view state);

struct HeadsetWords {
    std::string words;
    bool in_use = false;  ///< the person sees the pictures and can answer
};

/// The name of an OpenXR session state, or the station's own words, which come back as they are.
[[nodiscard]] HeadsetWords headsetInWords(std::string_view state);

/// "12 cm", "1.40 m"; whole centimetres below a metre.
[[nodiscard]] std::string distanceInWords(double metres);

/// "4:07", "1:02:30".
[[nodiscard]] std::string elapsedInWords(double seconds);

/// Something that is done only when it was asked for twice. The second time counts within 4 s, and not within
/// the first 0.4 s: a double click asks once.
class AskTwice {
  public:
    /// True: asked for the second time. Times are of one clock, seconds.
    bool ask(double now_s);
    /// How much of the time for the second asking is left, 0..1; none: not asked.
    [[nodiscard]] std::optional<double> left(double now_s) const;

  private:
    std::optional<double> asked_s_;
};

}  // namespace deixis::app
