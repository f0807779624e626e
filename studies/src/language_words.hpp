// The program's words as a TOML table says them; private to studies.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <string_view>

#include "studies/language.hpp"

namespace deixis::studies {

/// Reads the words of language `code` from a table of `file`, whose keys errors tell behind `prefix`
/// ("words.fr."). With `base` (the words that the program has in this language) keys may be left out, which
/// then are the base's.
[[nodiscard]] Result<LanguageTable> readWords(const toml::table& table, const std::string& file,
                                              std::string_view prefix, const std::string& code,
                                              const LanguageTable* base = nullptr);

/// Why boards cannot draw a text, if they cannot: it has letters of a script that is written from right to
/// left or whose letters change with their neighbours, such as "Arabic".
[[nodiscard]] std::optional<std::string_view> scriptNotDrawn(std::string_view text);
/// What an error says of it.
[[nodiscard]] std::string scriptProblem(std::string_view script);
extern const char* const script_mend;

}  // namespace deixis::studies
