// JSON that one of the program's commands wrote, read again.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/error.hpp"
#include "results/tables/table.hpp"

namespace deixis::results {

struct WrittenJson {
    std::string what;     ///< "objective evaluation"
    std::string command;  ///< that writes it
    std::function<bool(const Json&)> is_it;
};
[[nodiscard]] WrittenJson writtenEvaluation();  ///< by `deixis evaluate`
[[nodiscard]] WrittenJson writtenAnalysis();    ///< by `deixis report`, of one kind of station

/// Gives the file's JSON to `read`, of which an exception of the JSON's library says that the file is
/// damaged. Errors name the file: it cannot be read, or is not what it should be.
[[nodiscard]] Result<void> readWritten(const std::filesystem::path& file, const WrittenJson& expected,
                                       const std::function<Result<void>(const Json&)>& read);

}  // namespace deixis::results
