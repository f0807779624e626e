// The program's manual page.
#pragma once

#include <string>

#include "command_description.hpp"

namespace deixis::app {

/// In roff, by the macros of man(7).
[[nodiscard]] std::string manualPage(const CommandDescription& program, const std::string& version);

}  // namespace deixis::app
