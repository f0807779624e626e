// What the report's and the evaluation's pages have in common: self-contained HTML that is well-formed XML,
// too.
#pragma once

#include <string>
#include <vector>

namespace deixis::results {

/// To the heading; both are text.
[[nodiscard]] std::string pageStart(const std::string& title, const std::string& heading);
/// A section; empty if there are none.
[[nodiscard]] std::string remarksHtml(const std::vector<std::string>& remarks);
/// Both, with a list of the sections' headings (h2, HTML without attributes) between them, which leads to
/// them.
[[nodiscard]] std::string withContents(const std::string& lead, const std::string& sections);
/// With what draws the figures. `elsewhere`: the sentence that tells where their numbers are where JavaScript
/// is off.
[[nodiscard]] std::string pageEnd(const std::string& elsewhere);

/// "uncommitted_changes" -> "Uncommitted changes".
[[nodiscard]] std::string propertyLabel(std::string name);

}  // namespace deixis::results
