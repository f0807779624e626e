// Columns that several of the analysis' tables have, with their cells; private to its tables.
#pragma once

#include <utility>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

/// A signed-rank test.
[[nodiscard]] std::vector<PlainColumn> testColumns();
[[nodiscard]] std::vector<PlainCell> testCells(const AdjustedTest& one);

/// A rank-sum test.
[[nodiscard]] std::vector<PlainColumn> groupColumns();
[[nodiscard]] std::vector<PlainCell> groupCells(const GroupTest& one);

/// Which difference is compared under which levels.
[[nodiscard]] std::vector<PlainColumn> contrastColumns();
template <typename Result>
[[nodiscard]] std::vector<PlainCell> contrastCells(const Result& one) {
    return {one.measure, one.factor, one.a, one.b, one.other_factor, one.c, one.d};
}

/// Columns or cells, and then more of them.
template <typename Item>
[[nodiscard]] std::vector<Item> withMore(std::vector<Item> first, std::vector<Item> more) {
    for (Item& one : more) first.push_back(std::move(one));
    return first;
}

}  // namespace deixis::results
