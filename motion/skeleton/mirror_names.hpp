// Which names of joints tell the two sides of one thing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace deixis::motion {

/// The name with each word that tells a side changed for the other side's: "Left" and "Right" in three
/// cases at the begin of a word, and L, R, l and r that stand alone. Applied twice it is the name itself.
[[nodiscard]] std::string withSideWordsSwapped(std::string_view name);

/// For each of some different names the index of its counterpart, or its own where it has none.
[[nodiscard]] std::vector<int> pairedNames(const std::vector<std::string>& names);

}  // namespace deixis::motion
