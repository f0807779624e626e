#include "core/order_statistics.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/random.hpp"

using namespace deixis;

TEST_SUITE("core/order_statistics") {
    TEST_CASE("the median is the middle value, or lies between the middle two") {
        CHECK(median({3.0}) == 3.0);
        CHECK(median({5.0, 1.0, 3.0}) == 3.0);
        CHECK(median({4.0, 1.0, 2.0, 8.0}) == 3.0);
        CHECK(upperMedian({3.0}) == 3.0);
        CHECK(upperMedian({5.0, 1.0, 3.0}) == 3.0);
        CHECK(upperMedian({4.0, 1.0, 2.0, 8.0}) == 4.0);
    }
    TEST_CASE("a value by its rank is the one there after sorting") {
        Random random(1);
        for (std::size_t count = 1; count < 40; ++count) {
            std::vector<double> values;
            for (std::size_t i = 0; i < count; ++i) values.push_back(double(random.below(10)));
            std::vector<double> sorted = values;
            std::sort(sorted.begin(), sorted.end());
            for (std::size_t k = 0; k < count; ++k) REQUIRE(orderStatistic(values, k) == sorted[k]);
            CHECK(median(values) == 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]));
        }
    }
}
