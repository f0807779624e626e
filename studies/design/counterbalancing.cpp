#include "counterbalancing.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

namespace deixis::studies {

namespace {

using Rows = std::vector<std::vector<int>>;

/// All combinations, in an order of which every beginning is balanced: each factor's levels come equally
/// often to within one, and so do the combinations of the last two factors.
Rows balancedCombinations(std::span<const int> levels) {
    if (levels.empty()) return {{}};
    const Rows rest = balancedCombinations(levels.subspan(1));
    const int n = levels.front();
    const int others = static_cast<int>(rest.size());
    const int round = std::lcm(n, others);
    Rows out;
    for (int k = 0; k < n * others; ++k) {
        // Both run in a circle; after each round, when the same pairs would come again, this one steps on.
        std::vector<int> row{(k + k / round) % n};
        const std::vector<int>& tail = rest[k % others];
        row.insert(row.end(), tail.begin(), tail.end());
        out.push_back(std::move(row));
    }
    return out;
}

/// How uneven the combinations of two factors are: least where each comes equally often.
long unevenness(const Rows& rows, const std::vector<int>& levels) {
    long sum = 0;
    std::vector<long> seen;
    for (std::size_t f = 0; f < levels.size(); ++f)
        for (std::size_t g = 0; g < f; ++g) {
            const int combinations = levels[f] * levels[g];
            seen.assign(combinations, 0);
            for (const std::vector<int>& row : rows) ++seen[row[f] * levels[g] + row[g]];
            // Weighted, so that an excess counts alike in few combinations and in many.
            for (const long count : seen) sum += combinations * count * count;
        }
    return sum;
}

/// Exchanges single levels between items as long as that evens out the combinations of two factors; how
/// often a level comes stays as it is.
void evenOut(Rows& rows, const std::vector<int>& levels) {
    long min = unevenness(rows, levels);
    for (bool better = true; better;) {
        better = false;
        for (std::size_t f = 0; f < levels.size(); ++f)
            for (std::size_t i = 0; i < rows.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) {
                    if (rows[i][f] == rows[j][f]) continue;
                    std::swap(rows[i][f], rows[j][f]);
                    const long now = unevenness(rows, levels);
                    if (now < min) {
                        min = now;
                        better = true;
                    } else {
                        std::swap(rows[i][f], rows[j][f]);
                    }
                }
    }
}

}  // namespace

std::vector<std::vector<int>> counterbalanceLevels(const std::vector<int>& levels, int count,
                                                   Random& random) {
    const Rows combinations = balancedCombinations(levels);
    Rows rows;
    for (int k = 0; k < count; ++k) rows.push_back(combinations[k % combinations.size()]);
    if (std::count_if(levels.begin(), levels.end(), [](int n) { return n > 1; }) > 2) evenOut(rows, levels);

    for (std::size_t f = 0; f < levels.size(); ++f) {  // which level is which
        std::vector<int> names(levels[f]);
        std::iota(names.begin(), names.end(), 0);
        random.shuffle(std::span<int>(names));
        for (std::vector<int>& row : rows) row[f] = names[row[f]];
    }
    random.shuffle(std::span<std::vector<int>>(rows));
    return rows;
}

}  // namespace deixis::studies
