// A database for sharing: the same study and answers, without anything that identifies a person, place or
// time and that the analysis does not need. docs/data-out.md says how each table is treated.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

struct AnonymousOptions {
    bool free_text = false;  ///< what participants typed is kept
    bool tracking = true;    ///< tracked movements are kept
    /// The copies of the locked sets: hash of a set, and of its copy.
    std::map<std::string, std::string> locked{};
    std::set<std::string> locked_files{};          ///< names of files in them
    std::map<std::string, std::string> authors{};  ///< of clips: name, and what stands for it
};

/// What was left out, counted.
struct AnonymousCounts {
    int participants = 0;
    int declined = 0;    ///< of them, those who declined consent: only that they did is kept
    int free_texts = 0;  ///< answers without their text
    int frames = 0;      ///< tracked frames that are kept
    int reasons = 0;     ///< the experimenter's words: reasons, remarks
};

/// Writes the copy of a database into a new file. Participants are called as in an anonymised export. The
/// same database and options give the same bytes. Fails if a set that the database speaks of is not among
/// `locked`.
[[nodiscard]] Result<AnonymousCounts> copyAnonymously(const std::filesystem::path& database,
                                                      const std::filesystem::path& copy,
                                                      const AnonymousOptions& options);

/// What stands for authors of clips, in an order that tells nothing.
[[nodiscard]] Result<std::map<std::string, std::string>> anonymousAuthors(
    const std::filesystem::path& database, const std::set<std::string>& authors);

/// A study file's text with the file's name alone in the place of each path that is written whole
/// ("/home/...", "C:\...").
[[nodiscard]] std::string withoutWholePaths(std::string_view text);

}  // namespace deixis::results
