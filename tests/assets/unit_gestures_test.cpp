#include "assets/data/unit_gestures.hpp"

#include <doctest/doctest.h>

#include <string>

#include "paths.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using motion::Channel;

namespace {

const std::string good = R"([[gesture]]
id = "lift"
name = "Lift"
class = "iconic"
meaning = "Up it goes"
keys = [
    {t = 0.0},
    {t = 0.5, phase = "preparation", both = [0.1, -0.5, 0.5, 10], head = [1, 2, 3]},
    {t = 0.8, phase = "stroke", through = true, right = [0, 0.2, 0.6, 5], shoulders = 7},
    {t = 1.0, phase = "hold", right = [0, 0.2, 0.6, 5], trunk = [4, 5, 6], shoulders = 8},
    {t = 1.6, phase = "retraction"},
]
)";

std::string with(const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::string errorOf(const std::string& text) {
    const auto library = assets::parseUnitGestures(text, "g.toml");
    REQUIRE_FALSE(library.has_value());
    return library.error().text();
}

}  // namespace

TEST_SUITE("assets/unit_gestures") {
    TEST_CASE("A gesture is read as it is written") {
        const auto library = assets::parseUnitGestures(good, "g.toml");
        REQUIRE_MESSAGE(library.has_value(), (library ? "" : library.error().text()));
        REQUIRE(library->size() == 1);
        const motion::UnitGesture& gesture = library->front();
        CHECK(gesture.name == "Lift");
        CHECK(gesture.gesture_class == motion::GestureClass::iconic);
        CHECK(gesture.meaning == "Up it goes");
        CHECK_FALSE(gesture.blended);
        REQUIRE(gesture.keys.size() == 5);
        const auto at = [&](std::size_t key, Channel channel) {
            return gesture.keys[key].channels[motion::indexOf(channel)];
        };
        CHECK(at(1, Channel::left_hand) == motion::ChannelValues{0.1, -0.5, 0.5, 10.0});
        CHECK(at(1, Channel::right_hand) == at(1, Channel::left_hand));
        CHECK(at(1, Channel::head) == motion::ChannelValues{1.0, 2.0, 3.0, 0.0});
        CHECK(gesture.keys[2].through);
        CHECK(gesture.keys[2].phase == motion::GesturePhase::stroke);
        CHECK(at(2, Channel::trunk) == motion::ChannelValues{0.0, 0.0, 0.0, 7.0});
        CHECK_FALSE(at(2, Channel::left_hand).has_value());
        CHECK(at(3, Channel::trunk) == motion::ChannelValues{4.0, 5.0, 6.0, 8.0});
        CHECK(gesture.keys[4].time_s == 1.6);
    }

    TEST_CASE("What is wrong is told with file, line, gesture and key") {
        CHECK(contains(errorOf(with("iconic", "ironic")), "g.toml:1: lift: class: found 'ironic'"));
        CHECK(contains(errorOf(with("meaning", "meeting")), "lift: meeting: unknown key"));
        CHECK(contains(errorOf(with("t = 0.8", "t = 0.4")), "lift: key 2: found it at 0.4 s"));
        CHECK(contains(errorOf(with("t = 0.8, ", "")), "g.toml:9: lift: t: expected a time"));
        CHECK(contains(errorOf(with("\"hold\"", "\"pause\"")), "g.toml:10: lift: phase: found 'pause'"));
        CHECK(contains(errorOf(with("[1, 2, 3]", "[1, 2]")), "lift: head: expected a list of 3 numbers"));
        CHECK(contains(errorOf(with("[1, 2, 3]", "[1, 2, \"x\"]")), "lift: head: expected numbers"));
        CHECK(contains(errorOf(with("head =", "nose =")), "lift: nose: unknown key"));
        CHECK(contains(errorOf(with("head = [1, 2, 3]", "left = [0, 0, 0.5, 0]")), "beside right or left"));
        CHECK(contains(errorOf(with("shoulders = 7", "shoulders = \"up\"")), "shoulders: expected degrees"));
        CHECK(contains(errorOf(with("through = true", "through = 3")), "through: expected true or false"));
        CHECK(contains(errorOf(with("\"Up it goes\"", "\"\"")), "meaning: expected one line"));
        CHECK(
            contains(errorOf(with("[0, 0.2, 0.6, 5]", "[0, 0.9, 0.9, 5]")), "arm lengths from the shoulder"));
        CHECK(contains(errorOf(good + good), "g.toml:13: lift: found this id twice"));
        CHECK(contains(errorOf("x = 1"), "g.toml:1: x: unknown key"));
        CHECK(contains(errorOf("gesture = 1"), "found no [[gesture]]"));
        CHECK(contains(errorOf("gesture = [1]"), "expected [[gesture]]"));
        CHECK(contains(errorOf("[[gesture]"), "not valid TOML"));
        CHECK(contains(errorOf(""), "found no [[gesture]]"));
    }

    TEST_CASE("The library that ships is read; a file that is not there is named") {
        const auto library = assets::loadUnitGestures(tests::sourceDir() / "assets/data/unit_gestures.toml");
        REQUIRE_MESSAGE(library.has_value(), (library ? "" : library.error().text()));
        CHECK(library->size() >= 33);
        CHECK(contains(assets::loadUnitGestures("no/such.toml").error().text(), "no/such.toml"));
    }
}
