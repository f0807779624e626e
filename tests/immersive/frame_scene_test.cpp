#include "app/window/frame_scene.hpp"

#include <doctest/doctest.h>

#include "text.hpp"

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
            CHECK(tests::unwrapped(board.texts[0].text) == notice);
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

    TEST_CASE("A notice goes where it hides no ball") {
        const Pose eye{{0.3, 1.6, 3.4}, yawRotation(0.7)};
        studies::PresentedFrame frame;
        for (const double y :
             {0.38, 0.2, -0.38})  // of a ball 1 m ahead: behind the usual place, below it, elsewhere
            for (const double x : {0.0, 0.5}) {
                CAPTURE(y);
                CAPTURE(x);
                frame.balls = {{transformPoint(eye, {x, y, -1.0}), 0.05, studies::BallLook::revealed}};
                renderer::Scene scene = sceneFromFrame(frame, eye);
                addNotice(scene, "Not quite: it was the green ball.");
                REQUIRE(scene.boards.size() == 1);
                const renderer::Board& board = scene.boards[0];
                // From the eye through the board's plane to the ball, all around its edge.
                const Pose board_from_eye = inverse(board.stage_from_board) * eye;
                for (int i = 0; i < 16; ++i) {
                    const double angle = 2.0 * pi * i / 16.0;
                    const Vec3 edge(x + 0.07 * std::cos(angle), y + 0.07 * std::sin(angle), -1.0);
                    const Vec3 from = transformPoint(board_from_eye, Vec3(0.0));
                    const Vec3 way = board_from_eye.orientation * edge;
                    const Vec3 at = from + (-from.z / way.z) * way;
                    CHECK((at.x < 0.0 || at.x > board.width_m || at.y < 0.0 || at.y > board.height_m));
                }
                const Vec3 middle =
                    transformPoint(inverse(eye) * board.stage_from_board, {board.width_m / 2.0, 0.0, 0.0});
                CHECK((x == 0.0 && y > 0.3) == (middle.y < 0.0));
            }
    }

    TEST_CASE("The mouse's ray is drawn from the hand to what it meets, but never across a board") {
        studies::PresentedFrame frame;
        const Pose eye{{0.0, 1.6, 0.0}, no_rotation};
        frame.ray = studies::RayView{{eye.position, Vec3(0.0, 0.0, -1.0)}, 3.0};
        REQUIRE(sceneFromFrame(frame, eye).beams.size() == 1);
        const renderer::Beam beam = sceneFromFrame(frame, eye).beams[0];
        CHECK(glm::length(beam.ray.origin - eye.position) > 0.2);
        CHECK(glm::length(beam.ray.origin + beam.length_m * beam.ray.direction - Vec3(0.0, 1.6, -3.0)) <
              1e-9);
        // A board lower right: the ray passes over it, the drawn one would go through it.
        frame.panel = panelWithEverything();
        frame.panel->stage_from_panel.position = {0.0, 1.6 - 0.05 - frame.panel->height_m, -0.8};
        CHECK(sceneFromFrame(frame, eye).beams.empty());
        frame.panel->stage_from_panel.position.x = -3.0;
        CHECK(sceneFromFrame(frame, eye).beams.size() == 1);
        // A controller's ray starts where it is held.
        frame.panel->stage_from_panel.position.x = 0.0;
        frame.ray->ray.origin = {0.3, 1.2, -0.3};
        CHECK(sceneFromFrame(frame, eye).beams.size() == 1);
    }

    TEST_CASE("A second avatar is drawn where there is one, and none, nor a ball, while they are hidden") {
        studies::PresentedFrame frame;
        frame.avatar_joints.resize(3);
        CHECK(sceneFromFrame(frame, {}).avatars.size() == 1);
        frame.right_avatar_joints = frame.avatar_joints;
        frame.right_avatar_joints[0].position.x = 1.0;
        const renderer::Scene both = sceneFromFrame(frame, {});
        REQUIRE(both.avatars.size() == 2);
        CHECK(both.avatars[1][0].position.x == 1.0);
        frame.balls.push_back({Vec3(0.0, 1.0, 1.0), 0.05, studies::BallLook::waiting});
        CHECK(sceneFromFrame(frame, {}).balls.size() == 1);
        frame.scene_visible = false;
        CHECK(sceneFromFrame(frame, {}).avatars.empty());
        CHECK(sceneFromFrame(frame, {}).balls.empty());
    }

    TEST_CASE("Balls are told apart without colours: by lightness, and by no, one or two rings") {
        studies::PresentedFrame frame;
        for (const auto look :
             {studies::BallLook::waiting, studies::BallLook::selectable, studies::BallLook::hovered,
              studies::BallLook::chosen, studies::BallLook::revealed})
            frame.balls.push_back({Vec3(0.0), 0.1, look});
        const renderer::Scene scene = sceneFromFrame(frame, {});
        const std::vector<int> rings{0, 0, 0, 1, 2};
        for (std::size_t i = 0; i < 5; ++i) CHECK(scene.balls[i].rings == rings[i]);
        // Of those without one, each is clearly lighter than the one before it in the order of a trial.
        const auto lightness = [&](std::size_t i) {
            const glm::vec3 light = scene.balls[i].colour + scene.balls[i].glow;
            return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b;
        };
        CHECK(lightness(1) > lightness(0) + 0.5F);
        // Hovered yellow and chosen blue differ in red and green, and in blue: no colour blindness joins
        // them.
        const glm::vec3 hovered = scene.balls[2].colour;
        const glm::vec3 chosen = scene.balls[3].colour;
        CHECK(hovered.r - hovered.b > 0.5F);
        CHECK(chosen.b - chosen.r > 0.5F);
        CHECK(lightness(2) > lightness(3) + 0.4F);
    }
}
