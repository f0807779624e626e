// Where tests find the sources, the build, the program and the data that is shared beside them.
#pragma once

#include <filesystem>
#include <string>

namespace deixis::tests {

[[nodiscard]] std::filesystem::path sourceDir();
[[nodiscard]] std::filesystem::path buildDir();
/// A file of real recordings or figures by others, which may be absent: they are never part of the project.
[[nodiscard]] std::filesystem::path sharedData(const std::string& relative);
/// The program of this build, or what the environment's DEIXIS_TESTED_PROGRAM names.
[[nodiscard]] std::string programFile();
/// Whether the build has sanitizers.
[[nodiscard]] bool isSanitized();

}  // namespace deixis::tests
