#include "long_table_cells.hpp"

#include <algorithm>

#include "core/csv.hpp"
#include "core/foreign_csv.hpp"
#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis::results {

bool isMissing(const std::string& cell) {
    return cell.empty() || cell == "na" || cell == "nan" || cell == "null";
}

std::optional<bool> truthOf(const std::string& cell) {
    if (cell == "1" || cell == "true" || cell == "yes") return true;
    if (cell == "0" || cell == "false" || cell == "no") return false;
    // Programs that know no missing whole numbers write 1.0.
    const auto value = numberOf(cell);
    if (value && (*value == 0.0 || *value == 1.0)) return *value == 1.0;
    return std::nullopt;
}

std::optional<double> numberOf(const std::string& cell) {
    constexpr std::size_t fits_int = 9;  // digits; most cells are whole numbers of a few
    if (!cell.empty() && cell.size() <= fits_int && std::all_of(cell.begin(), cell.end(), isDigit)) {
        int whole = 0;
        for (const char c : cell) whole = 10 * whole + (c - '0');
        return whole;
    }
    return finiteNumber(cell);
}

NumberCell numberCell(const std::string& cell) {
    if (cell.empty()) return {true};
    if (const auto value = numberOf(cell)) return {false, value};
    const std::string text = plainWord(cell);
    if (const auto point = decimalCommaAsPoint(text)) return {false, finiteNumber(*point), true};
    return {isMissing(text), numberOf(text)};
}

std::string nameIn(const std::string& cell) {
    return std::string(withoutGuard(trimmed(cell)));
}

TruthCell truthCell(const std::string& cell) {
    const std::string text = plainWord(cell);
    return {isMissing(text), truthOf(text)};
}

std::optional<Attention> attentionOf(const std::string& cell) {
    if (isMissing(cell) || cell == "none") return Attention::none;
    if (cell == "passed" || cell == "pass") return Attention::passed;
    if (cell == "failed" || cell == "fail") return Attention::failed;
    if (cell == "check") return Attention::check;
    if (const auto is_check = truthOf(cell)) return *is_check ? Attention::check : Attention::none;
    return std::nullopt;
}

std::string reasonOf(const std::string& cell, const char* word) {
    const std::string lower = plainWord(cell);
    if (isMissing(lower)) return {};
    if (const auto value = truthOf(lower)) return *value ? word : "";
    return std::string(trimmed(cell));
}

}  // namespace deixis::results
