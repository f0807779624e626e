// Speeches drawn from a grammar, in three parts that share no sentence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "speech/sentences/sentence_grammar.hpp"

namespace deixis::speech {

/// Of a corpus: 8 of 10 speeches are for training, one for validation, one for the test (Yoon et al. 2021,
/// section 5).
enum class CorpusPart : unsigned char { training, validation, test };
[[nodiscard]] std::string_view corpusPartName(CorpusPart part);

struct SpeechText {
    std::string theme;
    std::string text;  ///< sentences with a blank between them
    CorpusPart part = CorpusPart::training;
};

struct SpeechLengths {
    double min_s = 6.0, max_s = 22.0;  ///< by spokenSeconds()
};

/// About how long flite's voices take for a text, at their own pace: by syllables (groups of vowels), commas
/// and ends of sentences.
[[nodiscard]] double spokenSeconds(std::string_view text);

/// The text's sentences, each with its mark at the end.
[[nodiscard]] std::vector<std::string> sentencesOf(std::string_view text);

/// The part that a sentence belongs to, by its letters alone: none is in two.
[[nodiscard]] CorpusPart partOfSentence(std::string_view sentence);

/// `count` speeches, no two of the same text, as many of every theme as of any other (but for chance); of ten
/// that follow each other, eight are for training, the ninth for validation, the tenth for the test. Speech
/// number i depends on seed, i and those before it. Fails where the grammar cannot say so many or none of
/// such a length.
[[nodiscard]] Result<std::vector<SpeechText>> drawSpeechTexts(const SentenceGrammar& grammar,
                                                              std::uint64_t seed, std::size_t count,
                                                              const SpeechLengths& lengths = {});

}  // namespace deixis::speech
