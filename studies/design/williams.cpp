// Orders of blocks in which carry-over from one condition to the next evens out.
#include "studies/design/plan.hpp"

namespace deixis::studies {

std::vector<std::vector<int>> williamsSquare(int n) {
    // The first row zigzags, 0, 1, n-1, 2, n-2, ..., so that its steps are all the differences modulo n; the
    // others add 1 each. Where n is odd each step comes twice and its opposite never: the mirrored rows mend
    // that.
    std::vector<std::vector<int>> rows;
    for (int shift = 0; shift < n; ++shift) {
        std::vector<int> row;
        for (int place = 0; place < n; ++place) {
            const int zigzag = place % 2 == 1 ? (place + 1) / 2 : n - place / 2;
            row.push_back((zigzag + shift) % n);
        }
        rows.push_back(std::move(row));
    }
    if (n % 2 == 1)
        for (int i = 0; i < n; ++i) rows.emplace_back(rows[i].rbegin(), rows[i].rend());
    return rows;
}

}  // namespace deixis::studies
