// Rules from words to unit gestures: a table that a rule set, or a person, can change.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/unit_gestures/unit_gesture.hpp"

namespace deixis::motion {

/// Words of small letters; one that ends in * stands for every word that begins so. Gestures are ids of a
/// library; one that begins with ~ is made by the other hand, to the other side.
struct WordRule {
    std::vector<std::string> words;
    std::vector<std::string> gestures;  ///< of which one is drawn
    bool sided = false;                 ///< the gestures' sides matter: they are made as they stand here
};
using WordRules = std::vector<WordRule>;

/// Of everyday English words.
[[nodiscard]] const WordRules& usualWordRules();

/// The first rule that names a word as it stands, else the first whose beginning it has; null if there is
/// none. Capital letters are as small ones.
[[nodiscard]] const WordRule* ruleFor(const WordRules& rules, std::string_view word);

/// Fails where a rule has no words or no gestures, or names a gesture that the library lacks.
[[nodiscard]] Result<void> checkWordRules(const WordRules& rules, const GestureLibrary& library);

/// The gesture of that id, with ~ for the other hand. The library has it.
[[nodiscard]] UnitGesture gestureOfRule(const GestureLibrary& library, std::string_view id);

/// Words that carry no picture: pronouns, articles, prepositions, auxiliaries, verbs of thinking (Kok 2017:
/// such words are hardly gestured to), and the sounds of hesitation.
[[nodiscard]] bool isPlainWord(std::string_view word);
/// Uh, um and the like: while they last, gestures are rare and mostly held (Graziano & Gullberg 2018).
[[nodiscard]] bool isHesitation(std::string_view word);

}  // namespace deixis::motion
