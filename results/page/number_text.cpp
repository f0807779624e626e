#include "results/page/number_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace deixis::results {

std::string pWords(double p) {
    return p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p);
}

std::string pText(double p) {
    return escapeHtml(pWords(p));
}

std::string starsText(double p) {
    return p <= 0.001 ? "***" : p <= 0.01 ? "**" : p <= 0.05 ? "*" : fmt::format("p = {:.2f}", p);
}

std::string pText(const std::optional<double>& p) {
    return p ? pText(*p) : std::string(dash);
}

std::string fixedText(double value, int decimals) {
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool zero = digits.find_first_not_of("0.") == std::string::npos;
    return (value < 0.0 && !zero ? "\u2212" : "") + digits;
}

std::string scoreText(const Measure& measure, double value) {
    return measure.kind == MeasureKind::accuracy ? fixedText(100.0 * value, 1) + "\u00a0%"
                                                 : fixedText(value, 2);
}

std::string intervalText(const Measure& measure, double lower, double upper) {
    return fmt::format("[{}, {}]", scoreText(measure, lower), scoreText(measure, upper));
}

std::string shiftText(const HodgesLehmann& shift, const std::function<std::string(double)>& text) {
    if (!shift.estimate) return dash;
    if (!shift.lower || !shift.upper) return text(*shift.estimate);
    return fmt::format("{} {}{}, {}{}", text(*shift.estimate), shift.lower_included ? "[" : "(",
                       text(*shift.lower), text(*shift.upper), shift.upper_included ? "]" : ")");
}

std::string ballsText(const Measure& measure) {
    return measure.min_balls < measure.balls
               ? fmt::format("1 of {} to {} balls", measure.min_balls, measure.balls)
               : fmt::format("1 of {} balls", measure.balls);
}

std::string inSentence(const std::vector<std::string>& items) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i)
        out += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    return out;
}

std::string counted(int n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

}  // namespace deixis::results
