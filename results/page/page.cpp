#include "results/page/page.hpp"

#include <utility>

#include "core/text.hpp"
#include "results/page/figure.hpp"
#include "results/page/templates.hpp"

namespace deixis::results {

std::string pageStart(const std::string& title, const std::string& heading) {
    return filled("page_start.mustache",
                  {{"title", title}, {"heading", heading}, {"css", templateText("page.css")}});
}

std::string factsHtml(const std::vector<Fact>& facts) {
    Json rows = Json::array();
    for (const Fact& fact : facts) rows.push_back({{"name", fact.name}, {"html", fact.html}});
    return filled("facts.mustache", {{"facts", rows}});
}

std::string listHtml(const std::vector<std::string>& texts) {
    return filled("list.mustache", {{"items", texts}});
}

std::string itemsHtml(std::vector<std::string> items) {
    std::erase(items, "");
    return filled("list.mustache", {{"html", items}});
}

std::string paragraphHtml(const std::string& html, ParagraphLook look) {
    return titledParagraph("", html, look);
}

std::string titledParagraph(const std::string& title, const std::string& html, ParagraphLook look) {
    constexpr const char* classes[] = {"", "lead", "small intro", "small", "synthetic"};
    return filled("paragraph.mustache",
                  {{"class", classes[static_cast<std::size_t>(look)]}, {"title", title}, {"html", html}});
}

std::string noteHtml(const std::string& text) {
    return paragraphHtml(escapeHtml(text), ParagraphLook::small);
}

Section remarksSection(const std::vector<std::string>& remarks) {
    return {"Remarks", remarks.empty() ? "" : listHtml(remarks)};
}

std::string withContents(const std::string& lead, std::vector<Section> sections) {
    std::erase_if(sections, [](const Section& one) { return one.html.empty(); });
    Json items = Json::array();
    std::string out;
    for (const Section& one : sections) {
        Json item{{"heading", one.heading}, {"html", one.html}};
        if (sections.size() > 1) item["number"] = items.size() + 1;
        out += filled("section.mustache", item);
        items.push_back({{"number", items.size() + 1}, {"heading", one.heading}});
    }
    if (items.size() < 2) return lead + out;
    return lead + filled("contents.mustache", {{"sections", items}}) + out;
}

std::string pageEnd(const std::string& elsewhere) {
    return filled("page_end.mustache", {{"elsewhere", elsewhere}, {"script", std::string(figureScript())}});
}

std::string propertyLabel(std::string name) {
    name = inWords(std::move(name));
    if (name.starts_with("vr ")) name.replace(0, 2, "VR");
    return capitalised(name);
}

}  // namespace deixis::results
