// Which program this is: for `--version`, and for everything that it stores and writes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studies/station/station.hpp"

namespace deixis::app {

/// Name and value.
using Properties = std::vector<std::pair<std::string, std::string>>;

/// "deixis 0.1.0 (commit 0123456789ab)", with a word where files of that commit were changed.
[[nodiscard]] std::string programVersion();

/// The whole commit, whether its files were changed, build type, compiler, libraries, and the system that it
/// was built on: the same for one program in one installation, so that what is written with them is, too.
[[nodiscard]] Properties buildProperties();

/// The system that the program runs on, with its kernel.
[[nodiscard]] std::string operatingSystem();

/// All of it, a line each.
[[nodiscard]] std::string versionText();

/// A station's description with all of it among its properties, which a session keeps: "program_commit", ...
[[nodiscard]] studies::StationInfo withProgram(studies::StationInfo info);

}  // namespace deixis::app
