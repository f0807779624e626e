// What the experimenter requests, and which requests need confirmation: plain logic.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "studies/station/station.hpp"

namespace deixis::app {

struct OperatorRequest {
    bool pause = false;
    bool resume = false;
    bool recentre = false;
    bool end = false;
    bool saw_trial = false;  ///< the conditions of the trial under way are shown from now on
    std::vector<studies::OperatorCommand> commands{};

    /// Joins what was asked later.
    void add(OperatorRequest later);
    /// Tells the session all but recentring, which is the station's. A pause takes precedence over one for
    /// another reason, an end that the input tells already over this one.
    void putInto(studies::InputFrame& input) const;
};

/// Something that is done only when it was asked for twice. The second time counts within 4 s, and not within
/// the first 0.4 s: a double click asks once.
class AskTwice {
  public:
    /// True: asked for the second time. Times are of one clock, seconds.
    bool ask(double now_s);
    void forget() { asked_s_.reset(); }
    /// How much of the time for the second asking is left, 0..1; none: not asked.
    [[nodiscard]] std::optional<double> left(double now_s) const;

  private:
    std::optional<double> asked_s_;
};

/// The buttons and fields of the operator's panel, without how they look. Times are of one clock, seconds.
class OperatorControls {
  public:
    enum class Question : unsigned char { none, skip, abort };
    using Text = std::array<char, 500>;  ///< UTF-8, ends with a zero

    void pause() { asked_.pause = true; }
    void resume() { asked_.resume = true; }
    void recentre() { asked_.recentre = true; }
    void repeatLast(double now_s);  ///< asked twice
    void end(double now_s);         ///< asked twice

    /// Asks for the reason of skipping or aborting.
    void ask(Question question);
    void leaveQuestion();
    [[nodiscard]] Question question() const { return question_; }
    /// Whether the reason is there: more than blanks.
    [[nodiscard]] bool answered() const;
    /// Goes ahead with the reason: skips, or asks once more, then aborts. Without a reason nothing happens.
    void answer(double now_s);

    /// Keeps the remark, where there is one, and empties its field.
    void addNote();
    void showTrial(bool shown);
    [[nodiscard]] bool trialShown() const { return trial_shown_; }

    [[nodiscard]] std::optional<double> repeatLeft(double now_s) const { return repeat_.left(now_s); }
    [[nodiscard]] std::optional<double> endLeft(double now_s) const { return end_.left(now_s); }
    [[nodiscard]] std::optional<double> abortLeft(double now_s) const { return abort_.left(now_s); }

    [[nodiscard]] Text& reason() { return reason_; }
    [[nodiscard]] Text& note() { return note_; }
    /// Whether a field takes what is typed: keys mean letters then.
    void setTyping(bool typing) { typing_ = typing; }
    [[nodiscard]] bool typing() const { return typing_; }

    /// What was asked since the last call.
    [[nodiscard]] OperatorRequest take();

  private:
    void command(studies::OperatorAction action, std::string text);

    OperatorRequest asked_;
    AskTwice repeat_, end_, abort_;
    Question question_ = Question::none;
    Text reason_{}, note_{};
    bool trial_shown_ = false;
    bool typing_ = false;
};

}  // namespace deixis::app
