#include "results/page/page.hpp"

#include <fmt/core.h>

#include <string_view>
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

std::string remarksHtml(const std::vector<std::string>& remarks) {
    return remarks.empty() ? "" : "\n<h2>Remarks</h2>" + listHtml(remarks);
}

std::string withContents(const std::string& lead, const std::string& sections) {
    constexpr std::string_view open = "<h2>";
    constexpr std::string_view close = "</h2>";
    Json items = Json::array();
    std::string out;
    std::size_t from = 0;
    int number = 0;
    for (std::size_t at = sections.find(open); at != std::string::npos; at = sections.find(open, from)) {
        const std::size_t end = sections.find(close, at);
        const std::string heading = sections.substr(at + open.size(), end - at - open.size());
        out += sections.substr(from, at - from) + fmt::format("<h2 id=\"section-{}\">", ++number);
        items.push_back({{"number", number}, {"heading", heading}});
        from = at + open.size();
    }
    out += sections.substr(from);
    if (number < 2) return lead + out;
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
