// How a simulated participant reads a board: what it asks for, and what of it is still to be done.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/station/station.hpp"

namespace deixis::studies {

enum class AskKind : unsigned char {
    options,  ///< one of several buttons
    slider,
    number,  ///< a field that says from where to where
    text     ///< a field for words
};

/// One thing that a board asks for.
struct Ask {
    AskKind kind = AskKind::options;
    int id = 0;  ///< of the slider or field, or of the first button
    /// Which of the board's questions or movements it belongs to, from 0.
    std::size_t number = 0;
    bool of_movement = true;  ///< a rating, a preference, or a confidence; false: a question of a page
    bool enabled = false;
    /// Options, in their order. Fields: the keys of the pad that stands in for a keyboard, if there is one.
    std::vector<const PanelButton*> buttons{};
    const PanelSlider* slider = nullptr;
    const PanelField* field = nullptr;
};

/// A board as it is read; points into the panel.
struct BoardReading {
    std::vector<Ask> asks;
    std::vector<const PanelButton*> plays;  ///< of movements shown on demand, in their order
    const PanelButton* go_on = nullptr;     ///< where it can be pressed
    std::vector<int> parts;                 ///< ids of all that stands on it: another board has others

    /// Whether an answer can be given to anything.
    [[nodiscard]] bool open() const;
    /// Whether a movement is being shown: none can be asked for then.
    [[nodiscard]] bool playing() const;
    /// Whether two movements are compared, by one answer.
    [[nodiscard]] bool pair() const {
        return plays.size() == 2 && asks.size() == 1 && asks.front().kind == AskKind::options;
    }
};
[[nodiscard]] BoardReading readBoard(const Panel& panel);

/// The number on an option of a scale; none: it has words.
[[nodiscard]] std::optional<int> numberOn(const PanelButton& option);
[[nodiscard]] bool isNumbered(const std::vector<const PanelButton*>& options);
/// Whether they look like the steps of a scale: numbered, or several of one width.
[[nodiscard]] bool isScale(const std::vector<const PanelButton*>& options);

/// The answers decided on for one board, so that what is not there yet is given as it was meant.
class DecidedAnswers {
  public:
    void forget();
    /// By id of the ask.
    std::map<int, int> values{};         ///< place among the options, or value of the slider
    std::map<int, std::string> texts{};  ///< what is typed

    [[nodiscard]] bool done(const Ask& ask) const;
};

/// A number for a field that says from where to where: `share` of the way, whole where there is a whole one.
[[nodiscard]] std::string numberFor(const PanelField& field, double share);

/// The pad's key that is to be pressed next so that the field comes to say `wanted`; null: there is none.
[[nodiscard]] const PanelButton* nextKey(const Ask& ask, const std::string& wanted);

}  // namespace deixis::studies
