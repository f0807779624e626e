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

enum class ParagraphLook : unsigned char {
    plain,
    lead,       ///< below the page's heading
    intro,      ///< smaller, before figures or tables
    small,      ///< below them
    synthetic,  ///< a warning that numbers are not of people, or motion not recorded
};
[[nodiscard]] std::string paragraphHtml(const std::string& html, ParagraphLook look = ParagraphLook::plain);
/// It begins with its title, bold text, which has its own full stop or colon.
[[nodiscard]] std::string titledParagraph(const std::string& title, const std::string& html,
                                          ParagraphLook look = ParagraphLook::plain);
/// A sentence below a table, text.
[[nodiscard]] std::string noteHtml(const std::string& text);

/// A part of a page under a heading of its own, which is text. Not shown where `html` is empty.
struct Section {
    std::string heading;
    std::string html;
};
[[nodiscard]] Section remarksSection(const std::vector<std::string>& remarks);
/// The lead, a list of the sections' headings that leads to them, and the sections.
[[nodiscard]] std::string withContents(const std::string& lead, std::vector<Section> sections);
/// With what draws the figures. `elsewhere`: the sentence that tells where their numbers are where JavaScript
/// is off.
[[nodiscard]] std::string pageEnd(const std::string& elsewhere);

/// "uncommitted_changes" -> "Uncommitted changes".
[[nodiscard]] std::string propertyLabel(std::string name);

}  // namespace deixis::results
