#include "results/page/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "results/page/report_text.hpp"

namespace deixis::results {

namespace {

/// JSON that can stand in a script element, in HTML and in XML.
std::string scriptJson(const FigureJson& json) {
    std::string out;
    for (const char c : json.dump(-1, ' ', false, FigureJson::error_handler_t::replace)) {
        if (c == '<' || c == '>' || c == '&')
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            out += c;
    }
    return out;
}

}  // namespace

std::string figureHtml(const Figure& figure) {
    FigureJson spec{{"$schema", "https://vega.github.io/schema/vega-lite/v6.json"},
                    {"description", figure.label},
                    {"width", "container"}};
    spec.update(figure.spec);
    return fmt::format(
        "\n<figure id=\"{0}\"{1} aria-label=\"{2}\"><figcaption>{3}</figcaption><div class=\"drawing\"></div>"
        "<script type=\"application/json\">{4}</script></figure>",
        figure.name, figure.wide ? " class=\"wide\"" : "", escapeHtml(figure.label), figure.caption,
        scriptJson(spec));
}

std::string figuresEnd(const std::string& elsewhere) {
    std::string out = fmt::format(
        "\n<noscript><p class=\"small\">The figures are drawn with JavaScript, which is off here. {}</p>"
        "</noscript>\n<script>/*<![CDATA[*/\n",
        elsewhere);
    out += figureScript();
    return out + "/*]]>*/</script>";
}

std::string systemColour(std::size_t index) {
    constexpr std::array colours{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"};
    return colours[index % colours.size()];
}

std::vector<std::string> brokenName(const std::string& name) {
    constexpr std::size_t fits = 12;
    const auto distance = [&](std::size_t at) {
        return std::abs(static_cast<double>(at) - static_cast<double>(name.size()) / 2.0);
    };
    std::size_t best = std::string::npos;
    for (std::size_t at = name.find_first_of("- "); at != std::string::npos;
         at = name.find_first_of("- ", at + 1))
        if (best == std::string::npos || distance(at) < distance(best)) best = at;
    if (name.size() <= fits || best == std::string::npos) return {name};
    return {name.substr(0, best + 1), name.substr(best + 1)};
}

std::vector<double> sidewaysPlaces(const std::vector<double>& values, double apart, double half) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> places(values.size(), 0.0);
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && values[order[end]] - values[order[first]] < apart) ++end;
        const std::size_t count = end - first;
        const double step =
            count > 1 ? std::min(0.2 * half, 2.0 * half / static_cast<double>(count - 1)) : 0.0;
        for (std::size_t i = 0; i < count; ++i)
            places[order[first + i]] = step * (static_cast<double>(i) - 0.5 * static_cast<double>(count - 1));
        first = end;
    }
    return places;
}

std::vector<std::size_t> evenPicks(std::size_t count, std::size_t most) {
    std::vector<std::size_t> picks(std::min(count, most));
    for (std::size_t i = 0; i < picks.size(); ++i)
        picks[i] = picks.size() > 1 ? i * (count - 1) / (picks.size() - 1) : 0;
    return picks;
}

std::vector<double> thinnedValues(std::vector<double> values, std::size_t most) {
    std::sort(values.begin(), values.end());
    std::vector<double> thinned;
    for (const std::size_t at : evenPicks(values.size(), most)) thinned.push_back(values[at]);
    return thinned;
}

FigureJson nameAxis(const std::vector<std::vector<std::string>>& names) {
    std::vector<std::size_t> values(names.size());
    std::iota(values.begin(), values.end(), std::size_t{0});
    return {{"values", values},
            {"labelExpr",
             FigureJson(names).dump(-1, ' ', true, FigureJson::error_handler_t::replace) + "[datum.value]"},
            {"tickCount", names.size()},  // else Vega leaves out every second one where it is narrow
            {"labelLimit", 150},
            {"labelOverlap", false},
            {"grid", false},
            {"title", nullptr}};
}

FigureJson rowAxis(const std::vector<std::vector<std::string>>& names) {
    constexpr double line_px = 15.0;
    FigureJson axis = nameAxis(names);
    if (!names.empty()) axis["labelOffset"] = -0.5 * line_px * static_cast<double>(names.front().size() - 1);
    return axis;
}

double rounded(double value, int digits) {
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

FigureJson heightByWidth(const std::string& expression) {
    FigureJson patch{
        {{"op", "remove"}, {"path", "/height"}},
        {{"op", "add"}, {"path", "/signals/-"}, {"value", {{"name", "height"}, {"update", expression}}}}};
    return {{"embedOptions", {{"patch", std::move(patch)}}}};
}

FigureJson quantity(const char* field) {
    return {{"field", field}, {"type", "quantitative"}};
}

FigureJson ownColour(const char* field) {
    return {{"field", field}, {"type", "nominal"}, {"scale", nullptr}};
}

FigureJson layerOf(FigureJson values, FigureJson mark, FigureJson encoding) {
    return {{"data", {{"values", std::move(values)}}},
            {"mark", std::move(mark)},
            {"encoding", std::move(encoding)}};
}

const char* const figure_css = R"css(
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 25rem), 1fr));
  gap: 2rem 1.6rem; margin: 1.2rem 0; }
.plots .wide { grid-column: 1 / -1; }
.single { max-width: 38rem; margin: 1.2rem 0; }
figure { margin: 0; min-width: 0; position: relative; break-inside: avoid; }
figcaption { margin: 0 0 .5rem; padding-right: 2.4rem; overflow-wrap: anywhere; }
figcaption b { color: var(--ink); font-size: 1rem; }
.drawing { min-height: 4rem; }
.drawing svg { display: block; max-width: 100%; height: auto; }
.drawing .failed { color: var(--warn); }
.drawing details { position: absolute; top: 0; right: 0; margin: 0; font-size: .875rem; }
.drawing summary { list-style: none; display: flex; align-items: center; justify-content: center; width: 1.9rem;
  height: 1.6rem; border: 1px solid var(--rule); border-radius: .3rem; background: var(--paper); color: var(--soft); }
.drawing summary::-webkit-details-marker { display: none; }
.drawing summary:hover { color: var(--ink); border-color: var(--soft); }
.drawing summary svg { width: .9rem; height: .9rem; fill: none; stroke: currentColor; stroke-width: 2; }
.drawing summary circle { fill: currentColor; stroke: none; }
.vega-actions { position: absolute; right: 0; top: 1.9rem; z-index: 2; min-width: 9rem; border: 1px solid var(--rule);
  border-radius: .3rem; background: var(--paper); box-shadow: 0 .2rem .6rem rgb(0 0 0 / .18); }
.vega-actions a { display: block; padding: .4rem .8rem; color: var(--ink); text-decoration: none; white-space: nowrap; }
.vega-actions a:hover, .vega-actions a:focus { background: var(--shade); }
#vg-tooltip-element { position: fixed; z-index: 3; visibility: hidden; padding: .3rem .6rem; max-width: 20rem;
  font-size: .875rem; border: 1px solid var(--rule); border-radius: .3rem; background: var(--paper); color: var(--ink);
  pointer-events: none; }
#vg-tooltip-element.visible { visibility: visible; }
/* Figures are drawn, saved and printed in light colours; a dark screen shows each by its counterpart. */
@media screen and (prefers-color-scheme: dark) {
  .drawing svg { background: none !important; }
  .drawing [fill="#1c1c1a"] { fill: var(--ink); } .drawing [stroke="#1c1c1a"] { stroke: var(--ink); }
  .drawing [fill="#4c4c48"] { fill: var(--soft); } .drawing [stroke="#4c4c48"] { stroke: var(--soft); }
  .drawing [fill="#8a8a85"] { fill: #a3a39d; } .drawing [stroke="#8a8a85"] { stroke: #a3a39d; }
  .drawing [fill="#e3e3e0"] { fill: var(--thin); } .drawing [stroke="#e3e3e0"] { stroke: var(--thin); }
  .drawing [fill="#ffffff"] { fill: var(--paper); } .drawing [stroke="#ffffff"] { stroke: var(--paper); }
  .drawing [fill="#0072b2"] { fill: #62b5ec; } .drawing [stroke="#0072b2"] { stroke: #62b5ec; }
  .drawing [fill="#e69f00"] { fill: #f0b33c; } .drawing [stroke="#e69f00"] { stroke: #f0b33c; }
  .drawing [fill="#009e73"] { fill: #3cc79d; } .drawing [stroke="#009e73"] { stroke: #3cc79d; }
  .drawing [fill="#cc79a7"] { fill: #e29cc4; } .drawing [stroke="#cc79a7"] { stroke: #e29cc4; }
  .drawing [fill="#56b4e9"] { fill: #a6d8f7; } .drawing [stroke="#56b4e9"] { stroke: #a6d8f7; }
  .drawing [fill="#d55e00"] { fill: #f28a3d; } .drawing [stroke="#d55e00"] { stroke: #f28a3d; }
}
@media print {
  /* At the size at which they were drawn, so that their words can be read. */
  .plots { grid-template-columns: 1fr; gap: 1rem; }
  .single { max-width: none; }
  .drawing > details { display: none; }
  .drawing svg { width: auto; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace deixis::results
