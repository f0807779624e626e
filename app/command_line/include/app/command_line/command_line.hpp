// The whole command line: every command, how numbers are read, and suggestions for typing mistakes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/program/commands.hpp"

namespace deixis::app {

/// Declares every command with its options. Options that are numbers take finite and whole numbers alone, as
/// core/number.hpp says what these are.
void addCommands(CLI::App& cli, Command& chosen);

/// What is wrong with the first command or option that there is not, with what was probably meant; empty
/// where there are all.
[[nodiscard]] std::string unknownWord(const CLI::App& cli, const std::vector<std::string>& arguments);

}  // namespace deixis::app
