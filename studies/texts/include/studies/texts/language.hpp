// The program's own words that a participant reads, in one language: buttons, pause pages, notices. A
// study's texts are in the study file. Tables for en, de, sv and ko are in assets/data/languages; a study
// file may add those of another language, or change single ones ([words.LANGUAGE], docs/study-file.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace deixis::studies {

/// How far the words of a language can be trusted.
enum class TextStatus : unsigned char {
    unstated,
    written,     ///< in this language by their authors
    translated,  ///< and not reviewed by a speaker of the language
    reviewed     ///< translated, and reviewed by a speaker
};
/// As in the files: "written", "translated", "reviewed"; none for anything else.
[[nodiscard]] std::optional<TextStatus> textStatusFromName(std::string_view name);
/// In words: "translated, not reviewed by a native speaker".
[[nodiscard]] std::string_view textStatusText(TextStatus status);

class LanguageTable {
  public:
    using Texts = std::vector<std::pair<std::string, std::string>>;

    LanguageTable() = default;
    /// `texts`: every key of languageKeys() with its text, in any order.
    LanguageTable(std::string code, TextStatus status, Texts texts);

    /// Reads LANGUAGE.toml: a flat table of texts and its `status`. Every key of languageKeys() must be there
    /// with the same placeholders ("{number}") as in languageKeys(), and no other key.
    [[nodiscard]] static Result<LanguageTable> load(const std::filesystem::path& file);
    /// Words that were kept, maybe by an earlier program: those that it lacked, or that say something else by
    /// now, are as in the file `today` (if there is none, in English); those that are gone are passed
    /// over.
    [[nodiscard]] static Result<LanguageTable> loadKept(const std::filesystem::path& file,
                                                        const std::filesystem::path& today);
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
    [[nodiscard]] TextStatus status() const { return status_; }
    [[nodiscard]] const Texts& texts() const { return texts_; }  ///< sorted by key

  private:
    std::string code_;
    TextStatus status_ = TextStatus::unstated;
    Texts texts_;
};

/// Every key in the order of the files, with its English text.
[[nodiscard]] const std::vector<std::pair<std::string_view, std::string_view>>& languageKeys();

}  // namespace deixis::studies
