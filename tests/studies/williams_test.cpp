#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "studies/design/plan.hpp"

using namespace deixis::studies;

TEST_SUITE("studies/williams") {
    TEST_CASE("Every condition comes in every place, and after every other one, equally often.") {
        for (int n = 1; n <= 12; ++n) {
            CAPTURE(n);
            const std::vector<std::vector<int>> rows = williamsSquare(n);
            const int expected = n % 2 == 0 ? n : 2 * n;
            REQUIRE(static_cast<int>(rows.size()) == expected);
            std::map<std::pair<int, int>, int> in_place, after;
            for (const std::vector<int>& row : rows) {
                CHECK(std::set<int>(row.begin(), row.end()).size() == static_cast<std::size_t>(n));
                for (int place = 0; place < n; ++place) {
                    ++in_place[{row[place], place}];
                    if (place > 0) ++after[{row[place - 1], row[place]}];
                }
            }
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b) {
                    CHECK(in_place[{a, b}] == expected / n);
                    if (a != b) CHECK(after[{a, b}] == expected / n);
                }
        }
    }

    TEST_CASE("The square of four is the published one.") {
        // Williams (1949); as in textbooks, A B D C / B C A D / C D B A / D A C B.
        CHECK(williamsSquare(4) ==
              std::vector<std::vector<int>>{{0, 1, 3, 2}, {1, 2, 0, 3}, {2, 3, 1, 0}, {3, 0, 2, 1}});
        CHECK(williamsSquare(0).empty());
    }
}
