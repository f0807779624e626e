// Where the operator's window goes, and how large a mirror is.
#include "operator_place.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "app/operator/mirror_picture.hpp"

using namespace deixis::app;

namespace {

constexpr WindowSize wanted{1280, 800};
constexpr WindowSize min{480, 420};
const ScreenRect full_hd{0, 0, 1920, 1080};

bool apart(const ScreenRect& a, const ScreenRect& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
}

bool inside(const ScreenRect& a, const ScreenRect& room) {
    return a.x >= room.x && a.y >= room.y && a.x + a.width <= room.x + room.width &&
           a.y + a.height <= room.y + room.height;
}

}  // namespace

TEST_SUITE("operator/operator_place") {
    TEST_CASE("on a second monitor the window stands in its middle, and the participant's stays") {
        const ScreenRect second{1920, 0, 2560, 1440};
        const ScreenRect participant{300, 200, 1280, 720};
        const auto places = placesOfWindows(participant, {full_hd, second}, wanted, min, true);
        REQUIRE(places);
        CHECK(places->participant.x == 300);
        CHECK(places->operators.x == 1920 + (2560 - 1280) / 2);
        CHECK(places->operators.y == (1440 - 800) / 2);
        CHECK(places->operators.width == 1280);
    }

    TEST_CASE("a second monitor that is too small is filled; of several the largest is taken") {
        const ScreenRect small{-1024, 0, 1024, 700};
        const auto filled = placesOfWindows(full_hd, {full_hd, small}, wanted, min, false);
        REQUIRE(filled);
        CHECK(filled->operators.x == -1024);
        CHECK(filled->operators.width == 1024);
        CHECK(filled->operators.height == 700);
        const ScreenRect large{1920, 0, 2560, 1440};
        const auto chosen = placesOfWindows(full_hd, {full_hd, small, large}, wanted, min, false);
        REQUIRE(chosen);
        CHECK(chosen->operators.x >= 1920);
    }

    TEST_CASE("a monitor that shows the same as the participant's is not another one") {
        const ScreenRect clone{0, 0, 1280, 720};
        CHECK_FALSE(placesOfWindows(full_hd, {full_hd, clone}, wanted, min, false));
    }

    TEST_CASE("a window that fills the only monitor leaves no room") {
        CHECK_FALSE(placesOfWindows(full_hd, {full_hd}, wanted, min, false));
        CHECK_FALSE(placesOfWindows(full_hd, {full_hd}, wanted, min, true));
        CHECK_FALSE(placesOfWindows(full_hd, {}, wanted, min, true));
    }

    TEST_CASE("on one monitor the participant's window is moved aside to make the room") {
        const ScreenRect participant{320, 180, 1280, 720};
        const auto places = placesOfWindows(participant, {full_hd}, wanted, min, true);
        REQUIRE(places);
        CHECK(places->participant.x == 0);
        CHECK(places->participant.y == 180);
        CHECK(places->operators.x == 1280);
        CHECK(places->operators.y == 180);
        CHECK(places->operators.width == 640);
    }

    TEST_CASE("where there is room enough the participant's window stays") {
        const ScreenRect wide{0, 0, 3840, 2160};
        const ScreenRect participant{2400, 700, 1280, 720};
        const auto places = placesOfWindows(participant, {wide}, wanted, min, true);
        REQUIRE(places);
        CHECK(places->participant.x == 2400);
        CHECK(places->operators.x == 2400 - 1280);
    }

    TEST_CASE("the windows never overlap, and the operator's never leaves its monitor") {
        int placed = 0;
        for (int x = -400; x <= 1900; x += 100)
            for (int y = -200; y <= 1000; y += 150)
                for (const int width : {640, 1280, 1500}) {
                    CAPTURE(x);
                    CAPTURE(y);
                    CAPTURE(width);
                    const ScreenRect participant{x, y, width, 720};
                    const auto places = placesOfWindows(participant, {full_hd}, wanted, min, true);
                    if (!places) continue;
                    ++placed;
                    CHECK(apart(places->participant, places->operators));
                    CHECK(inside(places->operators, full_hd));
                    CHECK(places->operators.width >= min.width);
                }
        CHECK(placed > 100);
    }

    TEST_CASE("a mirror keeps the shape, fits, and is never larger than what it mirrors") {
        const WindowSize half = fittedSize({1920, 1080}, {960, 800});
        CHECK(half.width == 960);
        CHECK(half.height == 540);
        const WindowSize high = fittedSize({1000, 2000}, {960, 500});
        CHECK(high.width == 250);
        CHECK(high.height == 500);
        const WindowSize same = fittedSize({640, 480}, {960, 800});
        CHECK(same.width == 640);
        CHECK(same.height == 480);
        CHECK(fittedSize({8192, 1}, {10, 10}).height == 1);
    }
}
