#include "pointing_hand.hpp"

#include <doctest/doctest.h>

using namespace deixis;
using namespace deixis::app;
using studies::Hand;

namespace {

constexpr HandButton asleep{};
constexpr HandButton idle{true, false, false, std::nullopt};
constexpr HandButton let_go{true, false, true, std::nullopt};
constexpr HandButton held{true, true, false, std::nullopt};

HandButton pressedAt(double time_s) {
    return {true, true, true, time_s};
}

/// Both devices awake, nothing pressed, the right hand carries the ray.
PointingHand atRest() {
    PointingHand pointing;
    (void)pointing.update({idle, idle});
    return pointing;
}

}  // namespace

TEST_SUITE("headset/pointing_hand") {
    TEST_CASE("The right hand carries the ray at first, and its press selects at the device's time") {
        PointingHand pointing = atRest();
        CHECK(pointing.hand() == Hand::right);
        const auto press = pointing.update({idle, pressedAt(2.5)});
        CHECK(press.select);
        CHECK(press.time_s == 2.5);
        CHECK(pointing.hand() == Hand::right);
    }

    TEST_CASE("A press without a time selects without one") {
        PointingHand pointing = atRest();
        const auto press = pointing.update({idle, {true, true, true, std::nullopt}});
        CHECK(press.select);
        CHECK_FALSE(press.time_s.has_value());
    }

    TEST_CASE("A button that is held selects once, and again only after it was let go") {
        PointingHand pointing = atRest();
        CHECK(pointing.update({idle, pressedAt(1.0)}).select);
        for (int frame = 0; frame < 200; ++frame) CHECK_FALSE(pointing.update({idle, held}).select);
        CHECK_FALSE(pointing.update({idle, let_go}).select);
        CHECK(pointing.update({idle, pressedAt(5.0)}).select);
    }

    TEST_CASE("What was selected is held until the button is let go") {
        PointingHand pointing = atRest();
        CHECK_FALSE(pointing.update({idle, idle}).held);
        CHECK(pointing.update({idle, pressedAt(1.0)}).held);
        CHECK(pointing.update({idle, held}).held);
        CHECK_FALSE(pointing.update({idle, let_go}).held);
        CHECK_FALSE(pointing.update({idle, idle}).held);
    }

    TEST_CASE(
        "Only the hand that selected holds: not one that takes the ray over, woke up pressed or fell "
        "asleep") {
        PointingHand pointing = atRest();
        (void)pointing.update({idle, pressedAt(1.0)});
        CHECK_FALSE(pointing.update({pressedAt(2.0), held}).held);
        CHECK_FALSE(pointing.update({held, held}).held);
        (void)pointing.update({let_go, let_go});
        CHECK(pointing.update({pressedAt(3.0), idle}).held);
        CHECK_FALSE(pointing.update({asleep, idle}).held);
        CHECK_FALSE(pointing.update({held, idle}).held);
    }

    TEST_CASE("A press of both triggers holds nothing") {
        PointingHand pointing = atRest();
        CHECK_FALSE(pointing.update({pressedAt(1.0), pressedAt(1.0)}).held);
        CHECK_FALSE(pointing.update({held, held}).held);
    }

    TEST_CASE("The other hand's press takes the ray and selects nothing; its next one selects") {
        PointingHand pointing = atRest();
        const auto taken = pointing.update({pressedAt(1.0), idle});
        CHECK_FALSE(taken.select);
        CHECK_FALSE(taken.time_s.has_value());
        CHECK(pointing.hand() == Hand::left);
        CHECK_FALSE(pointing.update({held, idle}).select);
        CHECK_FALSE(pointing.update({let_go, idle}).select);
        CHECK(pointing.update({pressedAt(2.0), idle}).select);
        CHECK(pointing.hand() == Hand::left);
    }

    TEST_CASE("Both triggers in one frame select nothing and leave the ray where it is") {
        PointingHand pointing = atRest();
        CHECK_FALSE(pointing.update({pressedAt(1.0), pressedAt(1.001)}).select);
        CHECK(pointing.hand() == Hand::right);
        CHECK_FALSE(pointing.update({held, held}).select);
        CHECK_FALSE(pointing.update({let_go, let_go}).select);
        CHECK(pointing.update({idle, pressedAt(2.0)}).select);
    }

    TEST_CASE("The hand that carries the ray selects while the other's trigger is held") {
        PointingHand pointing = atRest();
        (void)pointing.update({pressedAt(1.0), pressedAt(1.0)});
        (void)pointing.update({held, let_go});
        CHECK(pointing.update({held, pressedAt(2.0)}).select);
        CHECK(pointing.hand() == Hand::right);
    }

    TEST_CASE("While the pointing device sleeps the other carries the ray, and gives it back unused") {
        PointingHand pointing = atRest();
        CHECK_FALSE(pointing.update({idle, asleep}).select);
        CHECK(pointing.hand() == Hand::left);
        (void)pointing.update({idle, idle});
        CHECK(pointing.hand() == Hand::right);
    }

    TEST_CASE("A hand that selected while the other slept keeps the ray") {
        PointingHand pointing = atRest();
        (void)pointing.update({idle, asleep});
        CHECK(pointing.update({pressedAt(1.0), asleep}).select);
        (void)pointing.update({let_go, idle});
        CHECK(pointing.hand() == Hand::left);
    }

    TEST_CASE("A press in the frame in which the ray changes hands selects nothing") {
        PointingHand pointing = atRest();
        CHECK_FALSE(pointing.update({pressedAt(1.0), asleep}).select);
        CHECK(pointing.hand() == Hand::left);
    }

    TEST_CASE("With only a left device the left hand carries the ray from the first frame") {
        PointingHand pointing;
        (void)pointing.update({idle, asleep});
        CHECK(pointing.hand() == Hand::left);
        CHECK(pointing.update({pressedAt(1.0), asleep}).select);
    }

    TEST_CASE("With both devices asleep nothing is selected and the ray stays") {
        PointingHand pointing = atRest();
        CHECK_FALSE(pointing.update({asleep, asleep}).select);
        CHECK(pointing.hand() == Hand::right);
    }

    TEST_CASE("A trigger that is down when its device wakes must be let go before it selects") {
        PointingHand pointing = atRest();
        (void)pointing.update({asleep, asleep});
        CHECK_FALSE(pointing.update({idle, pressedAt(3.0)}).select);  // a runtime calls this a change
        CHECK_FALSE(pointing.update({idle, held}).select);
        CHECK_FALSE(pointing.update({idle, let_go}).select);
        CHECK(pointing.update({idle, pressedAt(4.0)}).select);
    }
}
