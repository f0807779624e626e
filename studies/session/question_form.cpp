#include "question_form.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis::studies {

namespace {

constexpr int longest_text = 500;
constexpr int longest_number = 12;

/// What a number may consist of; a decimal comma is a point.
std::string numberCharacters(const Question& question, const std::string& typed) {
    std::string kept;
    for (const char c : typed) {
        if (c >= '0' && c <= '9') kept += c;
        if (c == '-' && question.low < 0.0) kept += c;
        if ((c == '.' || c == ',') && !question.whole) kept += '.';
    }
    return kept;
}

}  // namespace

void editText(std::string& text, std::string_view typed, int erased, int longest) {
    auto characters = std::count_if(text.begin(), text.end(), std::not_fn(continuesCharacter));
    bool keeps = false;
    for (const char byte : typed) {
        if (!continuesCharacter(byte)) {
            keeps = static_cast<unsigned char>(byte) >= 0x20U && byte != 0x7F && characters < longest;
            if (keeps) ++characters;
        }
        if (keeps) text += byte;
    }
    for (; erased > 0 && !text.empty(); --erased) {
        while (continuesCharacter(text.back()) && text.size() > 1) text.pop_back();
        text.pop_back();
    }
}

std::optional<double> numberTyped(const Question& question, const std::string& typed) {
    if (typed.find_first_of("eE") != std::string::npos) return std::nullopt;  // no exponents
    const auto value = finiteNumber(typed);
    if (!value || *value < question.low || *value > question.high) return std::nullopt;
    if (question.whole && *value != std::floor(*value)) return std::nullopt;
    return value;
}

QuestionForm::QuestionForm(SessionCore& core, std::vector<const Question*> questions, FormSetting setting)
    : core_(core), setting_(std::move(setting)), questions_(std::move(questions)), given_(questions_.size()) {
    activateFirstField();
}

void QuestionForm::forget() {
    given_.assign(questions_.size(), {});
    activateFirstField();
}

void QuestionForm::activateFirstField() {
    active_ = -1;
    for (std::size_t i = 0; i < questions_.size() && active_ < 0 && core_.keyboard; ++i)
        if (typedAnswer(i)) active_ = static_cast<int>(i);
}

bool QuestionForm::typedAnswer(std::size_t i) const {
    return questions_[i]->kind == QuestionKind::number || questions_[i]->kind == QuestionKind::text;
}

bool QuestionForm::given(std::size_t i) const {
    switch (questions_[i]->kind) {
        case QuestionKind::scale:
            return given_[i].value.has_value();
        case QuestionKind::choice:
        case QuestionKind::choices:
            return !given_[i].chosen.empty();
        case QuestionKind::number:
        case QuestionKind::text:
            return given_[i].typed.find_first_not_of(' ') != std::string::npos;
    }
    return false;
}

std::string QuestionForm::missing() const {
    for (std::size_t i = 0; i < questions_.size(); ++i) {
        const Question& question = *questions_[i];
        if (question.required && !given(i))
            return core_.words()(questions_.size() > 1 ? "answer_all" : "answer_one");
        if (question.kind == QuestionKind::number && given(i) && !numberTyped(question, given_[i].typed))
            return core_.words()("answer_number", {{"low", fmt::format("{}", question.low)},
                                                   {"high", fmt::format("{}", question.high)}});
    }
    return {};
}

Panel QuestionForm::board() const {
    QuestionnaireBoard board;
    board.title = setting_.title;
    board.text = setting_.text;
    board.questions = questions_;
    board.answers = given_;
    board.active_field = active_;
    board.keyboard = core_.keyboard;
    board.missing = missing();
    board.buttons = {{core_.words()("continue"), button_id::go_on, ButtonRole::go_on, board.missing.empty()}};
    board.page = setting_.page;
    board.pages = setting_.pages;
    board.progress = core_.share_done;
    return questionnairePanel(board, core_.words());
}

void QuestionForm::open(const InputFrame& input) {
    core_.openPanel(board(), input, messagePose);
    core_.view.aim(input.pointer, input.stage_from_head, false);
}

std::optional<QuestionForm::Left> QuestionForm::step(const InputFrame& input) {
    const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
    bool changed = type(input);  // the caret is there from the first frame: nothing typed is lost
    if (!core_.settled()) {
        if (changed) core_.view.updatePanel(board());
        return std::nullopt;
    }
    if (const auto set = core_.view.drag(input, met, input.select)) {
        auto& value = given_[static_cast<std::size_t>(set->id - button_id::first_field)].value;
        changed = changed || value != set->value;
        value = set->value;
    }
    if (input.select && met.field != 0) {
        active_ = met.field - button_id::first_field;
        changed = true;
    }
    if (input.select && press(met.button)) changed = true;
    if (changed) core_.view.updatePanel(board());
    const bool pressed = input.select && met.button == button_id::go_on;
    if ((!pressed && !input.confirm) || !missing().empty()) return std::nullopt;
    return pressed ? Left{selectTime(input), "ray"} : Left{keyTime(input), "key"};
}

bool QuestionForm::type(const InputFrame& input) {
    if (active_ < 0 || !core_.keyboard || (input.typed.empty() && input.erased == 0)) return false;
    const auto i = static_cast<std::size_t>(active_);
    const bool number = questions_[i]->kind == QuestionKind::number;
    editText(given_[i].typed, number ? numberCharacters(*questions_[i], input.typed) : input.typed,
             input.erased, number ? longest_number : longest_text);
    return true;
}

bool QuestionForm::press(int button) {
    if (button < button_id::first_option || button >= button_id::first_field) return false;
    const auto i = static_cast<std::size_t>((button - button_id::first_option) / 100);
    const int place = (button - button_id::first_option) % 100;
    if (i >= questions_.size()) return false;
    AnswerView& given = given_[i];
    switch (questions_[i]->kind) {
        case QuestionKind::scale:
            given.value = questions_[i]->scale.low + place;
            return true;
        case QuestionKind::choice:
            given.chosen = {place};
            return true;
        case QuestionKind::choices: {
            const auto found = std::find(given.chosen.begin(), given.chosen.end(), place);
            if (found != given.chosen.end())
                given.chosen.erase(found);
            else
                given.chosen.insert(std::upper_bound(given.chosen.begin(), given.chosen.end(), place), place);
            return true;
        }
        case QuestionKind::number:
            return pressPad(i, place);
        case QuestionKind::text:
            return false;
    }
    return false;
}

bool QuestionForm::pressPad(std::size_t i, int key) {
    std::string typed;
    if (key >= pad_key::zero && key <= pad_key::zero + 9)
        typed = std::to_string(key - pad_key::zero);
    else if (key == pad_key::point)
        typed = ".";
    else if (key == pad_key::minus)
        typed = "-";
    editText(given_[i].typed, numberCharacters(*questions_[i], typed), key == pad_key::erase ? 1 : 0,
             longest_number);
    return true;
}

std::vector<Answer> QuestionForm::answers() const {
    std::vector<Answer> answers;
    for (std::size_t i = 0; i < questions_.size(); ++i) {
        if (!given(i)) continue;
        const Question& question = *questions_[i];
        const AnswerView& given = given_[i];
        Answer answer;
        answer.question = question.id;
        const auto option = [&question](int place) {
            return question.options.at(static_cast<std::size_t>(place)).id;
        };
        switch (question.kind) {
            case QuestionKind::scale:
                answer.value = *given.value;
                break;
            case QuestionKind::choice:
                answer.value = given.chosen.front();
                answer.text = option(given.chosen.front());
                break;
            case QuestionKind::choices:
                for (const int place : given.chosen)
                    answer.text += (answer.text.empty() ? "" : ";") + option(place);
                break;
            case QuestionKind::number:
                answer.value = numberTyped(question, given.typed);
                break;
            case QuestionKind::text:
                answer.text = given.typed;
                break;
        }
        answers.push_back(std::move(answer));
    }
    return answers;
}

}  // namespace deixis::studies
