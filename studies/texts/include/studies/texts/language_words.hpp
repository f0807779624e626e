// The program's words as read from a TOML table; private to studies.
#pragma once

#include <toml++/toml.h>
#include <optional>
#include <string>
#include <string_view>

#include "studies/texts/language.hpp"

namespace deixis::studies {

/// Reads the words of language `code` from a table of `file`, whose keys errors tell behind `prefix`
/// ("words.fr."). With `base` (the words that the program has in this language) keys may be left out, which
/// then are the base's.
[[nodiscard]] Result<LanguageTable> readWords(const toml::table& table, const std::string& file,
                                              std::string_view prefix, const std::string& code,
                                              const LanguageTable* base = nullptr);

/// Why boards cannot draw a text, and what to do about it.
struct NotDrawn {
    std::string message;
    const char* hint;
};

/// None if they can. Not drawn are letters of a script that is written from right to left or whose letters
/// change with their neighbours, such as Arabic, and letters for which the program's fonts have no shape,
/// such as Chinese ones.
[[nodiscard]] std::optional<NotDrawn> notDrawn(std::string_view text);

}  // namespace deixis::studies
