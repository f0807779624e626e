#include "frame_scene.hpp"

#include <doctest/doctest.h>

using namespace deixis;
using namespace deixis::app;

namespace {

studies::Panel panelWithEverything() {
    studies::Panel panel;
    panel.width_m = 1.2;
    panel.height_m = 0.6;
    panel.texts.push_back({{0.1, 0.5, 1.0, 0.05}, "Question"});
    studies::PanelButton button;
    button.box = {0.1, 0.1, 0.2, 0.1};
    button.label = "Yes";
    button.role = studies::ButtonRole::option;
    button.chosen = true;
    panel.buttons.push_back(button);
    studies::PanelSlider slider;
    slider.box = {0.1, 0.25, 0.8, 0.1};
    slider.low = -50;
    slider.high = 50;
    slider.value = 0;
    panel.sliders.push_back(slider);
    studies::PanelField field;
    field.box = {0.1, 0.38, 0.5, 0.1};
    field.text = "21";
    field.active = true;
    panel.fields.push_back(field);
    return panel;
}

}  // namespace

TEST_SUITE("immersive/frame_scene") {
    TEST_CASE("Every part of a panel is on the board: what is chosen, set, typed") {
        studies::PresentedFrame frame;
        frame.panel = panelWithEverything();
        const renderer::Board board = sceneFromFrame(frame, {}).boards.at(0);
        REQUIRE(board.texts.size() == 1);
        REQUIRE(board.buttons.size() == 1);
        CHECK(board.buttons[0].chosen);
        CHECK(board.buttons[0].look == renderer::ButtonLook::option);
        REQUIRE(board.sliders.size() == 1);
        CHECK(board.sliders[0].value == 0.5);
        const studies::PanelRect track = frame.panel->sliders[0].track();
        CHECK(board.sliders[0].track == renderer::BoardRect{track.x, track.y, track.width, track.height});
        REQUIRE(board.fields.size() == 1);
        CHECK(board.fields[0].text == "21");
        CHECK(board.fields[0].active);
        frame.panel->sliders[0].value.reset();
        CHECK_FALSE(sceneFromFrame(frame, {}).boards.at(0).sliders[0].value.has_value());
    }

    TEST_CASE("The panel is the first board, the sign the next; alone the sign is the first") {
        studies::PresentedFrame frame;
        frame.sign = studies::Panel{};
        frame.sign->width_m = 0.3;
        CHECK(sceneFromFrame(frame, {}).boards.at(0).width_m == 0.3);
        frame.panel = panelWithEverything();
        const renderer::Scene scene = sceneFromFrame(frame, {});
        REQUIRE(scene.boards.size() == 2);
        CHECK(scene.boards[0].width_m == 1.2);
        CHECK(scene.boards[1].width_m == 0.3);
    }

    TEST_CASE("A notice stands upright in the upper part of the view, nearer than all else; none, no board") {
        studies::PresentedFrame frame;
        frame.panel = panelWithEverything();
        const Pose eye{{0.3, 1.6, 3.4}, yawRotation(0.7)};
        renderer::Scene scene = sceneFromFrame(frame, eye);
        addNotice(scene, "");
        CHECK(scene.boards.size() == 1);
        for (const std::string notice :
             {"Yes.", "Not quite: the green ball was the target.",
              "A sentence that is much longer than any that is told in passing, so "
              "that it takes two lines."}) {
            CAPTURE(notice);
            renderer::Scene with = scene;
            addNotice(with, notice);
            REQUIRE(with.boards.size() == 2);  // the panel stays the first
            const renderer::Board& board = with.boards[1];
            REQUIRE(board.texts.size() == 1);
            CHECK(board.texts[0].text == notice);
            const Pose eye_from_board = inverse(eye) * board.stage_from_board;
            for (const double x : {0.0, board.width_m})
                for (const double y : {0.0, board.height_m}) {
                    const Vec3 corner = transformPoint(eye_from_board, {x, y, 0.0});
                    const double up_deg = degreesFromRadians(std::atan2(corner.y, -corner.z));
                    CHECK(corner.z < -0.3);
                    CHECK(corner.z > -0.7);
                    CHECK(up_deg > 15.0);
                    CHECK(up_deg < 29.0);  // of 30 that are seen
                    CHECK(std::abs(std::atan2(corner.x, -corner.z)) < radiansFromDegrees(35.0));
                }
        }
    }

    TEST_CASE("A second avatar is drawn where there is one, and none while they are hidden") {
        studies::PresentedFrame frame;
        frame.avatar_joints.resize(3);
        CHECK(sceneFromFrame(frame, {}).avatars.size() == 1);
        frame.right_avatar_joints = frame.avatar_joints;
        frame.right_avatar_joints[0].position.x = 1.0;
        const renderer::Scene both = sceneFromFrame(frame, {});
        REQUIRE(both.avatars.size() == 2);
        CHECK(both.avatars[1][0].position.x == 1.0);
        frame.avatar_visible = false;
        CHECK(sceneFromFrame(frame, {}).avatars.empty());
    }

    TEST_CASE("Only the ball that feedback reveals has a ring") {
        studies::PresentedFrame frame;
        for (const auto look :
             {studies::BallLook::waiting, studies::BallLook::selectable, studies::BallLook::hovered,
              studies::BallLook::chosen, studies::BallLook::revealed})
            frame.balls.push_back({Vec3(0.0), 0.1, look});
        const renderer::Scene scene = sceneFromFrame(frame, {});
        for (std::size_t i = 0; i < 5; ++i) CHECK(scene.balls[i].ring == (i == 4));
    }

    TEST_CASE("A foot line is added under all else, which stays where it is in the world") {
        studies::PresentedFrame frame;
        frame.panel = panelWithEverything();
        const renderer::Board before = sceneFromFrame(frame, {}).boards.at(0);
        for (const std::string words : {"Short.",
                                        "A line of words that is much longer than the board is wide.  It "
                                        "says how to take part, and goes on and on."}) {
            CAPTURE(words);
            renderer::Board after = before;
            addFootLine(after, words);
            const double added = after.height_m - before.height_m;
            CHECK(added > 0.05);
            CHECK(after.stage_from_board.position.y ==
                  doctest::Approx(before.stage_from_board.position.y - added));
            CHECK(after.buttons[0].box.y == doctest::Approx(before.buttons[0].box.y + added));
            CHECK(after.sliders[0].box.y == doctest::Approx(before.sliders[0].box.y + added));
            CHECK(after.sliders[0].track.y == doctest::Approx(before.sliders[0].track.y + added));
            CHECK(after.fields[0].box.y == doctest::Approx(before.fields[0].box.y + added));
            CHECK(after.texts[0].box.y == doctest::Approx(before.texts[0].box.y + added));
            const renderer::BoardText& line = after.texts.back();
            CHECK(line.box.y > 0.0);
            CHECK(line.box.y + line.box.height <= after.buttons[0].box.y);
        }
    }

    TEST_CASE("The controls are told on the first pages and in a pause, and only where there is a board") {
        studies::PresentedFrame frame;
        frame.state = studies::PresentedState::paused;
        CHECK_FALSE(explainsControls(frame));
        frame.panel = studies::Panel{};
        using State = studies::PresentedState;
        for (const State state : {State::instructions, State::consent, State::welcome_back, State::paused}) {
            frame.state = state;
            CHECK(explainsControls(frame));
        }
        for (const State state : {State::questionnaire, State::rating, State::listening, State::over}) {
            frame.state = state;
            CHECK_FALSE(explainsControls(frame));
        }
    }
}
