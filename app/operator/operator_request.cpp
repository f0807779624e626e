#include "app/operator/operator_request.hpp"

#include <iterator>
#include <utility>

#include "core/text.hpp"

namespace deixis::app {

namespace {

constexpr double answer_within_s = 4.0;
constexpr double double_click_s = 0.4;

// Without the blanks at its ends.
std::string trimmed(const OperatorControls::Text& text) {
    return std::string(deixis::trimmed(text.data()));
}

}  // namespace

void OperatorRequest::add(OperatorRequest later) {
    pause = (pause && !later.resume) || later.pause;
    resume = (resume && !later.pause) || later.resume;
    recentre = recentre || later.recentre;
    end = end || later.end;
    saw_trial = saw_trial || later.saw_trial;
    commands.insert(commands.end(), std::make_move_iterator(later.commands.begin()),
                    std::make_move_iterator(later.commands.end()));
}

void OperatorRequest::putInto(studies::InputFrame& input) const {
    if (pause) {
        input.pause = true;
        input.pause_reason = studies::PauseReason::experimenter;
    }
    input.resume = input.resume || resume;
    input.commands.insert(input.commands.end(), commands.begin(), commands.end());
    if (saw_trial)
        input.notes.push_back(
            {studies::NoteKind::operator_saw_trial, "", input.input_time_s.value_or(input.time_s)});
    if (!end || input.quit) return;
    input.quit = true;
    input.quit_reason = "ended by the experimenter";
}

bool AskTwice::ask(double now_s) {
    if (!left(now_s)) {
        asked_s_ = now_s;
        return false;
    }
    if (now_s - *asked_s_ < double_click_s) return false;
    asked_s_.reset();
    return true;
}

std::optional<double> AskTwice::left(double now_s) const {
    if (!asked_s_ || now_s - *asked_s_ > answer_within_s) return std::nullopt;
    return 1.0 - (now_s - *asked_s_) / answer_within_s;
}

void OperatorControls::command(studies::OperatorAction action, std::string text) {
    asked_.commands.push_back({action, std::move(text)});
}

void OperatorControls::repeatLast(double now_s) {
    if (repeat_.ask(now_s)) command(studies::OperatorAction::repeat_last, "");
}

void OperatorControls::end(double now_s) {
    if (end_.ask(now_s)) asked_.end = true;
}

void OperatorControls::ask(Question question) {
    question_ = question;
    reason_ = {};
    abort_.forget();
}

void OperatorControls::leaveQuestion() {
    ask(Question::none);
}

bool OperatorControls::answered() const {
    return !trimmed(reason_).empty();
}

void OperatorControls::answer(double now_s) {
    if (question_ == Question::none || !answered()) return;
    if (question_ == Question::abort && !abort_.ask(now_s)) return;
    command(question_ == Question::skip ? studies::OperatorAction::skip : studies::OperatorAction::abort,
            trimmed(reason_));
    leaveQuestion();
}

void OperatorControls::addNote() {
    std::string text = trimmed(note_);
    note_ = {};
    if (!text.empty()) command(studies::OperatorAction::note, std::move(text));
}

void OperatorControls::showTrial(bool shown) {
    if (shown && !trial_shown_) asked_.saw_trial = true;
    trial_shown_ = shown;
}

OperatorRequest OperatorControls::take() {
    return std::exchange(asked_, {});
}

}  // namespace deixis::app
