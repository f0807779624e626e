#include "core/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace deixis {

namespace {

/// Levenshtein's distance.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

}  // namespace

std::string_view nearestName(std::string_view found, std::span<const std::string_view> names) {
    std::string_view nearest;
    // Two letters that changed places are two edits; of a name as short as "en" nothing would be left.
    std::size_t min = (found.size() < 4 ? 1 : std::max<std::size_t>(2, found.size() / 3)) + 1;
    for (const std::string_view name : names) {
        const std::size_t distance = editDistance(found, name);
        if (distance >= min) continue;
        min = distance;
        nearest = name;
    }
    return nearest;
}

}  // namespace deixis
