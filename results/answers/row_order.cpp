#include "row_order.hpp"

#include <algorithm>
#include <tuple>

namespace deixis::results {

void sortByParticipantAndTrial(std::vector<ResponseRow>& rows) {
    std::stable_sort(rows.begin(), rows.end(), [](const ResponseRow& a, const ResponseRow& b) {
        return std::tie(a.participant, a.trial) < std::tie(b.participant, b.trial);
    });
}

}  // namespace deixis::results
