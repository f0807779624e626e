// Texts for synthetic speakers: a grammar of themes, and short speeches drawn from it. The corpus for the
// gesture model is spoken from them.
//
// The file that ships (assets/data/speech/sentences.txt) explains its own form in its first lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::speech {

/// A rule's part: words as they stand, or what a rule gives.
struct GrammarPiece {
    std::string words;     ///< where `rule` is below 0
    int rule = -1;         ///< index of a rule
    std::size_t form = 0;  ///< of its alternative
    int label = 0;         ///< above 0: the same alternative of that rule all through a speech
};
using GrammarForm = std::vector<GrammarPiece>;

struct GrammarRule {
    std::string name;  ///< empty: alternatives that stand within another rule
    int line = 0;
    std::vector<std::vector<GrammarForm>> alternatives{};  ///< each has at least one form
};

struct GrammarStage {
    enum class Times : unsigned char { once, maybe, many };
    int rule = 0;
    Times times = Times::once;
};
struct GrammarTheme {
    std::string name;
    int line = 0;
    std::vector<GrammarStage> stages{};  ///< one of them may be had many times
};

struct SentenceGrammar {
    std::vector<GrammarRule> rules;
    std::vector<GrammarTheme> themes;
};

/// Reads a grammar. `name` stands for the file. Errors name the line: rules that are missing, empty, there
/// twice, never used, or made of themselves; a form that an alternative lacks; a label on a rule that is more
/// than words; brackets that do not close.
[[nodiscard]] Result<SentenceGrammar> parseSentenceGrammar(std::string_view text, const std::string& name);

}  // namespace deixis::speech
