// The shell's completion of the program's command line.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "command_description.hpp"

namespace deixis::app {

/// Words that may be given where the command line only says TEXT, by the name of the option or of the place:
/// "STUDY", "--language". "@files" among them stands for any file.
using KnownWords = std::map<std::string, std::vector<std::string>>;

/// A script for bash 4.2 and newer, which needs nothing else: commands, options, choices, known words, and
/// files where a text is expected.
[[nodiscard]] std::string bashCompletion(const CommandDescription& program, const KnownWords& known);

}  // namespace deixis::app
