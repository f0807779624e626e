// Answers on a scale, and questions of any kind: what ratings, game confidence and questionnaires share.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace deixis::studies {

enum class ScaleKind : unsigned char {
    steps,  ///< one button for each whole number from low to high
    slider  ///< a track from low to high, in whole numbers; no value until it is touched
};

struct Scale {
    ScaleKind kind = ScaleKind::steps;
    int low = 1;
    int high = 5;
    /// Steps: one for each step, or two for the ends, or none. Slider: at least two, spread evenly, or none.
    std::vector<std::string> labels{};

    [[nodiscard]] int steps() const { return high - low + 1; }
};

enum class QuestionKind : unsigned char {
    scale,    ///< Question::scale
    choice,   ///< exactly one option
    choices,  ///< any number of options
    number,   ///< a number within low..high, typed or stepped
    text      ///< a few words; only where there is a keyboard, left out elsewhere
};

struct QuestionOption {
    std::string id;    ///< kept in the record
    std::string text;  ///< what the participant reads
};

/// What an answer on a scale says of a system as a whole: it counts as a rating of it.
struct SystemRated {
    std::string measure;  ///< its name in tables and report
    std::string system;   ///< of [[systems]]
};

struct Question {
    std::string id;  ///< unique within its questionnaire; kept in the record
    QuestionKind kind = QuestionKind::scale;
    std::string text;
    Scale scale{};
    std::vector<QuestionOption> options{};
    double low = 0.0;
    double high = 100.0;
    bool whole = true;                   ///< numbers only: no fractions
    bool required = true;                ///< a page is left only when its required questions are answered
    std::optional<SystemRated> rates{};  ///< scale
};

}  // namespace deixis::studies
