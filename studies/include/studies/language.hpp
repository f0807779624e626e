// The program's own words that a participant reads, in one language: buttons, pause pages, notices. A study's
// texts are the study file's. Tables ship in assets/data/languages (en, de, sv, ko).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace deixis::studies {

class LanguageTable {
  public:
    /// Reads LANGUAGE.toml: a flat table of texts. Every key of languageKeys() must be there with the same
    /// placeholders ("{number}") as in languageKeys(), and no other key.
    [[nodiscard]] static Result<LanguageTable> load(const std::filesystem::path& file);
    /// The built-in English words, from the same place as the keys. For tests and as the reference.
    [[nodiscard]] static const LanguageTable& english();

    /// The text of a key; throws std::out_of_range for one that languageKeys() lacks.
    [[nodiscard]] const std::string& operator()(std::string_view key) const;
    /// The same with "{name}" replaced.
    [[nodiscard]] std::string operator()(
        std::string_view key, const std::vector<std::pair<std::string_view, std::string>>& values) const;
    /// With "{seconds}" replaced; the text of `one` where there is one second alone.
    [[nodiscard]] std::string seconds(std::string_view key, std::string_view one, int seconds) const;
    [[nodiscard]] const std::string& code() const { return code_; }  ///< "en", "de", ...

  private:
    std::string code_;
    std::vector<std::pair<std::string, std::string>> texts_;  ///< sorted by key
};

/// Every key in the order of the files, with its English text.
[[nodiscard]] const std::vector<std::pair<std::string_view, std::string_view>>& languageKeys();

}  // namespace deixis::studies
