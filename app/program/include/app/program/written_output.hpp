// Where a command writes its output: a file, or standard output.
#pragma once

#include <cstdio>
#include <nlohmann/json_fwd.hpp>
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

/// On standard output, with a line for each value; bytes that are no UTF-8 are replaced.
void printAsJson(const nlohmann::ordered_json& json);

/// By the letters that every database of SQLite begins with.
[[nodiscard]] bool isDatabase(const std::string& file);
/// A slip of the names must not cost a study: fails if the file is a database. An empty name passes.
[[nodiscard]] Result<void> checkOutput(const std::string& file);

/// Fails if a file stands that Deixis did not write: pages and numbers can be made again, and so replace
/// those of an earlier run alone. An empty name and standard_output pass.
[[nodiscard]] Result<void> checkReplaceable(const std::string& file, bool force);

/// Fails where something stands there, unless `force` says so: for pictures and films, which do not say who
/// made them, and wherever a database stands. An empty name, a pipe and a device pass.
[[nodiscard]] Result<void> checkFree(const std::string& file, bool force);

/// Files of a folder: their names and bytes.
struct FolderFiles {
    std::string folder;
    std::vector<std::pair<std::string, std::string>> files;
};

/// Makes the folders and writes the files there, each folder's together. Before any is written all are looked
/// at: fails where one stands there that begins with another line, and so is no earlier version of the same
/// table or script, unless `force` says so.
[[nodiscard]] Result<void> writeFolders(const std::vector<FolderFiles>& folders, bool force);

/// For files that are made to be edited: fails if another text stands there, unless `force` says so.
[[nodiscard]] Result<void> writeUnlessEdited(const std::string& file, std::string_view bytes, bool force);

}  // namespace deixis::app
