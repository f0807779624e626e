#pragma once

#include <string>

#include "core/error.hpp"

namespace deixis::app {

/// Analyses a database and writes the page and the JSON; an empty name leaves that one out.
[[nodiscard]] Result<void> writeReport(const std::string& database, const std::string& page,
                                       const std::string& json);

/// A slip of the names must not cost a study: fails where the file is a database. An empty name passes.
[[nodiscard]] Result<void> checkOutput(const std::string& file);

}  // namespace deixis::app
