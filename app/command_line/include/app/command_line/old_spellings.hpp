// Spellings of earlier versions, which scripts may keep using.
#pragma once

#include <string>
#include <vector>

namespace deixis::app {

/// The words after the program's name with today's options in the place of earlier ones.
[[nodiscard]] std::vector<std::string> inCurrentSpelling(const std::vector<std::string>& words);

}  // namespace deixis::app
