#include "board_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

Board questionBoard() {
    Board board;
    board.stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
    board.width_m = 1.0;
    board.height_m = 0.5;
    board.texts.push_back({{0.05, 0.35, 0.9, 0.1}, "How natural is it?", 0.08, true, true, false});
    board.buttons.push_back({{0.1, 0.1, 0.2, 0.15}, "1", "not at all", true, false});
    board.buttons.push_back({{0.6, 0.1, 0.2, 0.15}, "5", "completely", true, false});
    return board;
}

Scene boardScene() {
    Scene scene = emptyScene();
    scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
    scene.boards = {questionBoard()};
    return scene;
}

}  // namespace

TEST_SUITE("renderer/board") {
    TEST_CASE("Text stands bright on the dark card inside its box, and nowhere else") {
        Gl gl;
        Scene scene = boardScene();
        const Region text = region(gl.renderer->capture(scene, board_picture_width, board_picture_height),
                                   scene, {0.1, 0.34, 0.8, 0.1});
        CHECK(text.brightest > 200);
        CHECK(text.darkest < 70);
        const Region bare = region(gl.renderer->capture(scene, board_picture_width, board_picture_height),
                                   scene, {0.05, 0.27, 0.9, 0.05});
        CHECK(bare.brightest < 70);
        scene.boards[0].texts.clear();
        const Region empty = region(gl.renderer->capture(scene, board_picture_width, board_picture_height),
                                    scene, {0.1, 0.34, 0.8, 0.1});
        CHECK(empty.brightest < 70);
    }

    TEST_CASE("A text of accents, dashes and quotes draws every one of them") {
        Gl gl;
        Scene scene = boardScene();
        // Each of these alone leaves bright pixels that differ from a question mark's, which stands for a
        // character that the font lacks.
        std::vector<double> means;
        for (const char* text : {"?", "é", "ß", "–", "—", "“", "…", "Å"}) {
            scene.boards[0].texts = {{{0.3, 0.3, 0.4, 0.18}, text, 0.16, false, true, false}};
            const Region drawn =
                region(gl.renderer->capture(scene, board_picture_width, board_picture_height), scene,
                       {0.3, 0.3, 0.4, 0.18});
            CHECK(drawn.brightest > 190);
            means.push_back(drawn.mean);
        }
        std::sort(means.begin(), means.end());
        CHECK(std::adjacent_find(means.begin(), means.end()) == means.end());
    }

    TEST_CASE("A text has the lines that it is given, one under the other, and no more") {
        Gl gl;
        Scene scene = boardScene();
        scene.boards[0].buttons.clear();
        scene.boards[0].texts = {
            {{0.05, 0.05, 0.5, 0.42}, "mmmm mmmm\nmmmm\n\nmmmm", 0.06, false, false, false}};
        const Image image = gl.renderer->capture(scene, board_picture_width, board_picture_height);
        const auto lit = [&](double x, int line) {
            return region(image, scene, {x, 0.47 - 0.06 * (line + 1) + 0.01, 0.15, 0.04}).brightest > 150;
        };
        CHECK(lit(0.05, 0));
        CHECK(lit(0.25, 0));
        CHECK(lit(0.05, 1));
        CHECK_FALSE(lit(0.27, 1));
        CHECK_FALSE(lit(0.05, 2));
        CHECK(lit(0.05, 3));
        CHECK(region(image, scene, {0.57, 0.05, 0.4, 0.42}).brightest < 70);
    }

    TEST_CASE("A text stands at the top of its box, or in the middle of its height") {
        Gl gl;
        Scene scene = bareBoardScene();
        BoardText text{{0.1, 0.1, 0.8, 0.3}, "mmmmmmmm", 0.06};
        for (const bool level : {false, true}) {
            CAPTURE(level);
            text.level = level;
            scene.boards[0].texts = {text};
            const Image image = boardPicture(gl, scene);
            const Region top = region(image, scene, {0.1, 0.33, 0.8, 0.07});
            const Region middle = region(image, scene, {0.1, 0.22, 0.8, 0.06});
            CHECK((level ? middle : top).brightest > 180);
            CHECK((level ? top : middle).brightest < 60);
        }
    }

    TEST_CASE("Options of one size have labels of one size; another button keeps its own") {
        Gl gl;
        const auto brightness = [&](ButtonLook look, const char* beside) {
            Scene scene = bareBoardScene();
            BoardButton button{{0.05, 0.2, 0.4, 0.12}, "HHHH"};
            button.look = look;
            BoardButton other = button;
            other.box.x = 0.55;
            other.label = beside;
            scene.boards[0].buttons = {button, other};
            return region(boardPicture(gl, scene), scene, {0.19, 0.235, 0.12, 0.05}).mean;
        };
        const char* too_long = "much too long for one";
        CHECK(brightness(ButtonLook::option, too_long) < brightness(ButtonLook::option, "HHHH") - 3.0);
        CHECK(brightness(ButtonLook::plain, too_long) == brightness(ButtonLook::plain, "HHHH"));
    }

    TEST_CASE("A hovered button is clearly brighter than the same button at rest, and its neighbour is not") {
        Gl gl;
        Scene scene = boardScene();
        const BoardRect first = scene.boards[0].buttons[0].box;
        const BoardRect second = scene.boards[0].buttons[1].box;
        const Image rest = gl.renderer->capture(scene, board_picture_width, board_picture_height);
        scene.boards[0].buttons[0].hovered = true;
        const Image hovered = gl.renderer->capture(scene, board_picture_width, board_picture_height);
        CHECK(region(hovered, scene, first).mean > region(rest, scene, first).mean + 60.0);
        CHECK(region(hovered, scene, second).mean == doctest::Approx(region(rest, scene, second).mean));
        scene.boards[0].buttons[0].enabled = false;
        CHECK(region(gl.renderer->capture(scene, board_picture_width, board_picture_height), scene, first)
                  .mean < region(rest, scene, first).mean);
    }

    TEST_CASE("Progress fills the bar from the left") {
        Gl gl;
        Scene scene = boardScene();
        scene.boards[0].progress = 0.5;
        const Image image = gl.renderer->capture(scene, board_picture_width, board_picture_height);
        CHECK(region(image, scene, {0.1, 0.013, 0.3, 0.009}).brightest > 120);
        CHECK(region(image, scene, {0.6, 0.013, 0.3, 0.009}).brightest < 100);
    }

    TEST_CASE("A board whose content stays is painted once, also while it moves; a change paints it again") {
        Gl gl;
        Scene scene = boardScene();
        for (int i = 0; i < 3; ++i) {
            scene.boards[0].stage_from_board.position.x += 0.01;
            static_cast<void>(gl.renderer->capture(scene, 64, 36));
        }
        CHECK(gl.renderer->boardPaints() == 1);
        scene.boards[0].buttons[1].hovered = true;
        static_cast<void>(gl.renderer->capture(scene, 64, 36));
        CHECK(gl.renderer->boardPaints() == 2);
        scene.boards[0].texts[0].text += '!';
        static_cast<void>(gl.renderer->capture(scene, 64, 36));
        CHECK(gl.renderer->boardPaints() == 3);
    }

    TEST_CASE("A ball in front of the board hides it, one behind is hidden") {
        Gl gl;
        Scene scene = boardScene();
        const Vec3 middle(0.0, 1.23, 1.6);
        scene.balls = {{middle + Vec3(0.0, 0.0, 0.3), 0.03, glm::vec3(0.9F), glm::vec3(0.3F)}};
        const Vec3 seen = middle + Vec3(0.0, 0.0, 0.33);
        CHECK(pixelAt(gl.renderer->capture(scene, board_picture_width, board_picture_height), scene.camera,
                      seen)
                  .g > 180);
        scene.balls[0].centre = middle - Vec3(0.0, 0.0, 0.3);
        CHECK(pixelAt(gl.renderer->capture(scene, board_picture_width, board_picture_height), scene.camera,
                      scene.balls[0].centre)
                  .g < 90);
    }
}
