#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "session_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

}  // namespace

TEST_SUITE("studies/session") {
    TEST_CASE(
        "a whole session asks every scored trial once, in the plan's order, with its pages in between") {
        Driver driver(2);
        driver.start();
        REQUIRE(driver.finish());

        std::vector<int> expected;
        for (const Trial& trial : driver.plan.trials)
            if (!trial.practice) expected.push_back(trial.index);
        std::vector<int> asked;
        for (const Response& response : driver.responses) asked.push_back(response.trial_index);
        CHECK(asked == expected);

        std::vector<std::string> pages_read;
        for (const Note& note : driver.notes)
            if (note.kind != NoteKind::stimulus_onset && note.kind != NoteKind::motion_end)
                pages_read.push_back(std::string(noteKindName(note.kind)) +
                                     (note.detail.empty() ? "" : ": " + note.detail));
        // Rating has a break after two of its four trials, the game none.
        const std::vector<std::string> wanted{"session_start",
                                              "stage_start: welcome",
                                              "instructions_read: welcome",
                                              "stage_start: naturalness-instructions",
                                              "instructions_read: naturalness-instructions",
                                              "stage_start: naturalness-practice",
                                              "stage_start: naturalness-begin",
                                              "instructions_read: naturalness-begin",
                                              "stage_start: naturalness",
                                              "break_start",
                                              "break_end",
                                              "stage_start: game-instructions",
                                              "instructions_read: game-instructions",
                                              "stage_start: game-practice",
                                              "stage_start: game-begin",
                                              "instructions_read: game-begin",
                                              "stage_start: game",
                                              "stage_start: goodbye",
                                              "instructions_read: goodbye",
                                              "finished"};
        CHECK(joined(pages_read) == joined(wanted));
        CHECK(driver.count(NoteKind::stimulus_onset) == 10);
        CHECK(driver.count(NoteKind::motion_end) == 10);
        CHECK(driver.practised.size() == 2);
        CHECK(driver.practised[1].trial_index == 5);
    }

    TEST_CASE("an answer records what was done: rating, place, correctness, times, pose and ray") {
        Driver driver(1, 1.0, false);
        driver.display_delay_s = 0.011;
        driver.start();
        REQUIRE(driver.toAnswer());
        driver.wait(0.8);
        driver.press(button_id::first_rating + 3);
        REQUIRE(driver.responses.size() == 1);
        const Response& rating = driver.responses[0];
        CHECK(ratingOf(rating) == 4);
        CHECK(rating.chosenPlace() == -1);
        CHECK(rating.input == "ray");
        CHECK(rating.pointer.has_value());
        CHECK(rating.stage_from_head.position.y == doctest::Approx(1.65));
        CHECK(rating.answered.time_s == driver.time_s);
        CHECK(rating.answered.utc_s == doctest::Approx(driver.time_s + 1.0e9));
        CHECK(rating.response_time_s == doctest::Approx(rating.answered.time_s - rating.motion_end.time_s));
        // The clip lasts a second from the display time of its first frame; at 60 Hz its end shows within a
        // frame.
        const double played_s = rating.motion_end.time_s - rating.onset.time_s;
        CHECK(played_s >= 1.0 - 1e-9);
        CHECK(played_s <= 1.0 + 2.5 * driver.frame_time_s);

        REQUIRE(driver.toAnswer());
        driver.digit(2);
        CHECK(ratingOf(driver.responses.back()) == 2);
        CHECK(driver.responses.back().input == "key");

        for (const int place : {0, 1}) {
            REQUIRE(driver.toAnswer());
            const Trial& trial = driver.plan.trials[driver.responses.size()];
            driver.choose(place);
            const Response& choice = driver.responses.back();
            CHECK(ratingOf(choice) == 0);
            CHECK(choice.chosenPlace() == place);
            CHECK(choice.correct() == (trial.ball_order[static_cast<std::size_t>(place)] == 0));
        }
    }

    TEST_CASE("while the motion plays the balls are black, there is no ray, and nothing can be answered") {
        Driver driver(1, 1.0, false);
        driver.start(std::set<int>{0, 1});
        REQUIRE(driver.leavePage());
        REQUIRE(driver.leavePage());
        int frames = 0;
        while (!answersOpen(driver.frame)) {
            REQUIRE(driver.frame.balls.size() == 3);
            for (const BallView& ball : driver.frame.balls) CHECK(ball.look == BallLook::waiting);
            CHECK_FALSE(driver.frame.ray.has_value());
            InputFrame eager = driver.pointing(driver.frame.balls[1].centre, true);
            eager.digit = 2;
            driver.step(eager);
            ++frames;
        }
        CHECK(frames > 60);
        CHECK(driver.responses.empty());
        for (const BallView& ball : driver.frame.balls) CHECK(ball.look != BallLook::waiting);
    }

    TEST_CASE("a select in the frame that opens the answer, or before that frame was shown, does not count") {
        Driver driver(1, 0.5, false);
        driver.start(std::set<int>{0, 1});
        driver.leavePage();
        driver.leavePage();
        while (!answersOpen(driver.frame))
            driver.step(driver.pointing(driver.plan.trials[2].ball(0), true),
                        driver.count(NoteKind::motion_end) == 0);
        CHECK(driver.responses.empty());
        driver.step(driver.pointing(driver.frame.balls[0].centre, true), false);
        CHECK(driver.responses.empty());
        driver.step(driver.pointing(driver.frame.balls[0].centre, false));
        CHECK(driver.responses.empty());
        driver.step();  // the ray has rested on the ball since before the choice opened, and leaves it now
        driver.choose(0);
        CHECK(driver.responses.size() == 1);
    }

    TEST_CASE(
        "hovering lights the nearest ball on the ray, selecting beside the balls does nothing, the choice is "
        "shown") {
        Driver driver(1, 0.5, false);
        driver.plan.trials[2].layout = "across";
        // Place the second ball straight behind the first as seen from the participant.
        Trial& trial = driver.plan.trials[2];
        trial.ball_order = {0, 1, 2};
        const Vec3 eye(0.0, 1.65, 3.4);
        trial.distractors[0] = eye + 1.3 * (trial.target - eye);
        driver.start(std::set<int>{0, 1});
        REQUIRE(driver.toAnswer());
        driver.step(driver.pointing(driver.frame.balls[1].centre, false));
        CHECK(driver.frame.balls[0].look == BallLook::hovered);
        CHECK(driver.frame.balls[1].look == BallLook::selectable);
        REQUIRE(driver.frame.ray.has_value());
        CHECK(driver.frame.ray->length_m == doctest::Approx(glm::length(trial.target - eye) - 0.05));

        driver.step(driver.pointing(Vec3(-1.0, 1.0, 0.0), true));
        CHECK(driver.responses.empty());
        driver.digit(1);
        CHECK_MESSAGE(driver.responses.empty(),
                      "a ball's place cannot be seen, so no number can mean a ball");

        driver.choose(2);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].chosenPlace() == 2);
        CHECK(driver.frame.balls[2].look == BallLook::chosen);
        CHECK_FALSE(driver.frame.ray.has_value());
        const double answered_s = driver.time_s;
        REQUIRE(driver.waitUntil(
            [&] { return driver.frame.balls.empty() || driver.frame.balls[2].look != BallLook::chosen; }));
        CHECK(driver.time_s - answered_s == doctest::Approx(0.35).epsilon(0.06));
    }

    TEST_CASE("the onset waits for a frame that was really shown, and the clip starts there") {
        Driver driver(1, 1.0, false);
        driver.start();
        driver.leavePage();
        driver.leavePage();
        // All frames of the first second after the pause are dropped.
        for (int i = 0; i < 150; ++i) {
            driver.step({}, false);
            CHECK(driver.count(NoteKind::stimulus_onset) == 0);
        }
        const auto expected = motion::worldPose(driver.avatar, driver.clips.clip({}).frames[0]);
        const auto hand = static_cast<std::size_t>(driver.avatar.find("rightHand"));
        CHECK(glm::length(driver.frame.avatar_joints[hand].position - expected[hand].position) < 1e-12);

        driver.display_delay_s = 0.02;
        driver.step();
        REQUIRE(driver.count(NoteKind::stimulus_onset) == 1);
        CHECK(driver.last(NoteKind::stimulus_onset).at.time_s == doctest::Approx(driver.time_s + 0.02));
        CHECK(driver.last(NoteKind::stimulus_onset).at.utc_s ==
              doctest::Approx(driver.time_s + 0.02 + 1.0e9));
        driver.wait(0.5);
        const double clip_s = driver.time_s - driver.last(NoteKind::stimulus_onset).at.time_s;
        const auto half = motion::worldPose(driver.avatar, motion::sample(driver.clips.clip({}), clip_s));
        CHECK(glm::length(driver.frame.avatar_joints[hand].position - half[hand].position) < 1e-9);
    }

    TEST_CASE("the avatar stands at ease between clips and never jumps") {
        Driver driver(2, 1.0, false);
        driver.start();
        std::vector<Pose> before;
        double max_m = 0.0;
        int answers = 0;
        while (!driver.finished()) {
            if (answersOpen(driver.frame))
                driver.answerSomehow(++answers);
            else if (resting(driver.frame) && driver.count(NoteKind::pause) == 0) {
                InputFrame confirm;
                confirm.confirm = true;
                driver.step(confirm);
            } else {
                driver.step();
            }
            if (!before.empty())
                for (std::size_t j = 0; j < before.size(); ++j)
                    max_m = std::max(
                        max_m, glm::length(driver.frame.avatar_joints[j].position - before[j].position));
            before = driver.frame.avatar_joints;
        }
        CHECK(driver.responses.size() == 8);
        CHECK(max_m > 0.01);
        CHECK(max_m < 0.09);
        const auto idle = motion::worldPose(driver.avatar, driver.idle);
        for (std::size_t j = 0; j < idle.size(); ++j)
            CHECK(glm::length(driver.frame.avatar_joints[j].position - idle[j].position) < 1e-9);
    }

    TEST_CASE(
        "the viewer stands in the trial's layout and is moved only between trials, with time to orient") {
        Driver driver(2, 0.5, false);
        driver.start(std::set<int>{0, 1, 2, 3});
        driver.leavePage();
        std::string place;
        bool was_open = false;
        int moves = 0;
        while (!driver.finished()) {
            if (!driver.frame.balls.empty()) {
                if (!place.empty() && place != driver.frame.viewer_place) {
                    ++moves;
                    CHECK_FALSE(was_open);
                    const double moved_s = driver.time_s;
                    const int onsets = driver.count(NoteKind::stimulus_onset);
                    REQUIRE(
                        driver.waitUntil([&] { return driver.count(NoteKind::stimulus_onset) > onsets; }));
                    CHECK(driver.time_s - moved_s >= 1.2 - 1e-9);
                    CHECK(driver.time_s - moved_s < 1.3);
                }
                place = driver.frame.viewer_place;
                const Vec3 forward = driver.frame.stage_from_viewer.orientation * Vec3(0.0, 0.0, -1.0);
                const bool across = place == "across";
                CHECK(glm::length(forward - Vec3(0.0, 0.0, across ? -1.0 : 1.0)) < 1e-12);
                CHECK(driver.frame.stage_from_viewer.position.z == (across ? 3.4 : -0.2));
            }
            was_open = answersOpen(driver.frame);
            if (was_open)
                driver.answerSomehow(0);
            else if (resting(driver.frame))
                driver.leavePage();
            else
                driver.step();
        }
        CHECK(moves == 3);
    }

    TEST_CASE("a short first paragraph of the instructions is their title") {
        Driver driver(1);
        driver.stage("naturalness-instructions").text = "Part 1: how natural?\n\nWatch and rate.";
        driver.start();
        driver.leavePage();
        CHECK(driver.frame.panel->texts[0].text == "Part 1: how natural?");
        CHECK(driver.frame.panel->texts[1].text == "Watch and rate.");
        CHECK(driver.frame.panel->texts[2].text == driver.stage("naturalness").question);
    }

    TEST_CASE("pages cannot be skipped by a double click, and go on by ray or by key") {
        Driver driver(1);
        driver.start();
        driver.step();
        driver.press(button_id::go_on);
        CHECK(driver.count(NoteKind::instructions_read) == 0);
        driver.wait(0.5);
        driver.press(button_id::go_on);
        CHECK(driver.count(NoteKind::instructions_read) == 1);
        driver.press(button_id::go_on);
        CHECK(driver.count(NoteKind::instructions_read) == 1);
        driver.wait(0.5);
        InputFrame confirm;
        confirm.confirm = true;
        driver.step(confirm);
        CHECK(driver.count(NoteKind::instructions_read) == 2);
    }

    TEST_CASE("the clip can be seen again as often as the study allows, and each time counts") {
        Driver driver(1, 0.5, false);
        driver.stage("naturalness").max_replays = 2;
        driver.start();
        REQUIRE(driver.toAnswer());
        for (int i = 0; i < 2; ++i) {
            REQUIRE(hasButton(driver.frame, button_id::replay));
            driver.press(button_id::replay);
            CHECK_FALSE(answersOpen(driver.frame));
            REQUIRE(driver.toAnswer());
        }
        CHECK_FALSE(hasButton(driver.frame, button_id::replay));
        CHECK(driver.count(NoteKind::stimulus_onset) == 3);
        driver.press(button_id::first_rating);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].replays == 2);
        CHECK(driver.responses[0].onset.time_s == driver.last(NoteKind::stimulus_onset).at.time_s);

        driver.stage("game").max_replays = 1;
        driver.press(button_id::first_rating);
        REQUIRE(driver.toAnswer());
        driver.press(button_id::first_rating);
        REQUIRE(driver.toAnswer());
        REQUIRE(driver.frame.balls.size() == 3);
        driver.press(button_id::replay);
        REQUIRE(driver.toAnswer());
        CHECK_FALSE(driver.frame.panel.has_value());
        driver.choose(0);
        CHECK(driver.responses.back().replays == 1);
    }
}
