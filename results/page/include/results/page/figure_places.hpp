// The space in front of the avatar, from above and from behind: its left on the left, two panels per row.
#pragma once

#include <string>
#include <vector>

#include "core/pose.hpp"
#include "results/page/figure.hpp"

namespace deixis::results {

/// A part of space.
struct SpaceBox {
    Vec3 low{0.0};
    Vec3 high{0.0};

    /// Of at least one place.
    [[nodiscard]] static SpaceBox around(const std::vector<Vec3>& places);
    /// Larger at every side by this share of its length; an axis almost without length gets some.
    [[nodiscard]] SpaceBox widened(double share) const;
};

/// The panels' two views, by what is up in them.
enum class SpaceView : unsigned char {
    above,  ///< z is up
    behind  ///< y is up
};

class SpacePlot {
  public:
    /// `space` has a length along every axis.
    SpacePlot(std::vector<std::string> rows, const SpaceBox& space);

    /// In both panels of a row.
    void point(std::size_t row, const Vec3& at, double value, const std::string& tip);
    /// In both panels, without a value; nothing if it lies outside.
    void dot(std::size_t row, const Vec3& at);
    /// A part of one panel; `low` and `high` need not lie in the space along the view's own axis.
    void cell(std::size_t row, SpaceView view, const Vec3& low, const Vec3& high, double value,
              const std::string& tip);

    /// Values are coloured from `low` to `high`; `format` is that of the legend's numbers. Rows are as high
    /// as the space is in proportion, but not above `max_row_px`.
    [[nodiscard]] FigureJson spec(double low, double high, const char* format, double max_row_px) const;

  private:
    struct Place {
        double x = 0.0, y = 0.0;
    };
    [[nodiscard]] Place placeOf(std::size_t row, SpaceView view, const Vec3& at) const;

    std::vector<std::string> rows_;
    SpaceBox space_;
    FigureJson points_ = FigureJson::array();
    FigureJson dots_ = FigureJson::array();
    FigureJson cells_ = FigureJson::array();
};

/// "x from 2.2 to -2.2 m. From above, ahead is up: z from ...": for a caption.
[[nodiscard]] std::string spaceText(const SpaceBox& space);

}  // namespace deixis::results
