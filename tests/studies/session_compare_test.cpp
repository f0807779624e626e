// Several movements on one page: parallel rating, and pairs.
#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

struct Parallel : Driver {
    explicit Parallel(const Scale& scale, std::size_t stimuli = 3) : Driver({parallelStage(scale)}) {
        std::vector<std::string> systems{"one", "two", "three", "four", "five", "six"};
        systems.resize(stimuli);
        add("parallel", 0, systems);
        start();
        wait(0.6);
    }
};

struct Pair : Driver {
    explicit Pair(std::optional<Question> reasons = std::nullopt, bool with_keyboard = false)
        : Driver({pairStage()}) {
        stage("pairs").reasons = std::move(reasons);
        keyboard = with_keyboard;
        add("pairs", 0, {"one", "two"});
        start();
        wait(0.6);
    }
};

constexpr int sliderId(int stimulus) {
    return button_id::first_slider + stimulus;
}

}  // namespace

TEST_SUITE("studies/session_compare") {
    TEST_CASE("a parallel page is confirmed when every movement was played to its end and rated") {
        Parallel driver(slider(0, 100));
        CHECK(driver.state() == "watching");
        CHECK(driver.session->trialUnderWay() == 0);
        for (const int i : {2, 0}) {
            CHECK_FALSE(sliderOf(driver.frame, sliderId(i))->enabled);
            setSlider(driver, sliderId(i), 30);
            CHECK_MESSAGE(!sliderOf(driver.frame, sliderId(i))->value, "not seen yet");
            REQUIRE(playToEnd(driver, i));
            setSlider(driver, sliderId(i), 30 + i);
            CHECK(sliderOf(driver.frame, sliderId(i))->value == 30 + i);
            CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
        }
        REQUIRE(playToEnd(driver, 1));
        CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
        InputFrame keys;
        keys.confirm = true;
        driver.step(keys);
        CHECK(driver.responses.empty());
        setSlider(driver, sliderId(1), 100);
        setSlider(driver, sliderId(1), 77);
        driver.step();
        REQUIRE(hasButton(driver.frame, button_id::go_on));
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        const Response& response = driver.responses[0];
        CHECK(answerTo(response, "rating", 0) == 30.0);
        CHECK(answerTo(response, "rating", 1) == 77.0);
        CHECK(answerTo(response, "rating", 2) == 32.0);
        CHECK(response.plays == std::vector<int>{1, 1, 1});
        CHECK(response.replays == 0);
        CHECK(response.input == "ray");
        CHECK(response.motion_end.time_s == driver.last(NoteKind::motion_end).at.time_s);
        CHECK(response.response_time_s ==
              doctest::Approx(response.answered.time_s - response.motion_end.time_s));
        CHECK(driver.last(NoteKind::stimulus_onset).detail == "stimulus 1");
    }

    TEST_CASE("steps on a parallel page are pressed, and can be changed until confirmed by key") {
        Parallel driver(five_steps, 2);
        for (const int i : {0, 1}) {
            REQUIRE(playToEnd(driver, i));
            driver.press(button_id::first_option + 100 * i + 4);
            driver.press(button_id::first_option + 100 * i + i);
        }
        driver.step();
        InputFrame keys;
        keys.confirm = true;
        driver.step(keys);
        REQUIRE(driver.responses.size() == 1);
        CHECK(answerTo(driver.responses[0], "rating", 0) == 1.0);
        CHECK(answerTo(driver.responses[0], "rating", 1) == 2.0);
        CHECK(driver.responses[0].input == "key");
    }

    TEST_CASE("while a movement plays no other can be played nor the page confirmed; a replay is counted") {
        Parallel driver(slider(0, 10), 2);
        for (const int i : {0, 1}) {
            REQUIRE(playToEnd(driver, i));
            setSlider(driver, sliderId(i), 5);
        }
        driver.step();
        REQUIRE(hasButton(driver.frame, button_id::go_on));
        driver.press(button_id::first_play);
        CHECK_FALSE(hasButton(driver.frame, button_id::first_play + 1));
        while (driver.count(NoteKind::motion_end) == 2) {
            CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
            InputFrame keys;
            keys.confirm = true;
            driver.step(keys);
        }
        CHECK(driver.responses.empty());
        driver.wait(0.1);
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].replays == 1);
        CHECK(driver.responses[0].plays == std::vector<int>{2, 1});
        CHECK(driver.last(NoteKind::stimulus_onset).detail == "stimulus 0, play 2");
        CHECK(driver.responses[0].onset.time_s == driver.last(NoteKind::stimulus_onset).at.time_s);
    }

    TEST_CASE("a slider follows the ray while select is held, stays at its ends, and stops when let go") {
        Parallel driver(slider(0, 100), 2);
        REQUIRE(playToEnd(driver, 0));
        setSlider(driver, sliderId(0), 50);
        const auto hold = [&](double value, bool held) {
            InputFrame input = driver.pointing(sliderPoint(driver.frame, sliderId(0), value), false);
            input.select_held = held;
            driver.step(input);
            return sliderOf(driver.frame, sliderId(0))->value.value_or(-1);
        };
        CHECK(hold(80, true) == 80);
        CHECK(hold(130, true) == 100);
        CHECK(hold(-50, true) == 0);
        CHECK(hold(20, true) == 20);
        CHECK(hold(60, false) == 20);
        CHECK_MESSAGE(hold(60, true) == 20, "held, but not pressed on it");
    }

    TEST_CASE("a pause on a parallel page keeps what was set, and starts an interrupted movement over") {
        Parallel driver(slider(0, 100), 2);
        REQUIRE(playToEnd(driver, 0));
        setSlider(driver, sliderId(0), 64);
        driver.press(button_id::first_play + 1);
        REQUIRE(driver.waitUntil([&] { return driver.count(NoteKind::stimulus_onset) == 2; }));
        driver.step(pauseFor(PauseReason::headset_taken_off));
        driver.wait(2.0);
        CHECK(driver.count(NoteKind::motion_end) == 1);
        driver.press(button_id::resume);
        CHECK(driver.state() == "waiting");
        CHECK(sliderOf(driver.frame, sliderId(0))->value == 64);
        REQUIRE(driver.waitUntil([&] { return driver.count(NoteKind::motion_end) == 2; }));
        CHECK(driver.count(NoteKind::stimulus_onset) == 3);
        driver.step();
        setSlider(driver, sliderId(1), 10);
        driver.step();
        driver.step(pauseFor(PauseReason::escape));
        const double paused_s = driver.time_s;
        driver.wait(2.0);
        driver.press(button_id::resume);
        const double away_s = driver.time_s - paused_s;
        driver.wait(0.5);
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        const Response& response = driver.responses[0];
        CHECK(answerTo(response, "rating", 0) == 64.0);
        CHECK(answerTo(response, "rating", 1) == 10.0);
        CHECK(response.plays == std::vector<int>{1, 1});
        CHECK(response.pauses == 2);
        CHECK(response.paused_s == doctest::Approx(away_s));
        CHECK(response.response_time_s ==
              doctest::Approx(response.answered.time_s - response.motion_end.time_s - away_s));
    }

    TEST_CASE(
        "a pair stands to either side of the line of sight, and each moves when its button is pressed") {
        Pair driver;
        CHECK(driver.state() == "comparing");
        REQUIRE(driver.frame.right_avatar_joints.size() == driver.frame.avatar_joints.size());
        const auto hand = static_cast<std::size_t>(driver.avatar.find("rightHand"));
        const auto hips = static_cast<std::size_t>(driver.avatar.find("hips"));
        const Vec3 left = driver.frame.avatar_joints[hips].position;
        const Vec3 right = driver.frame.right_avatar_joints[hips].position;
        // The participant stands at +z and looks along -z: to the right is +x.
        CHECK(left.x == doctest::Approx(-0.6));
        CHECK(right.x == doctest::Approx(0.6));
        CHECK(glm::length(right - left - Vec3(1.2, 0.0, 0.0)) < 1e-12);
        const Vec3 left_hand = driver.frame.avatar_joints[hand].position;
        const Vec3 right_hand = driver.frame.right_avatar_joints[hand].position;
        REQUIRE(playToEnd(driver, 1));
        CHECK(glm::length(driver.frame.avatar_joints[hand].position - left_hand) < 1e-12);
        CHECK(glm::length(driver.frame.right_avatar_joints[hand].position - right_hand) > 0.1);
        REQUIRE(playToEnd(driver, 0));
        CHECK(glm::length(driver.frame.avatar_joints[hand].position - left_hand) > 0.1);
    }

    TEST_CASE("a preference opens when both were shown to the end, and is given by button or key") {
        for (const int key : {0, 1, 3, 5}) {
            CAPTURE(key);
            Pair driver;
            CHECK_FALSE(hasButton(driver.frame, button_id::first_rating));
            REQUIRE(playToEnd(driver, 0));
            driver.digit(1);
            CHECK(driver.responses.empty());
            CHECK_FALSE(hasButton(driver.frame, button_id::first_rating));
            REQUIRE(playToEnd(driver, 1));
            REQUIRE(hasButton(driver.frame, button_id::first_rating));
            if (key == 0)
                driver.press(button_id::first_rating + 3);
            else
                driver.digit(key);
            REQUIRE(driver.responses.size() == 1);
            CHECK(answerTo(driver.responses[0], "preference") == (key == 0 ? 1.0 : key - 3.0));
            CHECK(driver.responses[0].input == (key == 0 ? "ray" : "key"));
            CHECK(driver.responses[0].plays == std::vector<int>{1, 1});
            CHECK(driver.state() == "rated");
            CHECK(markedOptions(driver.frame) ==
                  std::vector<int>{button_id::first_rating + (key == 0 ? 3 : key - 1)});
        }
    }

    TEST_CASE("after a preference, but not after a tie, the reasons are asked, and all is kept as one") {
        for (const bool tie : {false, true}) {
            CAPTURE(tie);
            Pair driver(question("why", QuestionKind::choices));
            REQUIRE(playToEnd(driver, 0));
            REQUIRE(playToEnd(driver, 1));
            driver.wait(1.0);
            driver.digit(tie ? 3 : 2);
            const double preferred_s = driver.time_s;
            if (tie) {
                REQUIRE(driver.responses.size() == 1);
                CHECK(driver.responses[0].answers.size() == 1);
                continue;
            }
            CHECK(driver.responses.empty());
            CHECK(driver.state() == "reasons");
            driver.step(pauseFor(PauseReason::escape));
            driver.wait(1.0);
            driver.press(button_id::resume);
            CHECK(driver.state() == "reasons");
            driver.wait(1.0);
            driver.press(button_id::first_option + 2);
            driver.press(button_id::go_on);
            REQUIRE(driver.responses.size() == 1);
            const Response& response = driver.responses[0];
            CHECK(answerTo(response, "preference") == -1.0);
            CHECK(textOf(response, "reasons") == "c");
            CHECK(response.answered.time_s == preferred_s);
            CHECK(response.response_time_s == doctest::Approx(preferred_s - response.motion_end.time_s));
        }
    }

    TEST_CASE("reasons in words are asked only where there is a keyboard") {
        for (const bool keyboard : {false, true}) {
            CAPTURE(keyboard);
            Pair driver(question("why", QuestionKind::text), keyboard);
            REQUIRE(playToEnd(driver, 0));
            REQUIRE(playToEnd(driver, 1));
            driver.digit(5);
            if (keyboard) {
                CHECK(driver.responses.empty());
                driver.wait(0.5);
                type(driver, "smoother");
                InputFrame keys;
                keys.confirm = true;
                driver.step(keys);
            }
            REQUIRE(driver.responses.size() == 1);
            CHECK(textOf(driver.responses[0], "reasons") == (keyboard ? "smoother" : "(none)"));
        }
    }

    TEST_CASE("after a pair one avatar stands at the origin again") {
        Pair driver;
        REQUIRE(carryOnUntil(driver, [&] { return driver.state() == "closing"; }));
        driver.wait(0.5);
        CHECK(driver.frame.right_avatar_joints.empty());
        const auto idle = motion::worldPose(driver.avatar, driver.idle);
        for (std::size_t j = 0; j < idle.size(); ++j)
            CHECK(glm::length(driver.frame.avatar_joints[j].position - idle[j].position) < 1e-9);
    }
}
