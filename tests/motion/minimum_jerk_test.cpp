#include "motion/skeleton/minimum_jerk.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace deixis::motion;

namespace {

struct Peak {
    double at;
    double speed;
};

/// The peak speed of a course and when it is reached, by central differences.
template <typename Trajectory>
Peak peakOf(Trajectory trajectory) {
    Peak peak{0.0, 0.0};
    constexpr double h = 1e-5;
    for (int i = 1; i < 1000; ++i) {
        const double u = i / 1000.0;
        const double speed = (trajectory(u + h) - trajectory(u - h)) / (2.0 * h);
        if (speed > peak.speed) peak = {u, speed};
    }
    return peak;
}

}  // namespace

TEST_SUITE("motion/minimum_jerk") {
    TEST_CASE("the speed peaks in the middle at 1.875 ways per time") {
        // s'(u) = 30 u^2 (1 - u)^2, which at u = 1/2 is 30/16.
        const Peak peak = peakOf(minimumJerk);
        CHECK(peak.at == doctest::Approx(0.5));
        CHECK(peak.speed == doctest::Approx(1.875).epsilon(1e-6));
    }

    TEST_CASE("the way is done once, evenly about its middle, and stands still outside its time") {
        CHECK(minimumJerk(0.0) == 0.0);
        CHECK(minimumJerk(1.0) == doctest::Approx(1.0));
        CHECK(minimumJerk(-3.0) == 0.0);
        CHECK(minimumJerk(7.0) == doctest::Approx(1.0));
        for (const double u : {0.1, 0.25, 0.4})
            CHECK(minimumJerk(u) + minimumJerk(1.0 - u) == doctest::Approx(1.0));
        CHECK(minimumJerk(0.25) == doctest::Approx(0.103515625));  // (640 - 240 + 24) / 4096
    }

    TEST_CASE("an exponent below one puts the peak of the speed earlier") {
        const Peak peak = peakOf([](double u) { return warpedMinimumJerk(u, 0.9); });
        CHECK(peak.at < 0.48);
        CHECK(peak.at > 0.40);
        CHECK(warpedMinimumJerk(1.0, 0.9) == doctest::Approx(1.0));
    }
}
