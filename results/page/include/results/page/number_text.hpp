// Text for the report: escaped for HTML, numbers rounded for reading.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/text.hpp"
#include "results/answers/response_table.hpp"
#include "results/page/templates.hpp"
#include "results/statistics/hodges_lehmann.hpp"

namespace deixis::results {

/// Stands where a number is not defined.
constexpr const char* dash = "–";

/// Tables are numbered in the order in which they stand; so are figures.
class Numbering {
  public:
    explicit Numbering(const char* what = "Table") : what_(what) {}
    std::string next() { return strongHtml(fmt::format("{} {}.", what_, ++last_)); }
    /// The last one's, "Table 3".
    [[nodiscard]] std::string name() const { return fmt::format("{} {}", what_, last_); }

  private:
    const char* what_;
    int last_ = 0;
};

/// "***" for p up to 0.001, "**" up to 0.01, "*" up to 0.05, else p itself.
[[nodiscard]] std::string starsText(double p);

/// "<0.001" or three decimals; pText() is HTML.
[[nodiscard]] std::string pWords(double p);
[[nodiscard]] std::string pText(double p);
[[nodiscard]] std::string pText(const std::optional<double>& p);  ///< a dash if there is none

/// With this many decimals and a proper minus sign, none before zero. Text, which HTML takes as it is.
[[nodiscard]] std::string fixedText(double value, int decimals);

/// A participant's mean, a mean or an SD of a measure: percent with one decimal, or scale points with two.
/// Text, which HTML takes as it is.
[[nodiscard]] std::string scoreText(const Measure& measure, double value);

/// "[1.20, 2.31]", both as scoreText has them.
[[nodiscard]] std::string intervalText(const Measure& measure, double lower, double upper);

/// "1.50 [0.20, 2.00]"; a round bracket where the end itself is rejected. Without an interval the estimate
/// alone, without an estimate a dash. `text` makes the numbers.
[[nodiscard]] std::string shiftText(const HodgesLehmann& shift,
                                    const std::function<std::string(double)>& text);

/// Of the game: "1 of 3 balls" or "1 of 2 to 5 balls".
[[nodiscard]] std::string ballsText(const Measure& measure);

/// "a, b and c"; items are HTML.
[[nodiscard]] std::string inSentence(const std::vector<std::string>& items);
/// "1 participant", "3 participants".
[[nodiscard]] std::string counted(int n, const char* one, const char* many);

}  // namespace deixis::results
