#include "stereo_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

constexpr int width = 320;
constexpr int height = 240;

/// Avatar, balls and beam.
Scene fullScene() {
    Scene scene = emptyScene();
    scene.avatar_visible = true;
    scene.avatar_joints = postPose();
    scene.balls = {{{0.5, 1.3, 0.4}, 0.1, glm::vec3(0.9F), {}},
                   {{-0.4, 1.1, 0.9}, 0.08, glm::vec3(0.02F), {}}};
    scene.beam = Beam{{{0.3, 1.2, 2.4}, glm::normalize(Vec3(0.2, 0.1, -2.0))}, 1.9, {1.0F, 0.1F, 0.05F}};
    return scene;
}

Board questionBoard() {
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

TEST_SUITE("renderer/stereo") {
    TEST_CASE("Each eye sees what a camera in its place sees") {
        Gl gl(4);
        const Scene scene = fullScene();
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, width, height), 0.064);
        const StereoTextures textures(width, height);
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            CAPTURE(nameOf(mode));
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(eye);
                Scene alone = scene;
                alone.camera.stage_from_eye = eyes[static_cast<std::size_t>(eye)].stage_from_eye;
                const Image expected = gl.renderer->capture(alone, width, height);
                const Difference off = difference(textures.read(eye).image(), expected);
                CHECK(off.mean < 0.05);
                CHECK(off.off_share < 0.001);
            }
        }
    }

    TEST_CASE("Both ways of drawing give the same two pictures, also in turns and at other sizes") {
        Gl gl(4);
        if (stereoModes(*gl.renderer).size() < 2) return;
        const Scene scene = fullScene();
        for (const auto& [w, h] : {std::pair{160, 120}, std::pair{201, 133}, std::pair{160, 120}}) {
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, w, h), 0.064);
            const StereoTextures one_by_one(w, h);
            const StereoTextures together(w, h);
            gl.renderer->drawStereo(scene, eyes, one_by_one.target(), StereoMode::two_passes);
            gl.renderer->drawStereo(scene, eyes, together.target(), StereoMode::multiview);
            for (int eye = 0; eye < 2; ++eye) {
                const Difference off = difference(one_by_one.read(eye).image(), together.read(eye).image());
                CHECK(off.mean < 0.05);
                CHECK(off.off_share < 0.001);
            }
        }
    }

    TEST_CASE("The left eye sees a near ball farther to the right than the right eye, by its distance") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 1.4, 3.0}, {0.0, 1.4, 0.0});
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, width, height), 0.064);
        const double pixels_per_slope = 0.5 * height / std::tan(0.5 * scene.camera.vertical_fov_rad);
        const StereoTextures textures(width, height);
        for (const StereoMode mode : stereoModes(*gl.renderer))
            for (const double distance_m : {0.6, 2.5}) {
                CAPTURE(nameOf(mode));
                CAPTURE(distance_m);
                scene.balls = {greenBall({0.0, 1.4, 3.0 - distance_m}, 0.04 * distance_m)};
                gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
                const double shift = middleOfGreen(textures.read(0)).x - middleOfGreen(textures.read(1)).x;
                CHECK(shift == doctest::Approx(pixels_per_slope * 0.064 / distance_m).epsilon(0.04));
            }
    }

    TEST_CASE("With a view that is wider outwards and downwards a point lies where its tangents say") {
        Gl gl(4);
        Scene scene = emptyScene();
        Eyes eyes = eyesOf(scene.camera, {}, 0.064);
        eyes[0].fov = {-0.95, 0.70, 0.75, -0.90};
        eyes[1].fov = {-0.70, 0.95, 0.75, -0.90};
        // Canted screens: each eye is turned outwards too.
        eyes[0].stage_from_eye.orientation *= glm::angleAxis(0.08, up);
        eyes[1].stage_from_eye.orientation *= glm::angleAxis(-0.08, up);
        const StereoTextures textures(width, height);
        for (const StereoMode mode : stereoModes(*gl.renderer))
            for (const Vec3 point : {Vec3(0.0, 1.3, 0.5), Vec3(-0.7, 1.8, 1.0), Vec3(0.6, 0.9, 1.2)}) {
                CAPTURE(nameOf(mode));
                scene.balls = {greenBall(point, 0.03)};
                gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
                for (int eye = 0; eye < 2; ++eye) {
                    const glm::dvec2 expected =
                        project(eyes[static_cast<std::size_t>(eye)], point, width, height);
                    CHECK(glm::distance(middleOfGreen(textures.read(eye)), expected) < 0.6);
                }
            }
    }

    TEST_CASE("Depth is that of the floor and of a ball, between near and far as GL has it") {
        Gl gl(4);
        Scene scene = emptyScene();
        const Vec3 ball(0.2, 1.2, 1.0);
        const double radius_m = 0.2;
        scene.balls = {{ball, radius_m, glm::vec3(0.5F), {}}};
        const Eyes eyes = eyesOf(scene.camera, {-0.8, 0.7, 0.6, -0.9}, 0.064);
        const StereoTextures textures(width, height);
        const double near_m = scene.camera.near_m;
        const double far_m = scene.camera.far_m;
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(nameOf(mode));
                const Eye& seen_by = eyes[static_cast<std::size_t>(eye)];
                const EyePicture picture = textures.read(eye);
                const Vec3 from = seen_by.stage_from_eye.position;
                const Vec3 forward = seen_by.stage_from_eye.orientation * Vec3(0.0, 0.0, -1.0);
                const auto depthAt = [&](const Vec3& point) {
                    const glm::dvec2 p = project(seen_by, point, width, height);
                    return picture.depth[picture.at(static_cast<int>(p.x), static_cast<int>(p.y))];
                };
                // The same distance along the view axis, from the depth that GL defines.
                const auto metres = [&](double depth) {
                    return 1.0 / (1.0 / near_m - depth * (1.0 / near_m - 1.0 / far_m));
                };
                const Vec3 nearest = ball - glm::normalize(ball - from) * radius_m;
                CHECK(metres(depthAt(nearest)) ==
                      doctest::Approx(glm::dot(nearest - from, forward)).epsilon(0.002));
                for (const Vec3 floor : {Vec3(0.0, 0.0, 0.5), Vec3(-0.8, 0.0, -0.5)})
                    CHECK(metres(depthAt(floor)) ==
                          doctest::Approx(glm::dot(floor - from, forward)).epsilon(0.01));
            }
        }
    }

    TEST_CASE("Colours alone are drawn where no depth is wanted, and multiview is refused where it is not") {
        Gl gl;
        const Scene scene = fullScene();
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, width, height), 0.064);
        const StereoTextures with(width, height);
        const StereoTextures without(width, height);
        StereoTarget colour_only = without.target();
        colour_only.depth = 0;
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            gl.renderer->drawStereo(scene, eyes, with.target(), mode);
            gl.renderer->drawStereo(scene, eyes, colour_only, mode);
            CHECK(with.read(0).rgba == without.read(0).rgba);
            CHECK(with.read(1).rgba == without.read(1).rgba);
        }
        if (!gl.renderer->hasMultiview())
            CHECK_THROWS_AS(gl.renderer->drawStereo(scene, eyes, with.target(), StereoMode::multiview),
                            std::invalid_argument);
    }
}

TEST_SUITE("renderer/hidden_area") {
    TEST_CASE("What an eye's lens hides stays black there, and every other pixel is as it was") {
        Gl gl(4);
        Scene scene = fullScene();
        scene.board.emplace();
        scene.board->stage_from_board.position = Vec3(-0.9, 0.9, 1.8);
        const EyeFov fov{-0.8, 0.8, 0.7, -0.7};
        const Eyes eyes = eyesOf(scene.camera, fov, 0.064);
        const double side = std::tan(0.8);
        const double top = std::tan(0.7);
        // The lower left half of the left eye's picture, and the upper right quarter of the right eye's.
        std::array<HiddenArea, 2> areas;
        areas[0].corners = {{-side, top}, {-side, -top}, {side, -top}};
        areas[0].indices = {0, 1, 2};
        areas[1].corners = {{0.0, top}, {0.0, 0.0}, {side, 0.0}, {side, top}};
        areas[1].indices = {0, 1, 2, 0, 2, 3};
        const auto hidden = [](int eye, double x, double y) {
            return eye == 0 ? y / height - x / width : std::min(x / width - 0.5, 0.5 - y / height);
        };
        const StereoTextures textures(width, height);
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            CAPTURE(nameOf(mode));
            gl.renderer->setHiddenArea({});
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            const std::array<EyePicture, 2> before{textures.read(0), textures.read(1)};
            gl.renderer->setHiddenArea(areas);
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(eye);
                const EyePicture& whole = before[static_cast<std::size_t>(eye)];
                const EyePicture masked = textures.read(eye);
                int not_black = 0;
                int changed = 0;
                int hidden_count = 0;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        const double inside = hidden(eye, x + 0.5, y + 0.5);
                        if (std::abs(inside) < 0.01) continue;
                        if (inside > 0.0) {
                            ++hidden_count;
                            if (masked.colour(x, y).sum() != 0 || masked.alpha(x, y) != 255 ||
                                masked.depth[masked.at(x, y)] != 0.0F)
                                ++not_black;
                        } else if (masked.colour(x, y).sum() != whole.colour(x, y).sum() ||
                                   masked.alpha(x, y) != whole.alpha(x, y)) {
                            ++changed;
                        }
                    }
                CHECK(hidden_count > width * height / 5);
                CHECK(not_black == 0);
                CHECK(changed == 0);
            }
        }
    }

    TEST_CASE("Indices that are no triangles of the corners are refused") {
        Gl gl;
        std::array<HiddenArea, 2> areas;
        areas[1].corners = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};
        areas[1].indices = {0, 1, 3};
        CHECK_THROWS_WITH(gl.renderer->setHiddenArea(areas), "3 indices are no triangles of 3 corners");
        areas[1].indices = {0, 1};
        CHECK_THROWS_AS(gl.renderer->setHiddenArea(areas), std::invalid_argument);
    }
}

TEST_SUITE("renderer/board_hole") {
    TEST_CASE("The board is a hole without colour and alpha, and all else is opaque") {
        Gl gl(4);
        Scene scene = fullScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, width, height), 0.064);
        const StereoTextures textures(width, height);
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            scene.board.reset();
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                const EyePicture picture = textures.read(eye);
                int not_opaque = 0;
                for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
                    if (picture.rgba[i] != 255) ++not_opaque;
                CHECK(not_opaque == 0);
            }
            scene.board.emplace();
            scene.board->stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
            scene.beam.reset();
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(nameOf(mode));
                const Eye& seen_by = eyes[static_cast<std::size_t>(eye)];
                const glm::dvec2 low = project(seen_by, {-0.5, 1.45, 1.6}, width, height);
                const glm::dvec2 high = project(seen_by, {0.5, 0.95, 1.6}, width, height);
                const EyePicture picture = textures.read(eye);
                int wrong_inside = 0;
                int wrong_outside = 0;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
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
        }
    }

    TEST_CASE("A ball before the board covers it, one behind is covered, and the beam shines before it") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
        scene.board.emplace();
        scene.board->stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
        scene.balls = {greenBall({-0.2, 1.2, 1.9}, 0.05), greenBall({0.3, 1.2, 1.3}, 0.05)};
        scene.beam = Beam{{{-0.3, 1.1, 1.8}, Vec3(1.0, 0.0, 0.0)}, 0.6, {1.0F, 0.1F, 0.05F}};
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, width, height), 0.064);
        const StereoTextures textures(width, height);
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(nameOf(mode));
                const EyePicture picture = textures.read(eye);
                const auto at = [&](const Vec3& point) {
                    return glm::ivec2(project(eyes[static_cast<std::size_t>(eye)], point, width, height));
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
        }
    }
}

TEST_SUITE("renderer/board_copy") {
    TEST_CASE("The board's copy stands upright, its first row at the foot, and shows what the eye sees") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.3}, {0.0, 1.2, 0.0});
        scene.board = questionBoard();
        const Board& board = *scene.board;
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
        Board board = questionBoard();
        board.width_m = 0.9003;  // no whole number of pixels
        board.height_m = 0.4602;
        const auto [copy_width, copy_height] = gl.renderer->boardSize(board);
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
        scene.board = questionBoard();
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, 64, 64), 0.064);
        const StereoTextures textures(64, 64);
        const auto [copy_width, copy_height] = gl.renderer->boardSize(*scene.board);
        const BoardTexture texture(copy_width, copy_height);
        for (int i = 0; i < 3; ++i) {
            gl.renderer->drawStereo(scene, eyes, textures.target(), StereoMode::two_passes);
            gl.renderer->copyBoard(*scene.board, texture.name());
        }
        CHECK(gl.renderer->boardPaints() == 1);
        scene.board->buttons[0].hovered = false;
        const Bytes hovered = texture.at(copy_width / 4, copy_height / 4);
        gl.renderer->copyBoard(*scene.board, texture.name());
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
        Gl gl(4);
        Scene scene = fullScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
        scene.board = questionBoard();
        scene.balls.push_back(greenBall({-0.1, 1.2, 1.9}, 0.05));
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, width, height), 0.064);
        const StereoTextures textures(width, height);
        const Window window(width, height);
        Scene alone = scene;
        alone.camera.stage_from_eye = eyes[0].stage_from_eye;
        for (const StereoMode mode : stereoModes(*gl.renderer)) {
            CAPTURE(nameOf(mode));
            const Image expected = gl.renderer->capture(alone, width, height);
            gl.renderer->drawStereo(scene, eyes, textures.target(), mode);
            gl.renderer->drawMirror(scene, eyes[0], width, height, window.name());
            const Difference off = difference(window.read(), expected);
            CHECK(off.mean < 0.5);
            CHECK(off.off_share < 0.02);
        }
    }

    TEST_CASE("A window of another shape shows the picture's middle in its own shape, filled to the edges") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 1.2, 2.7}, {0.0, 1.2, 0.0});
        scene.balls = {greenBall({0.3, 1.3, 1.0}, 0.1)};
        scene.board = questionBoard();
        scene.board->stage_from_board.position.x = -0.9;
        const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, 256, 256), 0.064);
        const StereoTextures textures(256, 256);
        gl.renderer->drawStereo(scene, eyes, textures.target(), StereoMode::two_passes);
        for (const auto& [w, h] : {std::pair{400, 200}, std::pair{120, 240}}) {
            CAPTURE(w);
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
