// The texts of a study or questionnaire file in its languages; private to studies.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "studies/texts/toml_table.hpp"

namespace deixis::studies {

/// What the [texts.LANGUAGE] of one file say.
class TextBook {
  public:
    explicit TextBook(Problems& problems) : problems_(problems) {}

    /// Reads [texts] of the file: all languages must be there with the same keys, none empty, and every key
    /// must be referred to somewhere else in the file.
    void read(const toml::table& file, const std::vector<std::string>& languages,
              const std::string& language);
    /// A text in the language asked for: "@key" from the book, anything else as it stands, which is a problem
    /// where there is more than one language. Empty if there was a problem.
    [[nodiscard]] std::string resolve(const std::string& written, toml::source_position at,
                                      const std::string& key);

  private:
    void readLanguage(const std::string& language, const toml::table& table);
    void compareLanguages(const toml::table& texts, const toml::table& file);

    using Texts = std::map<std::string, std::string, std::less<>>;
    Problems& problems_;
    std::string language_;
    std::vector<std::string> languages_{};
    std::map<std::string, Texts, std::less<>> texts_{};
    std::set<std::string, std::less<>> keys_{};  ///< of all languages together
};

/// The codes under `key` ("languages") of a table; where it is missing, English alone.
[[nodiscard]] std::vector<std::string> readLanguages(TomlTable& table, const toml::table& file);

}  // namespace deixis::studies
