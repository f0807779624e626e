// Figures of the report's and the evaluation's pages as Vega-Lite specifications. All numbers are computed
// here; the page's script only draws them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace deixis::results {

using FigureJson = nlohmann::ordered_json;

struct Figure {
    std::string
        name;  ///< unique on the page, of letters, digits and hyphens; also names the file it is saved as
    std::string caption;  ///< HTML; begins with the figure's number (Numbering)
    std::string label;    ///< plain text: one or a few sentences for those who cannot see it
    FigureJson spec;    ///< Vega-Lite, without description, fonts and the colours of axes, which figureHtml()
                        ///< and the script add
    bool wide = false;  ///< wants the whole width of a page
};

/// A figure element with its specification in it.
[[nodiscard]] std::string figureHtml(const Figure& figure);
/// Where such elements stand: beside each other as far as there is room, or one alone.
enum class FigurePlace : unsigned char { plots, single };
/// Empty where there are none.
[[nodiscard]] std::string figuresPlaced(const std::string& figures, FigurePlace place = FigurePlace::plots);
/// At the page's end: the libraries, their licences and what calls them.
[[nodiscard]] std::string_view figureScript();

/// Told apart by people of all colour vision (Okabe & Ito 2008); the pages' style sheet has a brighter one
/// for each on dark screens.
[[nodiscard]] std::string systemColour(std::size_t index);
inline constexpr const char* ink_colour = "#1c1c1a";
inline constexpr const char* soft_colour = "#4c4c48";
inline constexpr const char* paper_colour = "#ffffff";
inline constexpr const char* even_colour = "#8a8a85";  ///< what is not significant, not better, not worse

/// A long name breaks at the hyphen or space nearest to its middle: one or two lines.
[[nodiscard]] std::vector<std::string> brokenName(const std::string& name);

/// Places beside a line, in [-half, half], at which values stand next to each other where they would cover
/// each other: those within `apart` of each other are spread evenly around 0. In the order of the values; the
/// same values give the same places.
[[nodiscard]] std::vector<double> sidewaysPlaces(const std::vector<double>& values, double apart,
                                                 double half);

/// Of `count` places at most `max`, evenly spread, the first and the last among them: what is drawn of more
/// points than a figure can show.
[[nodiscard]] std::vector<std::size_t> evenPicks(std::size_t count, std::size_t max);
/// `values` in order, thinned by evenPicks: of many, points at their quantiles.
[[nodiscard]] std::vector<double> thinnedValues(std::vector<double> values, std::size_t max);

/// An axis at 0, 1, ... labelled with names of one or several lines.
[[nodiscard]] FigureJson nameAxis(const std::vector<std::vector<std::string>>& names);
/// The same at the side of rows, for names that all have as many lines.
[[nodiscard]] FigureJson rowAxis(const std::vector<std::vector<std::string>>& names);

/// To four significant digits: finer than a figure can show, and shorter on the page.
[[nodiscard]] double rounded(double value, int digits = 4);

/// What makes a figure's height follow its width: a Vega expression of `width`. For Figure::spec's
/// "usermeta"; Vega-Lite alone cannot say it.
[[nodiscard]] FigureJson heightByWidth(const std::string& expression);

/// A quantitative channel: {"field": ..., "type": "quantitative"}.
[[nodiscard]] FigureJson quantity(const char* field);
/// A channel whose colours stand in the data: in the field "colour" if no other is named.
[[nodiscard]] FigureJson ownColour(const char* field = "colour");
/// A layer with data of its own.
[[nodiscard]] FigureJson layerOf(FigureJson values, FigureJson mark, FigureJson encoding);

}  // namespace deixis::results
