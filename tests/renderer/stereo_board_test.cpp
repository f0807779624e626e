#include "stereo_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

Board smallQuestionBoard() {
    Board board;
    board.stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
    board.texts = {{{0.05, 0.35, 0.9, 0.1}, "How natural is it?", 0.08, true, true, false}};
    board.buttons = {{{0.1, 0.05, 0.2, 0.15}, "1", "not at all", true, true}};
    return board;
}

double linear(int srgb_byte) {
    const double s = srgb_byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST_SUITE("renderer/board_hole") {
    TEST_CASE("The board is a hole without colour and alpha, and all else is opaque") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = fullScene();
            scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
            const StereoTextures textures(picture_width, picture_height);
            scene.boards.clear();
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                const EyePicture picture = textures.read(eye);
                int not_opaque = 0;
                for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
                    if (picture.rgba[i] != 255) ++not_opaque;
                CHECK(not_opaque == 0);
            }
            scene.boards.resize(1);
            scene.boards[0].stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
            scene.beams.clear();
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                const Eye& seen_by = eyes[static_cast<std::size_t>(eye)];
                const glm::dvec2 low = project(seen_by, {-0.5, 1.45, 1.6}, picture_width, picture_height);
                const glm::dvec2 high = project(seen_by, {0.5, 0.95, 1.6}, picture_width, picture_height);
                const EyePicture picture = textures.read(eye);
                int wrong_inside = 0;
                int wrong_outside = 0;
                for (int y = 0; y < picture_height; ++y)
                    for (int x = 0; x < picture_width; ++x) {
                        const double inside = std::min(std::min(x - low.x, high.x - x - 1.0),
                                                       std::min(y - low.y, high.y - y - 1.0));
                        // The card's corners are round.
                        if (inside > 4.0 && (picture.alpha(x, y) != 0 || picture.colour(x, y).sum() != 0))
                            ++wrong_inside;
                        if (inside < -3.0 && picture.alpha(x, y) != 255) ++wrong_outside;
                    }
                CHECK(wrong_inside == 0);
                CHECK(wrong_outside == 0);
            }
        });
    }

    TEST_CASE("A ball before the board covers it, one behind is covered, and the beam shines before it") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = emptyScene();
            scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
            scene.boards.resize(1);
            scene.boards[0].stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
            scene.balls = {greenBall({-0.2, 1.2, 1.9}, 0.05), greenBall({0.3, 1.2, 1.3}, 0.05)};
            scene.beams = {Beam{{{-0.3, 1.1, 1.8}, Vec3(1.0, 0.0, 0.0)}, 0.6, {1.0F, 0.1F, 0.05F}}};
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
            const StereoTextures textures(picture_width, picture_height);
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                const EyePicture picture = textures.read(eye);
                const auto at = [&](const Vec3& point) {
                    return glm::ivec2(
                        project(eyes[static_cast<std::size_t>(eye)], point, picture_width, picture_height));
                };
                const glm::ivec2 before = at({-0.2, 1.2, 1.9});
                CHECK(picture.alpha(before.x, before.y) == 255);
                CHECK(picture.colour(before.x, before.y).g > 150);
                const glm::ivec2 behind = at({0.3, 1.2, 1.3});
                CHECK(picture.alpha(behind.x, behind.y) == 0);
                CHECK(picture.colour(behind.x, behind.y).sum() == 0);
                const glm::ivec2 beam = at({0.0, 1.1, 1.8});
                const int alpha = picture.alpha(beam.x, beam.y);
                const Bytes red = picture.colour(beam.x, beam.y);
                CHECK(alpha > 60);
                CHECK(red.r > 2 * std::max(red.g, red.b));
                // Premultiplied: no more light than the covered part can send.
                CHECK(linear(red.r) <= alpha / 255.0 + 0.02);
            }
        });
    }
}

TEST_SUITE("renderer/board_copy") {
    TEST_CASE("The board's copy stands upright, its first row at the foot, and shows what the eye sees") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.3}, {0.0, 1.2, 0.0});
        scene.boards = {smallQuestionBoard()};
        const Board& board = scene.boards[0];
        const Image seen = gl.renderer->capture(scene, 960, 720);
        CHECK(gl.renderer->boardPaints() == 1);
        const auto [copy_width, copy_height] = gl.renderer->boardSize(board);
        const BoardRect extent = gl.renderer->boardExtent(board);
        const BoardTexture texture(copy_width + 6, copy_height + 4);
        gl.renderer->copyBoard(board, texture.name());
        CHECK(gl.renderer->boardPaints() == 1);
        // Mean light over places on the board, metres: the question, a hovered button at the foot, the
        // space between, and the free space above the other side's foot.
        for (const BoardRect box : {BoardRect{0.3, 0.36, 0.4, 0.08}, BoardRect{0.12, 0.06, 0.16, 0.13},
                                    BoardRect{0.1, 0.28, 0.8, 0.05}, BoardRect{0.6, 0.06, 0.3, 0.1}}) {
            CAPTURE(box.x);
            double in_copy = 0.0;
            double in_picture = 0.0;
            constexpr int steps = 60;
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const glm::dvec2 p(box.x + box.width * (i + 0.5) / steps,
                                       box.y + box.height * (j + 0.5) / steps);
                    const Bytes copied =
                        texture.at(static_cast<int>((p.x - extent.x) / extent.width * copy_width),
                                   static_cast<int>((p.y - extent.y) / extent.height * copy_height));
                    const Vec3 on_stage = transformPoint(board.stage_from_board, {p.x, p.y, 0.0});
                    in_copy += linear(copied.g);
                    in_picture += linear(pixelAt(seen, scene.camera, on_stage).g);
                }
            in_copy /= steps * steps;
            in_picture /= steps * steps;
            CHECK(in_copy == doctest::Approx(in_picture).epsilon(0.03));
        }
        CHECK(texture.at(copy_width + 2, 10).sum() == 3 * BoardTexture::untouched);
        CHECK(texture.at(10, copy_height + 2).sum() == 3 * BoardTexture::untouched);
    }

    TEST_CASE("The copy's extent says where on the board its pixels lie") {
        Gl gl;
        Board board = smallQuestionBoard();
        board.width_m = 0.9003;  // no whole number of pixels
        board.height_m = 0.4602;
        const std::array<int, 2> size = gl.renderer->boardSize(board);
        const int copy_width = size[0];
        const int copy_height = size[1];
        const BoardRect extent = gl.renderer->boardExtent(board);
        CHECK(extent.width / copy_width == doctest::Approx(extent.height / copy_height));
        CHECK(extent.x < 0.0);
        CHECK(extent.y < 0.0);
        CHECK(extent.x + extent.width > board.width_m);
        CHECK(extent.y + extent.height > board.height_m);
        const BoardTexture texture(copy_width, copy_height);
        gl.renderer->copyBoard(board, texture.name());
        // The card's edges in the middle of its sides, within a pixel.
        const double pixel_m = extent.width / copy_width;
        const auto edge = [&](bool across, bool from_end) {
            const int length = across ? copy_width : copy_height;
            for (int i = 0; i < length; ++i) {
                const int along = from_end ? length - 1 - i : i;
                const int alpha =
                    across ? texture.alpha(along, copy_height / 2) : texture.alpha(copy_width / 2, along);
                if (alpha > 127) return (along + (from_end ? 1 : 0)) * pixel_m;
            }
            return -1.0;
        };
        CHECK(std::abs(extent.x + edge(true, false)) < 1.01 * pixel_m);
        CHECK(std::abs(extent.x + edge(true, true) - board.width_m) < 1.01 * pixel_m);
        CHECK(std::abs(extent.y + edge(false, false)) < 1.01 * pixel_m);
        CHECK(std::abs(extent.y + edge(false, true) - board.height_m) < 1.01 * pixel_m);
    }

    TEST_CASE("Copies and eyes together paint a board once, until its content changes") {
        Gl gl;
        Scene scene = emptyScene();
        scene.boards = {smallQuestionBoard()};
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, 64, 64), 0.064);
        const StereoTextures textures(64, 64);
        const auto [copy_width, copy_height] = gl.renderer->boardSize(scene.boards[0]);
        const BoardTexture texture(copy_width, copy_height);
        for (int i = 0; i < 3; ++i) {
            gl.renderer->drawStereo(scene, eyes, textures.target(), StereoMode::two_passes);
            gl.renderer->copyBoard(scene.boards[0], texture.name());
        }
        CHECK(gl.renderer->boardPaints() == 1);
        scene.boards[0].buttons[0].hovered = false;
        const Bytes hovered = texture.at(copy_width / 4, copy_height / 4);
        gl.renderer->copyBoard(scene.boards[0], texture.name());
        gl.renderer->drawStereo(scene, eyes, textures.target(), StereoMode::two_passes);
        CHECK(gl.renderer->boardPaints() == 2);
        CHECK(texture.at(copy_width / 4, copy_height / 4).sum() + 100 < hovered.sum());
    }
}

TEST_SUITE("renderer/mirror") {
    TEST_CASE("The mirror is black before anything was drawn") {
        Gl gl;
        const Window window(40, 30);
        gl.renderer->drawMirror(emptyScene(), {}, 40, 30, window.name());
        for (const std::uint8_t byte : window.read().rgb) REQUIRE(byte == 0);
    }

    TEST_CASE(
        "The mirror shows what a camera in the left eye's place sees, the board with what stands before "
        "it") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = fullScene();
            scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
            scene.boards = {smallQuestionBoard()};
            scene.balls.push_back(greenBall({-0.1, 1.2, 1.9}, 0.05));
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
            const StereoTextures textures(picture_width, picture_height);
            const Window window(picture_width, picture_height);
            Scene alone = scene;
            alone.camera.stage_from_eye = eyes[0].stage_from_eye;
            const Image expected = drawing.capture(alone, picture_width, picture_height);
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            drawing.drawMirror(scene, eyes[0], picture_width, picture_height, window.name());
            const Difference off = difference(window.read(), expected);
            CHECK(off.mean < 0.5);
            CHECK(off.off_share < 0.02);
        });
    }

    TEST_CASE("A window of another shape shows the picture's middle in its own shape, filled to the edges") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
        scene.balls = {greenBall({0.3, 1.3, 1.0}, 0.1)};
        scene.boards = {smallQuestionBoard()};
        scene.boards[0].stage_from_board.position.x = -0.9;
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, 256, 256), 0.064);
        const StereoTextures textures(256, 256);
        gl.renderer->drawStereo(scene, eyes, textures.target(), StereoMode::two_passes);
        for (const auto& [w, h] : {std::pair{400, 200}, std::pair{120, 240}}) {
            const bool wide = w > h;
            CAPTURE(wide);
            const Window window(w, h);
            gl.renderer->drawMirror(scene, eyes[0], w, h, window.name());
            const Image mirror = window.read();
            // The same by hand: a camera whose height covers what is left of the picture's.
            Scene alone = scene;
            alone.camera.stage_from_eye = eyes[0].stage_from_eye;
            const double slope = std::tan(0.5 * scene.camera.vertical_fov_rad);
            alone.camera.vertical_fov_rad = 2.0 * std::atan(slope * std::min(1.0, double(h) / w));
            const Difference off = difference(mirror, gl.renderer->capture(alone, w, h));
            CHECK(off.mean < 2.5);
            // Smoothed edges differ, places do not.
            CHECK(off.off_share < 0.08);
        }
    }
}
