// What the report's and the evaluation's pages have in common: self-contained HTML that is well-formed XML,
// too.
#pragma once

#include <string>
#include <vector>

namespace deixis::results {

/// To the heading; both are text.
[[nodiscard]] std::string pageStart(const std::string& title, const std::string& heading);
/// One line of a list of facts.
struct Fact {
    std::string name;  ///< text
    std::string html;
};
[[nodiscard]] std::string factsHtml(const std::vector<Fact>& facts);
/// A list of texts.
[[nodiscard]] std::string listHtml(const std::vector<std::string>& texts);
/// A list of HTML; what is empty is passed over.
[[nodiscard]] std::string itemsHtml(std::vector<std::string> items);
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
