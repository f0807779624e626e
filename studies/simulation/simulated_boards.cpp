#include "simulated_boards.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/number.hpp"
#include "core/text.hpp"
#include "studies/boards/panel_layout.hpp"
#include "studies/session/session.hpp"

namespace deixis::studies {

namespace {

constexpr int ids_a_question = 100;

bool isOneOf(int id, int first) {
    return id >= first && id < first + ids_a_question;
}

/// Which question of a page, or movement, a button belongs to; none: it answers nothing.
std::optional<std::size_t> questionOf(const PanelButton& button) {
    if (button.id < button_id::first_option || button.id >= button_id::first_field) return std::nullopt;
    return static_cast<std::size_t>((button.id - button_id::first_option) / ids_a_question);
}

Ask& askOf(std::vector<Ask>& asks, AskKind kind, std::size_t number, bool of_movement, int id) {
    for (Ask& ask : asks)
        if (ask.kind == kind && ask.number == number && ask.of_movement == of_movement) return ask;
    Ask& made = asks.emplace_back();
    made.kind = kind;
    made.id = id;
    made.number = number;
    made.of_movement = of_movement;
    return made;
}

std::vector<double> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!isDigit(text[i])) continue;
        // A hyphen right after a number parts the two.
        const bool negative = i > 0 && text[i - 1] == '-' && (i == 1 || !isDigit(text[i - 2]));
        const auto digitsFrom = [&](std::size_t at) {
            return std::min(text.find_first_not_of("0123456789", at), text.size());
        };
        std::size_t stop = digitsFrom(i);
        if (stop + 1 < text.size() && text[stop] == '.') stop = digitsFrom(stop + 1);
        const double number = finiteNumber(text.substr(i, stop - i)).value();
        numbers.push_back(negative ? -number : number);
        i = stop;
    }
    return numbers;
}

bool asksForNumber(const PanelField& field) {
    return numbersIn(field.hint).size() >= 2;
}

void readButtons(const Panel& panel, BoardReading& read) {
    for (const PanelButton& button : panel.buttons) {
        if (button.role == ButtonRole::go_on && button.enabled) read.go_on = &button;
        if (button.role == ButtonRole::play && isOneOf(button.id, button_id::first_play))
            read.plays.push_back(&button);
        if (button.role != ButtonRole::option) continue;
        const auto question = questionOf(button);
        Ask& ask = askOf(read.asks, AskKind::options, question.value_or(0), !question, button.id);
        ask.enabled = ask.enabled || button.enabled;
        ask.buttons.push_back(&button);
    }
    // As their ratings are numbered, in whatever order they were laid out.
    std::sort(read.plays.begin(), read.plays.end(),
              [](const PanelButton* a, const PanelButton* b) { return a->id < b->id; });
}

void readSliders(const Panel& panel, BoardReading& read) {
    for (const PanelSlider& slider : panel.sliders) {
        const bool of_movement = isOneOf(slider.id, button_id::first_slider);
        const int first = of_movement ? button_id::first_slider : button_id::first_field;
        Ask& ask = askOf(read.asks, AskKind::slider, static_cast<std::size_t>(slider.id - first), of_movement,
                         slider.id);
        ask.enabled = slider.enabled;
        ask.slider = &slider;
    }
}

void readFields(const Panel& panel, BoardReading& read) {
    for (const PanelField& field : panel.fields) {
        const auto number = static_cast<std::size_t>(field.id - button_id::first_field);
        Ask& ask =
            askOf(read.asks, asksForNumber(field) ? AskKind::number : AskKind::text, number, false, field.id);
        ask.enabled = field.enabled;
        ask.field = &field;
        for (const PanelButton& button : panel.buttons)
            if (button.role != ButtonRole::option && questionOf(button) == number) {
                ask.enabled = ask.enabled || button.enabled;
                ask.buttons.push_back(&button);
            }
    }
}

}  // namespace

bool BoardReading::open() const {
    return std::any_of(asks.begin(), asks.end(), [](const Ask& ask) { return ask.enabled; });
}

bool BoardReading::playing() const {
    return std::any_of(plays.begin(), plays.end(),
                       [](const PanelButton* play) { return !play->enabled || play->chosen; });
}

BoardReading readBoard(const Panel& panel) {
    BoardReading read;
    readButtons(panel, read);
    readSliders(panel, read);
    readFields(panel, read);
    for (const PanelButton& button : panel.buttons) read.parts.push_back(button.id);
    for (const PanelSlider& slider : panel.sliders) read.parts.push_back(slider.id);
    for (const PanelField& field : panel.fields) read.parts.push_back(field.id);
    // Where movements are rated step by step, the steps are numbered as a page's questions are.
    if (!read.plays.empty())
        for (Ask& ask : read.asks) ask.of_movement = true;
    return read;
}

std::optional<int> numberOn(const PanelButton& option) {
    const auto number = wholeNumber(option.label);
    return number ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
}

bool isNumbered(const std::vector<const PanelButton*>& options) {
    return std::all_of(options.begin(), options.end(),
                       [](const PanelButton* option) { return numberOn(*option).has_value(); });
}

bool isScale(const std::vector<const PanelButton*>& options) {
    if (isNumbered(options)) return true;
    const auto alike = [&options](const PanelButton* option) {
        return std::abs(option->box.width - options.front()->box.width) < 1e-6;
    };
    return options.size() > 2 && std::all_of(options.begin(), options.end(), alike);
}

void DecidedAnswers::forget() {
    values.clear();
    texts.clear();
}

bool DecidedAnswers::done(const Ask& ask) const {
    switch (ask.kind) {
        case AskKind::options:
            return std::any_of(ask.buttons.begin(), ask.buttons.end(),
                               [](const PanelButton* option) { return option->chosen; });
        case AskKind::slider: {
            const auto wanted = values.find(ask.id);
            return ask.slider->value && (wanted == values.end() || *ask.slider->value == wanted->second);
        }
        case AskKind::number: {
            const auto wanted = texts.find(ask.id);
            return wanted == texts.end() ? !ask.field->text.empty() : ask.field->text == wanted->second;
        }
        case AskKind::text:
            return !ask.field->text.empty();
    }
    return true;
}

std::string numberFor(const PanelField& field, double share) {
    const std::vector<double> numbers = numbersIn(field.hint);
    const auto [low, high] = std::minmax(numbers.at(0), numbers.at(1));
    const double value = low + std::clamp(share, 0.0, 1.0) * (high - low);
    if (std::ceil(low) > std::floor(high)) return fmt::format("{:.6g}", value);
    return fmt::format("{:.0f}", std::clamp(std::floor(value + 0.5), std::ceil(low), std::floor(high)));
}

const PanelButton* nextKey(const Ask& ask, const std::string& wanted) {
    const std::string& typed = ask.field->text;
    int key = pad_key::erase;
    if (wanted.compare(0, typed.size(), typed) == 0 && typed.size() < wanted.size()) {
        const char next = wanted[typed.size()];
        key = next == '.' ? pad_key::point : next == '-' ? pad_key::minus : pad_key::zero + (next - '0');
    }
    for (const PanelButton* button : ask.buttons)
        if (button->enabled && (button->id - button_id::first_option) % ids_a_question == key) return button;
    return nullptr;
}

}  // namespace deixis::studies
