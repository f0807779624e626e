// A table of cells, written as CSV or as LaTeX; private to the analysis' outputs.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "results/tables/csv_table.hpp"
#include "results/tables/table_unit.hpp"

namespace deixis::results {

/// monostate: nothing is known.
using PlainCell = std::variant<std::monostate, std::string, double, long long, bool>;

/// How a column stands in print.
enum class Print : unsigned char {
    no,       ///< in CSV only
    plain,    ///< texts and whole numbers as they are, others with three digits behind the point
    p_value,  ///< "< 0.001" or three digits
    rank,     ///< sums of ranks: whole, or with a half
    range,    ///< "[lower, upper]" of this column and the next
    key,      ///< a text whose underscores stand for spaces
    heading,  ///< a line of its own above the rows that have it in common
};

struct PlainColumn {
    std::string name;
    ColumnType type = ColumnType::text;
    Print print = Print::no;
    std::string heading{};  ///< in print, LaTeX; empty: the name in words
};

struct PlainTable {
    std::string name;  ///< of the file, without its ending
    TableUnit unit;    ///< in CSV a column behind the others, in LaTeX the caption's end
    std::string caption;
    std::vector<PlainColumn> columns;
    std::vector<std::vector<PlainCell>> rows{};
};

[[nodiscard]] PlainCell plainCell(const std::optional<double>& value);
[[nodiscard]] PlainCell knownCell(bool known, double value);
[[nodiscard]] inline PlainCell wholeCell(std::integral auto n) {
    return static_cast<long long>(n);
}

/// Safe for spreadsheets (safeText()).
[[nodiscard]] std::string csvText(const PlainTable& table);

/// A table environment with \toprule, \midrule and \bottomrule, or a longtable where a page cannot hold it;
/// texts are escaped. Smaller, and scaled where it must be, to fit a page of 345 pt (article on A4 or
/// letter).
[[nodiscard]] std::string latexText(const PlainTable& table);

}  // namespace deixis::results
