// A text as words: as people wrote them, and in the characters that an English voice can speak.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::speech {

/// Some 18 minutes at a voice's own rate.
inline constexpr std::size_t max_words = 4000;
inline constexpr std::size_t max_text_bytes = 200'000;
inline constexpr std::size_t max_word_characters = 80;

struct WrittenWord {
    std::string text;         ///< as written, without the punctuation around it: "naïve", "$250", "o'clock"
    std::string spelling;     ///< the same in ASCII: "naive"
    std::string opening;      ///< ASCII punctuation before it, and
    std::string closing;      ///< behind it, from which a voice takes pauses and tones
    bool ends_block = false;  ///< an empty line follows
};

/// The words of an English text; one that is only punctuation is none. A dash between words parts them. Latin
/// letters lose their marks; symbols that English has no word for, such as emoji, are passed over.
/// Errors, with `where` before them: text that is not UTF-8 or has control characters; letters of another
/// script, which is named; none to speak; more or longer words than above.
[[nodiscard]] Result<std::vector<WrittenWord>> writtenWords(std::string_view text, const std::string& where);

/// What any text must be, whatever its language: UTF-8 without control characters, neither empty nor longer
/// than max_text_bytes.
[[nodiscard]] Result<void> checkText(std::string_view text, const std::string& where);

}  // namespace deixis::speech
