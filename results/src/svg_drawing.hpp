// An SVG element piece by piece, with title and description for those who cannot see it. Colours come from
// the page's style sheet by class, so that light and dark pages draw alike.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace deixis::results {

/// Values spread linearly over a length of the drawing; `low` != `high`.
struct Scale {
    double low = 0.0;
    double high = 1.0;
    double from = 0.0;  ///< where `low` lies in the drawing
    double to = 1.0;    ///< where `high` lies
    [[nodiscard]] double operator()(double value) const {
        return from + (to - from) * (value - low) / (high - low);
    }
};

/// Round numbers (1, 2 or 5 times a power of ten apart) within [low, high], at most `most` of them.
[[nodiscard]] std::vector<double> roundTicks(double low, double high, int most);
/// With as many decimals as steps of that size need; a minus sign that is one.
[[nodiscard]] std::string tickText(double value, double step);

class SvgDrawing {
  public:
    /// `id` is unique on the page; title and description are text, not markup.
    SvgDrawing(double width, double height, const std::string& id, const std::string& title,
               const std::string& description);

    void line(double x1, double y1, double x2, double y2, const char* style_class);
    /// `anchor`: start, middle or end.
    void text(double x, double y, const char* anchor, const std::string& text, const char* style_class = "");
    /// Turned by a quarter, reading upwards.
    void textUpwards(double x, double y, const std::string& text);
    void circle(double x, double y, double radius, const std::string& attributes);
    void rectangle(double x, double y, double width, double height, const std::string& attributes);
    void path(const std::string& data, const std::string& attributes);
    void open(const char* style_class);  ///< a group; close() ends it
    void close();

    /// Grid lines, numbers and a name below: a horizontal axis from y_top to y_bottom.
    void axisX(const Scale& scale, double y_top, double y_bottom, const std::string& name, int most_ticks);
    /// The same to the left, the name reading upwards at `name_x`.
    void axisY(const Scale& scale, double x_left, double x_right, double name_x, const std::string& name,
               int most_ticks);

    [[nodiscard]] std::string finish();

  private:
    std::string out_;
};

/// A point as "x y" for a path.
[[nodiscard]] std::string pathPoint(double x, double y);
/// The colour for a share in [0, 1], dark to bright, even in lightness (viridis, by nine of its points).
[[nodiscard]] std::string sharedColour(double share);
/// A vertical bar of that colour map with numbers beside it and a name above.
void colourBar(SvgDrawing& drawing, double x, double y, double height, double low, double high,
               const std::string& name);

}  // namespace deixis::results
