// The columns that a statistical test works on, read exactly from a CSV file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "results/statistics/rational.hpp"

namespace deixis::app {

/// Which cells of the file are meant.
struct ColumnChoice {
    std::string file;  ///< "-" for standard input
    /// Wide: the columns' names. Long: those levels of the group column that are wanted, in order; none: all,
    /// in order of appearance.
    std::vector<std::string> columns{};
    std::string group{};      ///< long: the column that tells conditions apart; empty: wide
    std::string value{};      ///< long: the column with the numbers
    std::string paired_by{};  ///< rows that agree in this column are one participant, who gets their mean
};

struct StatsColumn {
    std::string name;
    std::vector<std::optional<results::Rational>> cells{};        ///< none where a value is missing
    [[nodiscard]] std::vector<results::Rational> values() const;  ///< those that are not missing
    [[nodiscard]] int missing() const;
};

struct StatsTable {
    std::string name;  ///< of the file, for errors
    std::vector<StatsColumn> columns{};
    /// Whether cells of the same place belong together: not in a long table without `paired_by`.
    bool paired = true;
    /// Line of each row; empty where rows were joined or shared out.
    std::vector<int> lines{};
    bool decimal_commas = false;  ///< they stand for decimal points
    int rounded = 0;              ///< decimals that were taken as the fractions they were rounded from
};

/// The names in `--columns`: one line of CSV, so that a name with a comma can be quoted.
[[nodiscard]] Result<std::vector<std::string>> parseColumnNames(std::string_view text);

/// The first line holds the columns' names. Cells are decimals or fractions, rounded ones (roundedFraction())
/// of which are taken as what they were rounded from; empty ones, NA, NaN and null (in
/// any case) are missing. In a file of one column an empty line is an empty cell. Errors name file, line and
/// column.
[[nodiscard]] Result<StatsTable> readStatsTable(const ColumnChoice& choice);

/// The rows in which no cell is missing, row by row; the table is paired.
[[nodiscard]] std::vector<std::vector<results::Rational>> completeRows(const StatsTable& table);

}  // namespace deixis::app
