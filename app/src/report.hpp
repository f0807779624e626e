#pragma once

#include <string>

#include "core/error.hpp"

namespace deixis::app {

/// Analyses a database and writes the page and the JSON; an empty name leaves that one out.
[[nodiscard]] Result<void> writeReport(const std::string& database, const std::string& page,
                                       const std::string& json);

}  // namespace deixis::app
