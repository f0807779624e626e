#include "number_lines.hpp"

#include <cmath>

#include "assets/joints/decimal.hpp"
#include "core/text.hpp"

namespace deixis::assets {

std::string_view firstLine(std::string_view text) {
    text = trimmed(withoutByteOrderMark(text));
    return trimmed(text.substr(0, text.find('\n')));
}

CsvForm formOfNumbers(std::string_view text) {
    const std::string_view line = firstLine(text);
    for (const char separator : {'\t', ';', ','})
        if (line.find(separator) != std::string_view::npos) return {separator, false, true};
    return {' ', false, true};
}

std::optional<double> finiteNumber(std::string_view field) {
    if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
    double value = 0.0;
    const char* end = field.data() + field.size();
    if (field.empty() || readDecimal(field.data(), end, value) != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string hintOfNumber(std::string_view field) {
    std::string pointed(field);
    if (const auto comma = pointed.find(','); comma != std::string::npos) pointed[comma] = '.';
    if (pointed == field || !finiteNumber(pointed)) return {};
    return "Decimals must have a point: export the file that way";
}

}  // namespace deixis::assets
