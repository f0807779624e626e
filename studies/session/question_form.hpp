// Questions on a board, answered by ray or keyboard: a page of a questionnaire, or the reasons of a
// preference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session_core.hpp"

namespace deixis::studies {

/// How the form stands on the board.
struct FormSetting {
    std::string title{};
    std::string text{};
    int page = 0;
    int pages = 1;
};

class QuestionForm {
  public:
    /// When the page was left, and by what.
    struct Left {
        double at_s = 0.0;
        const char* by = "";
    };

    /// Questions must outlive the form.
    QuestionForm(SessionCore& core, std::vector<const Question*> questions, FormSetting setting);

    void open(const InputFrame& input);  ///< also after a pause: what was entered stays,
    void forget();                       ///< until it is forgotten
    [[nodiscard]] std::optional<Left> step(const InputFrame& input);
    /// Those given, in the questions' order; only once it was left they are complete.
    [[nodiscard]] std::vector<Answer> answers() const;

  private:
    SessionCore& core_;
    FormSetting setting_;
    std::vector<const Question*> questions_;
    std::vector<AnswerView> given_;
    int active_ = -1;  ///< the question whose field takes what is typed

    void activateFirstField();
    [[nodiscard]] bool typedAnswer(std::size_t i) const;
    [[nodiscard]] bool given(std::size_t i) const;
    [[nodiscard]] std::string missing() const;  ///< what keeps the page from being left; empty: nothing
    [[nodiscard]] Panel board() const;
    bool type(const InputFrame& input);
    bool press(int button);
    bool pressPad(std::size_t i, int key);
};

/// The number that was typed, if it is one that the question takes.
[[nodiscard]] std::optional<double> numberTyped(const Question& question, const std::string& typed);

/// Adds what was typed, then takes `erased` characters (not bytes) off its end. Control characters, and what
/// would make it longer than `longest` characters, are left out.
void editText(std::string& text, std::string_view typed, int erased, int longest);

}  // namespace deixis::studies
