#include "number_lines.hpp"

#include <algorithm>
#include <cmath>

#include "assets/joints/decimal.hpp"
#include "core/text.hpp"

namespace deixis::assets {

std::optional<std::string_view> TextLines::next() {
    while (!text_.empty()) {
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        std::string_view row = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        ++line_;
        if (!row.empty() && row.back() == '\r') row.remove_suffix(1);
        // A tab at either end may stand for an empty field.
        if (!trimmed(row).empty()) return row;
    }
    return std::nullopt;
}

void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    if (separator != ' ') {
        for (;;) {
            const std::size_t end = line.find(separator);
            fields.push_back(trimmed(line.substr(0, end)));
            if (end == std::string_view::npos) return;
            line.remove_prefix(end + 1);
        }
    }
    line = trimmed(line);
    while (!line.empty()) {
        const auto end = std::find_if(line.begin(), line.end(), isBlank);
        fields.push_back(line.substr(0, static_cast<std::size_t>(end - line.begin())));
        line.remove_prefix(fields.back().size());
        line = trimmed(line);
    }
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

char separatorOf(std::string_view line) {
    for (const char separator : {'\t', ';', ','})
        if (trimmed(line).find(separator) != std::string_view::npos) return separator;
    return ' ';
}

}  // namespace deixis::assets
