#include "core/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

using deixis::Random;

TEST_SUITE("core/random") {
    TEST_CASE("the generator is xoshiro256** seeded through splitmix64") {
        // Worked apart in Python from the published algorithms (prng.di.unimi.it), seed 42.
        Random random(42);
        CHECK(random.next() == 1546998764402558742ULL);
        CHECK(random.next() == 6990951692964543102ULL);
        CHECK(random.next() == 12544586762248559009ULL);
    }

    TEST_CASE("a labelled generator does not depend on what others drew") {
        Random a(7, "targets");
        Random other(7, "orders");
        (void)other.next();
        Random b(7, "targets");
        CHECK(a.next() == b.next());
        CHECK(Random(7, "targets").next() != Random(7, "orders").next());
        CHECK(Random(7, "targets").next() != Random(8, "targets").next());
    }

    TEST_CASE("below gives every value about equally often") {
        Random random(3);
        std::array<int, 7> counts{};
        constexpr int draws = 70000;
        for (int i = 0; i < draws; ++i) ++counts[random.below(7)];
        double chi2 = 0.0;
        for (const int count : counts) chi2 += (count - 10000.0) * (count - 10000.0) / 10000.0;
        CHECK(chi2 < 22.5);  // 0.999 quantile of chi-squared with 6 degrees of freedom
    }

    TEST_CASE("uniform and normal numbers have the moments they should have") {
        Random random(5);
        constexpr int n = 100000;
        double sum = 0.0, sum2 = 0.0, low = 1.0, high = 0.0;
        for (int i = 0; i < n; ++i) {
            const double u = random.uniform();
            low = std::min(low, u);
            high = std::max(high, u);
        }
        CHECK(low >= 0.0);
        CHECK(high < 1.0);
        for (int i = 0; i < n; ++i) {
            const double x = random.normal(2.0, 3.0);
            sum += x;
            sum2 += x * x;
        }
        const double mean = sum / n;
        CHECK(mean == doctest::Approx(2.0).epsilon(0.02));
        CHECK(std::sqrt(sum2 / n - mean * mean) == doctest::Approx(3.0).epsilon(0.02));
    }

    TEST_CASE("shuffling three things gives the six orders about equally often") {
        std::array<int, 6> counts{};
        Random random(11);
        for (int i = 0; i < 60000; ++i) {
            std::vector<int> items{0, 1, 2};
            random.shuffle(std::span<int>(items));
            ++counts[static_cast<std::size_t>(items[0] * 2 + (items[1] > items[2] ? 1 : 0))];
        }
        double chi2 = 0.0;
        for (const int count : counts) chi2 += (count - 10000.0) * (count - 10000.0) / 10000.0;
        CHECK(chi2 < 20.5);  // 0.999 quantile, 5 degrees of freedom
    }
}
