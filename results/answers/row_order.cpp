#include "row_order.hpp"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace deixis::results {

namespace {

struct RowKey {
    std::int32_t participant = 0;  ///< rank of the name
    std::int32_t trial = 0;
    std::uint32_t place = 0;  ///< before sorting

    friend auto operator<=>(const RowKey&, const RowKey&) = default;
};

}  // namespace

void sortByParticipantAndTrial(std::vector<ResponseRow>& rows) {
    const auto before = [](const ResponseRow& a, const ResponseRow& b) {
        return a.participant != b.participant ? a.participant < b.participant : a.trial < b.trial;
    };
    if (std::is_sorted(rows.begin(), rows.end(), before)) return;
    // Keys are smaller than rows, and names need not be compared again and again.
    std::unordered_map<Name, std::int32_t> ranks;
    for (const ResponseRow& row : rows) ranks.try_emplace(row.participant);
    std::int32_t rank = 0;
    for (const auto& [name, unranked] : std::map<Name, std::int32_t>(ranks.begin(), ranks.end()))
        ranks[name] = rank++;
    std::vector<RowKey> keys;
    keys.reserve(rows.size());
    for (const ResponseRow& row : rows)
        keys.push_back({ranks[row.participant], row.trial, static_cast<std::uint32_t>(keys.size())});
    std::sort(keys.begin(), keys.end());
    std::vector<ResponseRow> sorted;
    sorted.reserve(rows.size());
    for (const RowKey& key : keys) sorted.push_back(std::move(rows[key.place]));
    rows = std::move(sorted);
}

}  // namespace deixis::results
