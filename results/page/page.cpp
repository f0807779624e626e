#include "results/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "results/page/figure.hpp"
#include "results/page/report_text.hpp"

namespace deixis::results {

namespace {

const char* const page_css = R"css(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c1c1a; --soft: #4c4c48; --rule: #d6d6d1;
  --thin: #e3e3e0; --shade: #f5f5f2; --warn: #b35900; --warn-paper: #fff6e8; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #16181b; --ink: #ecece8; --soft: #b4b4ae; --rule: #4a4d52; --thin: #33363a; --shade: #202327;
    --warn: #f0a04b; --warn-paper: #2c2418; } }
@page { size: A4; margin: 16mm 15mm; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2.5rem 1.5rem 4rem; max-width: 62rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 "Source Sans 3", "Noto Sans", "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif;
  font-variant-numeric: tabular-nums; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.25rem; margin: 2.4rem 0 .6rem; padding-bottom: .25rem; border-bottom: 1px solid var(--rule);
  break-after: avoid; }
h1, h2 { overflow-wrap: anywhere; }
p { margin: .5rem 0; max-width: 48rem; }
.lead { color: var(--soft); margin-bottom: 1.2rem; }
.small, caption, figcaption { font-size: .875rem; color: var(--soft); }
.synthetic { border: 2px solid var(--warn); border-left-width: .6rem; background: var(--warn-paper); padding: .7rem 1rem;
  margin: 1.2rem 0; max-width: none; }
.intro { break-after: avoid; }
.findings { padding-left: 1.2rem; max-width: 48rem; }
.findings li { margin: .35rem 0; }
.scroll { overflow-x: auto; margin: 1rem 0; scrollbar-width: thin; }
/* A table that is wider than its place says so, and darkens where it is cut. */
.scroll.cut { background:
    linear-gradient(to right, var(--paper) 30%, transparent) left / 2.5rem 100% no-repeat local,
    linear-gradient(to left, var(--paper) 30%, transparent) right / 2.5rem 100% no-repeat local,
    linear-gradient(to right, rgb(0 0 0 / .28), transparent) left / .8rem 100% no-repeat scroll,
    linear-gradient(to left, rgb(0 0 0 / .28), transparent) right / .8rem 100% no-repeat scroll; }
.scroll.cut::before { content: "wider than the screen: scroll sideways \2192"; display: block; position: sticky; left: 0;
  width: max-content; max-width: 100%; font-size: .8125rem; color: var(--warn); }
.contents { margin: 1.2rem 0; padding: .7rem 1rem; background: var(--shade); border-radius: .3rem; }
.contents ul { list-style: none; margin: 0; padding: 0; columns: 15rem; column-gap: 2rem; }
.contents li { padding: .1rem 0; break-inside: avoid; }
.contents a { color: inherit; }
table { border-collapse: collapse; font-size: .9375rem; break-inside: avoid; }
caption { text-align: left; padding-bottom: .4rem; }
caption b { color: var(--ink); }
caption span { display: inline-block; position: sticky; left: 0; max-width: min(48rem, calc(100vw - 3rem)); }
th, td { padding: .28rem .6rem; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--thin); }
table.dense { font-size: .84rem; }
table.dense th, table.dense td { padding: .25rem .38rem; }
th:first-child, td:first-child, .text { text-align: left; }
thead th { border-bottom: 1.5px solid var(--ink); font-weight: 600; vertical-align: bottom; }
thead tr.over th { border-bottom: none; text-align: center; padding-bottom: 0; }
tbody th { font-weight: 600; }
tr.all td, tr.all th { background: var(--shade); }
td.sig { font-weight: 600; }
td.not { color: var(--soft); }
details { margin: -.4rem 0 1rem; font-size: .875rem; }
summary { cursor: pointer; color: var(--soft); }
td.missing { background: var(--warn-paper); color: var(--warn); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1.2rem; font-size: .9375rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
@media print {
  html { font-size: 9.5pt; }
  body { padding: 0; max-width: none; line-height: 1.4; }
  h2 { margin-top: 1.4rem; }
  dl { break-inside: avoid; }
  th, td { padding: .2rem .6rem; }
  p, .findings { max-width: none; }
  .scroll, .scroll.cut { overflow: visible; background: none; }
  .scroll.cut::before, .contents { display: none; }
}
)css";

}  // namespace

std::string pageStart(const std::string& title, const std::string& heading) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<meta name=\"generator\" content=\"deixis\"/>\n<title>{}</title>\n"
        "<style>{}{}</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n",
        escapeHtml(title), page_css, figure_css, escapeHtml(heading));
}

std::string remarksHtml(const std::vector<std::string>& remarks) {
    if (remarks.empty()) return "";
    std::string out = "\n<h2>Remarks</h2><ul class=\"findings\">";
    for (const auto& remark : remarks) out += "<li>" + escapeHtml(remark) + "</li>";
    return out + "</ul>";
}

std::string withContents(const std::string& lead, const std::string& sections) {
    constexpr std::string_view open = "<h2>";
    constexpr std::string_view close = "</h2>";
    std::string items;
    std::string out;
    std::size_t from = 0;
    int number = 0;
    for (std::size_t at = sections.find(open); at != std::string::npos; at = sections.find(open, from)) {
        const std::size_t end = sections.find(close, at);
        const std::string heading = sections.substr(at + open.size(), end - at - open.size());
        out += sections.substr(from, at - from) + fmt::format("<h2 id=\"section-{}\">", ++number);
        items += fmt::format("<li><a href=\"#section-{}\">{}</a></li>", number, heading);
        from = at + open.size();
    }
    out += sections.substr(from);
    if (number < 2) return lead + out;
    return lead + "\n<nav class=\"contents\" aria-label=\"Contents\"><ul>" + items + "</ul></nav>" + out;
}

std::string pageEnd(const std::string& elsewhere) {
    return "\n</main>" + figuresEnd(elsewhere) + "\n</body>\n</html>\n";
}

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string propertyLabel(std::string name) {
    name = spaced(std::move(name));
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

}  // namespace deixis::results
