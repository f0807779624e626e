// How long a session will still take.
#include "app/session/time_left.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

using namespace deixis::app;
using deixis::studies::StageProgress;

namespace {

using Stages = std::vector<StageProgress>;
using History = std::map<std::string, double>;

// Sees `units` units of a stage of ten end, one after the other, each after as long.
SessionPace paceOf(const std::string& stage, int units, double each_s) {
    SessionPace pace;
    for (int i = 0; i <= units; ++i) pace.see({{stage, i, 10, true}}, i * each_s, false);
    return pace;
}

}  // namespace

TEST_SUITE("operator/time_left") {
    TEST_CASE("with a history each stage's remaining units take its median") {
        const Stages stages{{"rating", 4, 10, false}, {"game", 0, 20, false}};
        // 6 x 8 s + 20 x 15 s.
        CHECK(*timeLeft_s(stages, {{"rating", 8.0}, {"game", 15.0}}, {}) == doctest::Approx(348.0));
    }

    TEST_CASE("without a history nothing is known until three units were answered here") {
        const Stages stages{{"rating", 2, 10, false}, {"game", 0, 5, false}};
        CHECK_FALSE(timeLeft_s(stages, {}, {}));
        CHECK_FALSE(timeLeft_s(stages, {}, paceOf("rating", 2, 10.0)));
        const auto known =
            timeLeft_s({{"rating", 3, 10, false}, {"game", 0, 5, false}}, {}, paceOf("rating", 3, 10.0));
        REQUIRE(known);
        // The game's units are taken to be like those known: (7 + 5) x 10 s.
        CHECK(*known == doctest::Approx(120.0));
    }

    TEST_CASE("the history of a stage goes before this session's own pace") {
        const SessionPace slow = paceOf("rating", 5, 100.0);
        CHECK(*timeLeft_s({{"rating", 5, 10, false}}, {{"rating", 8.0}}, slow) == doctest::Approx(40.0));
    }

    TEST_CASE("a stage that no earlier session finished goes by this session, else by the other stages") {
        const Stages stages{{"rating", 3, 10, false}, {"new", 0, 4, false}};
        const History history{{"rating", 8.0}, {"game", 10.0}, {"pairs", 30.0}};
        // 7 x 8 s, and 4 at the median of 8, 10 and 30 s.
        CHECK(*timeLeft_s(stages, history, {}) == doctest::Approx(96.0));
        // With three own units of 20 s: 4 at 20 s.
        CHECK(*timeLeft_s(stages, history, paceOf("rating", 3, 20.0)) == doctest::Approx(136.0));
    }

    TEST_CASE("the time left runs down while a unit is under way, but not below what is behind it") {
        SessionPace pace;
        pace.see({{"rating", 0, 2, true}}, 100.0, false);
        const Stages stages{{"rating", 0, 2, true}};
        const History history{{"rating", 60.0}};
        CHECK(*timeLeft_s(stages, history, pace) == doctest::Approx(120.0));
        pace.see(stages, 125.0, false);
        CHECK(*timeLeft_s(stages, history, pace) == doctest::Approx(95.0));
        pace.see(stages, 500.0, false);
        CHECK(*timeLeft_s(stages, history, pace) == doctest::Approx(60.0));
    }

    TEST_CASE("what is all done takes no time, also with more units than were planned") {
        const History history{{"practice", 30.0}};
        CHECK(*timeLeft_s({{"practice", 3, 3, false}, {"end", 1, 0, true}}, history, {}) == 0.0);
        CHECK(*timeLeft_s({{"practice", 6, 3, false}}, history, {}) == 0.0);
    }

    TEST_CASE("pages take as long as those read here") {
        SessionPace pace;
        pace.see({{"welcome", 0, 0, true}, {"rating", 0, 2, false}, {"break", 0, 0, false}}, 0.0, false);
        pace.see({{"welcome", 1, 0, false}, {"rating", 0, 2, true}, {"break", 0, 0, false}}, 40.0, false);
        REQUIRE(pace.pages_s().size() == 1);
        CHECK(pace.pages_s()[0] == doctest::Approx(40.0));
        CHECK(pace.units() == 0);
        const Stages stages{{"welcome", 1, 0, false}, {"rating", 0, 2, true}, {"break", 0, 0, false}};
        CHECK(*timeLeft_s(stages, {{"rating", 10.0}}, pace) == doctest::Approx(60.0));
    }

    TEST_CASE("pauses are no part of what a unit takes") {
        SessionPace pace;
        pace.see({{"rating", 0, 3, true}}, 0.0, false);
        pace.see({{"rating", 0, 3, true}}, 4.0, false);
        pace.see({{"rating", 0, 3, true}}, 304.0, true);
        pace.see({{"rating", 0, 3, true}}, 310.0, false);
        pace.see({{"rating", 1, 3, true}}, 311.0, false);
        REQUIRE(pace.units() == 1);
        CHECK(pace.units_s().at("rating")[0] == doctest::Approx(11.0));
        CHECK(pace.underWay_s() == 0.0);
    }

    TEST_CASE(
        "what an earlier session answered tells nothing of the pace, and a repeated unit starts again") {
        SessionPace pace;
        pace.see({{"rating", 7, 10, true}}, 0.0, false);
        CHECK(pace.units() == 0);
        pace.see({{"rating", 8, 10, true}}, 10.0, false);
        pace.see({{"rating", 7, 10, true}}, 15.0, false);
        CHECK(pace.units() == 1);
        pace.see({{"rating", 8, 10, true}}, 27.0, false);
        REQUIRE(pace.units() == 2);
        CHECK(pace.units_s().at("rating")[1] == doctest::Approx(12.0));
    }
}
