#include <algorithm>

#include "panel_build.hpp"
#include "studies/boards/button_ids.hpp"
#include "studies/boards/panel_layout.hpp"

namespace deixis::studies {

namespace {

constexpr double question_gap_m = 0.035;
constexpr double part_gap_m = 0.015;  // between a question and its answer under it
constexpr double beside_m = 0.82;     // of the answer where it stands beside the question
constexpr double field_width_m = 0.5;
constexpr double pad_key_m = 0.11;
constexpr double pad_gap_m = 0.012;

struct Item {
    const Question& question;
    const AnswerView& answer;
    int place = 0;  ///< on the page
    bool active = false;
    bool keyboard = true;

    [[nodiscard]] int firstOption() const { return button_id::first_option + 100 * place; }
    [[nodiscard]] bool chosen(int option) const {
        return std::find(answer.chosen.begin(), answer.chosen.end(), option) != answer.chosen.end();
    }
};

panel::ScalePart scaleOf(const Item& item) {
    return {item.question.scale,
            item.firstOption(),
            button_id::first_field + item.place,
            item.answer.value,
            true,
            true,
            true,
            panel::low_button_height_m};
}

/// Few steps, or a slider with few labels, stand beside the question.
bool standsBeside(const Question& question) {
    const Scale& scale = question.scale;
    if (scale.kind == ScaleKind::slider) return scale.labels.size() <= 3;
    if (scale.steps() > 5) return false;
    const double step_m = (beside_m - (scale.steps() - 1) * panel::button_gap_m) / scale.steps();
    return scale.labels.size() <= 2 ||
           std::all_of(scale.labels.begin(), scale.labels.end(),
                       [&](const std::string& label) { return panel::fitsAsLabel(label, step_m); });
}

/// Of a text beside a button, level with it.
panel::TextStyle besideButton(bool bold) {
    panel::TextStyle style{panel::item_size_m, bold};
    style.min_height_m = panel::low_button_height_m;
    return style;
}

double addScale(panel::Builder& board, const Item& item, double top) {
    if (!standsBeside(item.question)) {
        const double text_m =
            board.text(item.question.text, panel::margin_m, top, board.inner(), {panel::item_size_m, true});
        const double scale_top = top - text_m - part_gap_m;
        return text_m + part_gap_m + board.scale(scaleOf(item), panel::margin_m, scale_top, board.inner());
    }
    const double text_m = board.text(item.question.text, panel::margin_m, top,
                                     board.inner() - beside_m - panel::gap_m, besideButton(true));
    const double scale_m =
        board.scale(scaleOf(item), panel::margin_m + board.inner() - beside_m, top, beside_m);
    return std::max(text_m, scale_m);
}

/// The options in rows; one too long for a button stands beside a lettered one.
double addOptions(panel::Builder& board, const Item& item, double top) {
    double used_m = 0.0;
    std::vector<ButtonSpec> row;
    const auto flush = [&] {
        if (row.empty()) return;
        const std::size_t first = board.made().buttons.size();
        used_m += board.buttons(row, panel::margin_m, top - used_m, board.inner(), panel::low_button_height_m,
                                false);
        for (std::size_t i = first; i < board.made().buttons.size(); ++i) {
            PanelButton& made = board.made().buttons[i];
            made.chosen = item.chosen(made.id - item.firstOption());
        }
        row.clear();
    };
    for (std::size_t i = 0; i < item.question.options.size(); ++i) {
        const std::string& words = item.question.options[i].text;
        const int option = static_cast<int>(i);
        if (panel::fitsAsLabel(words, board.inner())) {
            row.push_back({words, item.firstOption() + option, ButtonRole::option});
            continue;
        }
        flush();
        if (used_m > 0.0) used_m += panel::button_gap_m;
        constexpr double letter_m = 0.13;
        const double at = top - used_m;
        board.button({std::string(1, static_cast<char>('A' + option % 26)), item.firstOption() + option,
                      ButtonRole::option},
                     panel::margin_m, at, letter_m, panel::low_button_height_m);
        board.lastButton().chosen = item.chosen(option);
        used_m += board.text(words, panel::margin_m + letter_m + panel::gap_m, at,
                             board.inner() - letter_m - panel::gap_m, besideButton(false));
        if (i + 1 < item.question.options.size()) used_m += panel::button_gap_m;
    }
    flush();
    return used_m;
}

void addField(panel::Builder& board, const Item& item, const PanelRect& box, const std::string& hint) {
    PanelField field;
    field.box = box;
    field.id = button_id::first_field + item.place;
    field.text = item.answer.typed;
    field.hint = hint;
    field.active = item.active;
    field.enabled = item.keyboard;
    board.made().fields.push_back(std::move(field));
}

std::string plainNumber(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

double padWidth(const LanguageTable& words) {
    return 5.0 * (pad_key_m + pad_gap_m) + panel::buttonWidth(words("erase"));
}

/// Two rows of keys: the digits, and at their right what else there is.
double addPad(panel::Builder& board, const Item& item, double left, double top, const LanguageTable& words) {
    constexpr double key_m = pad_key_m;
    const double erase_m = panel::buttonWidth(words("erase"));
    for (int row = 0; row < 2; ++row) {
        const double at = top - row * (key_m + pad_gap_m);
        for (int column = 0; column < 5; ++column) {
            const int digit = (5 * row + column + 1) % 10;
            board.button({std::to_string(digit), item.firstOption() + pad_key::zero + digit},
                         left + column * (key_m + pad_gap_m), at, key_m, key_m);
        }
    }
    const double x = left + 5.0 * (key_m + pad_gap_m);
    board.button({words("erase"), item.firstOption() + pad_key::erase}, x, top, erase_m, key_m);
    const double half_m = (erase_m - pad_gap_m) / 2.0;
    const double below = top - key_m - pad_gap_m;
    if (!item.question.whole)
        board.button({".", item.firstOption() + pad_key::point}, x, below, half_m, key_m);
    if (item.question.low < 0.0)
        board.button({"-", item.firstOption() + pad_key::minus}, x + half_m + pad_gap_m, below, half_m,
                     key_m);
    return 2.0 * key_m + pad_gap_m;
}

double addNumber(panel::Builder& board, const Item& item, double top, const LanguageTable& words) {
    const std::string hint = words(
        "number_hint", {{"low", plainNumber(item.question.low)}, {"high", plainNumber(item.question.high)}});
    const double right = panel::margin_m + board.inner();
    const double answer_m = item.keyboard ? field_width_m : padWidth(words);
    const double text_width_m = board.inner() - answer_m - panel::gap_m;
    const double text_m =
        board.text(item.question.text, panel::margin_m, top, text_width_m,
                   item.keyboard ? besideButton(true) : panel::TextStyle{panel::item_size_m, true});
    if (item.keyboard) {
        addField(board, item,
                 {right - field_width_m, top - panel::low_button_height_m, field_width_m,
                  panel::low_button_height_m},
                 hint);
        return std::max(text_m, panel::low_button_height_m);
    }
    const double pad_m = addPad(board, item, right - answer_m, top, words);
    const double field_top = top - text_m - part_gap_m;
    addField(
        board, item,
        {panel::margin_m, field_top - panel::low_button_height_m, text_width_m, panel::low_button_height_m},
        hint);
    return std::max(text_m + part_gap_m + panel::low_button_height_m, pad_m);
}

double addQuestion(panel::Builder& board, const Item& item, const LanguageTable& words) {
    const double top = board.top();
    if (item.question.kind == QuestionKind::scale) return addScale(board, item, top);
    if (item.question.kind == QuestionKind::number) return addNumber(board, item, top, words);
    double used_m =
        board.text(item.question.text, panel::margin_m, top, board.inner(), {panel::item_size_m, true});
    if (item.question.kind == QuestionKind::choices)
        used_m += board.text(words("choices_hint"), panel::margin_m, top - used_m, board.inner(),
                             {panel::label_size_m, false, false, true});
    used_m += part_gap_m;
    if (item.question.kind != QuestionKind::text) return used_m + addOptions(board, item, top - used_m);
    addField(board, item,
             {panel::margin_m, top - used_m - panel::low_button_height_m, board.inner(),
              panel::low_button_height_m},
             words("text_hint"));
    return used_m + panel::low_button_height_m;
}

/// What is missing and the page at the left, the buttons at the right.
void addFoot(panel::Builder& board, const QuestionnaireBoard& content, const LanguageTable& words) {
    double buttons_m = -panel::button_gap_m;
    for (const ButtonSpec& spec : content.buttons)
        buttons_m += panel::buttonWidth(spec.label, spec.role) + panel::button_gap_m;
    const bool beside = buttons_m <= 0.6 * board.inner();
    const double text_m = beside ? board.inner() - std::max(0.0, buttons_m) - panel::gap_m : board.inner();
    const panel::TextStyle faint{panel::label_size_m, false, false, true};
    double used_m = board.text(content.missing, panel::margin_m, board.top(), text_m, {panel::item_size_m});
    if (content.pages > 1)
        used_m += board.text(words("page_of", {{"page", std::to_string(content.page + 1)},
                                               {"pages", std::to_string(content.pages)}}),
                             panel::margin_m, board.top() - used_m, text_m, faint);
    if (!beside && used_m > 0.0) board.advance(used_m, part_gap_m);
    if (beside)
        board.buttons(content.buttons, panel::margin_m + board.inner() - buttons_m, board.top(),
                      buttons_m + 1e-6, panel::button_height_m, false);
    else
        board.buttons(content.buttons, panel::margin_m, board.top(), board.inner(), panel::button_height_m,
                      true);
}

}  // namespace

Panel questionnairePanel(const QuestionnaireBoard& content, const LanguageTable& words) {
    static const AnswerView unanswered;
    panel::Builder board(panel::wide_m);
    board.paragraph(content.title, {panel::title_size_m, true});
    board.paragraph(content.text, {panel::item_size_m});
    for (std::size_t i = 0; i < content.questions.size(); ++i) {
        const int place = static_cast<int>(i);
        const Item item{*content.questions[i], i < content.answers.size() ? content.answers[i] : unanswered,
                        place, content.active_field == place, content.keyboard};
        board.advance(addQuestion(board, item, words), question_gap_m);
    }
    addFoot(board, content, words);
    return board.finish(content.progress);
}

std::vector<std::vector<const Question*>> questionnairePages(const Questionnaire& questionnaire,
                                                             bool keyboard, const LanguageTable& words) {
    std::vector<std::vector<const Question*>> pages;
    QuestionnaireBoard board;
    board.title = questionnaire.title;
    board.text = questionnaire.text;
    board.keyboard = keyboard;
    board.buttons = {{words("continue")}};
    board.missing = words("answer_all");
    board.pages = 2;
    for (const Question& question : questionnaire.questions) {
        if (question.kind == QuestionKind::text && !keyboard) continue;
        board.questions.push_back(&question);
        const bool full = static_cast<int>(board.questions.size()) > questionnaire.per_page ||
                          questionnairePanel(board, words).height_m > panel::highest_m;
        if (full && board.questions.size() > 1) {
            board.questions.pop_back();
            pages.push_back(board.questions);
            board.questions = {&question};
            board.title.clear();
            board.text.clear();
        }
    }
    if (!board.questions.empty()) pages.push_back(board.questions);
    return pages;
}

}  // namespace deixis::studies
