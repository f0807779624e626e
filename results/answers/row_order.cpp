#include "row_order.hpp"

#include <algorithm>
#include <tuple>

namespace deixis::results {

void sortByParticipantAndTrial(std::vector<ResponseRow>& rows) {
    const auto before = [](const ResponseRow& a, const ResponseRow& b) {
        return std::tie(a.participant, a.trial) < std::tie(b.participant, b.trial);
    };
    // Most files are in order, and a row is large.
    if (!std::is_sorted(rows.begin(), rows.end(), before)) std::stable_sort(rows.begin(), rows.end(), before);
}

}  // namespace deixis::results
