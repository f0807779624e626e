// What a command writes at the place that it was given: a file, or standard output.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace deixis::app {

/// As a file's name: standard output.
inline constexpr const char* standard_output = "-";

/// Where a command tells what it did: standard output, unless `json` is printed there.
[[nodiscard]] std::FILE* remarksBeside(const std::string& json);

/// `file` may be standard_output.
[[nodiscard]] Result<void> writeOutput(const std::string& file, std::string_view bytes);

/// By the letters that every database of SQLite begins with.
[[nodiscard]] bool isDatabase(const std::string& file);
/// A slip of the names must not cost a study: fails where the file is a database. An empty name passes.
[[nodiscard]] Result<void> checkOutput(const std::string& file);

/// Fails where a file stands that Deixis did not write: pages and numbers can be made again, and so replace
/// those of an earlier run alone. An empty name and standard_output pass.
[[nodiscard]] Result<void> checkReplaceable(const std::string& file, bool force);

/// Before any work begins: fails where something stands already, unless `force` says so, and wherever a
/// database does. An empty name, a pipe and a device pass.
[[nodiscard]] Result<void> checkFree(const std::string& file, bool force);
/// The same of a folder to which files with those endings (".csv") are written, whatever their names will be:
/// fails where it holds such files.
[[nodiscard]] Result<void> checkFolderFree(const std::string& folder,
                                           const std::vector<std::string_view>& endings, bool force);

/// Names of a folder's files, and their bytes.
using FolderFiles = std::vector<std::pair<std::string, std::string>>;
/// All of them or none, over those that are there. Nothing where no folder is named.
[[nodiscard]] Result<void> writeFolder(const std::string& folder, const FolderFiles& files);

/// For files that are made to be edited: fails where another text stands there, unless `force` says so.
[[nodiscard]] Result<void> writeUnlessEdited(const std::string& file, std::string_view bytes, bool force);

}  // namespace deixis::app
