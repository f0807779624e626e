#include "stereo_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

TEST_SUITE("renderer/stereo") {
    TEST_CASE("Each eye sees what a camera in its place sees") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            const Scene scene = fullScene();
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
            const StereoTextures textures(picture_width, picture_height);
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(eye);
                Scene alone = scene;
                alone.camera.stage_from_eye = eyes[static_cast<std::size_t>(eye)].stage_from_eye;
                const Image expected = drawing.capture(alone, picture_width, picture_height);
                const Difference off = difference(textures.read(eye).image(), expected);
                CHECK(off.mean < 0.05);
                CHECK(off.off_share < 0.001);
            }
        });
    }

    TEST_CASE("Both ways of drawing give the same two pictures, also in turns and at other sizes") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            if (mode == StereoMode::two_passes) return;  // compared with these
            const Scene scene = fullScene();
            for (const auto& [w, h] : {std::pair{160, 120}, std::pair{201, 133}, std::pair{160, 120}}) {
                const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, w, h), 0.064);
                const StereoTextures one_by_one(w, h);
                const StereoTextures together(w, h);
                drawing.drawStereo(scene, eyes, one_by_one.target(), StereoMode::two_passes);
                drawing.drawStereo(scene, eyes, together.target(), mode);
                for (int eye = 0; eye < 2; ++eye) {
                    const Difference off =
                        difference(one_by_one.read(eye).image(), together.read(eye).image());
                    CHECK(off.mean < 0.05);
                    CHECK(off.off_share < 0.001);
                }
            }
        });
    }

    TEST_CASE("The left eye sees a near ball farther to the right than the right eye, by its distance") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = emptyScene();
            scene.camera = lookingFrom({0.0, 1.4, 3.0}, {0.0, 1.4, 0.0});
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
            const double pixels_per_slope =
                0.5 * picture_height / std::tan(0.5 * scene.camera.vertical_fov_rad);
            const StereoTextures textures(picture_width, picture_height);
            for (const double distance_m : {0.6, 2.5}) {
                CAPTURE(distance_m);
                scene.balls = {greenBall({0.0, 1.4, 3.0 - distance_m}, 0.04 * distance_m)};
                drawing.drawStereo(scene, eyes, textures.target(), mode);
                const double shift = middleOfGreen(textures.read(0)).x - middleOfGreen(textures.read(1)).x;
                CHECK(shift == doctest::Approx(pixels_per_slope * 0.064 / distance_m).epsilon(0.04));
            }
        });
    }

    TEST_CASE("With a view that is wider outwards and downwards a point lies where its tangents say") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = emptyScene();
            Eyes eyes = eyesOf(scene.camera, {}, 0.064);
            eyes[0].fov = {-0.95, 0.70, 0.75, -0.90};
            eyes[1].fov = {-0.70, 0.95, 0.75, -0.90};
            // Canted screens: each eye is turned outwards too.
            eyes[0].stage_from_eye.orientation *= glm::angleAxis(0.08, up);
            eyes[1].stage_from_eye.orientation *= glm::angleAxis(-0.08, up);
            const StereoTextures textures(picture_width, picture_height);
            for (const Vec3 point : {Vec3(0.0, 1.3, 0.5), Vec3(-0.7, 1.8, 1.0), Vec3(0.6, 0.9, 1.2)}) {
                scene.balls = {greenBall(point, 0.03)};
                drawing.drawStereo(scene, eyes, textures.target(), mode);
                for (int eye = 0; eye < 2; ++eye) {
                    const glm::dvec2 expected =
                        project(eyes[static_cast<std::size_t>(eye)], point, picture_width, picture_height);
                    CHECK(glm::distance(middleOfGreen(textures.read(eye)), expected) < 0.6);
                }
            }
        });
    }

    TEST_CASE("Depth is that of the floor and of a ball, between near and far as GL has it") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = emptyScene();
            const Vec3 ball(0.2, 1.2, 1.0);
            const double radius_m = 0.2;
            scene.balls = {{ball, radius_m, glm::vec3(0.5F), {}}};
            const Eyes eyes = eyesOf(scene.camera, {-0.8, 0.7, 0.6, -0.9}, 0.064);
            const StereoTextures textures(picture_width, picture_height);
            const double near_m = scene.camera.near_m;
            const double far_m = scene.camera.far_m;
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                const Eye& seen_by = eyes[static_cast<std::size_t>(eye)];
                const EyePicture picture = textures.read(eye);
                const Vec3 from = seen_by.stage_from_eye.position;
                const Vec3 forward = seen_by.stage_from_eye.orientation * Vec3(0.0, 0.0, -1.0);
                const auto depthAt = [&](const Vec3& point) {
                    const glm::dvec2 p = project(seen_by, point, picture_width, picture_height);
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
        });
    }

    TEST_CASE("Colours alone are drawn where no depth is wanted, and multiview is rejected where it is not") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            const Scene scene = fullScene();
            const Eyes eyes = eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
            const StereoTextures with(picture_width, picture_height);
            const StereoTextures without(picture_width, picture_height);
            StereoTarget colour_only = without.target();
            colour_only.depth = {};
            drawing.drawStereo(scene, eyes, with.target(), mode);
            drawing.drawStereo(scene, eyes, colour_only, mode);
            CHECK(with.read(0).rgba == without.read(0).rgba);
            CHECK(with.read(1).rgba == without.read(1).rgba);
            if (!drawing.hasMultiview())
                CHECK_THROWS_AS(drawing.drawStereo(scene, eyes, with.target(), StereoMode::multiview),
                                std::invalid_argument);
        });
    }
}

TEST_SUITE("renderer/hidden_area") {
    TEST_CASE("What an eye's lens hides stays black there, and every other pixel is as it was") {
        inEachWay([](Renderer& drawing, StereoMode mode) {
            Scene scene = fullScene();
            scene.boards.resize(1);
            scene.boards[0].stage_from_board.position = Vec3(-0.9, 0.9, 1.8);
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
                return eye == 0 ? y / picture_height - x / picture_width
                                : std::min(x / picture_width - 0.5, 0.5 - y / picture_height);
            };
            const StereoTextures textures(picture_width, picture_height);
            drawing.setHiddenArea({});
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            const std::array<EyePicture, 2> before{textures.read(0), textures.read(1)};
            drawing.setHiddenArea(areas);
            drawing.drawStereo(scene, eyes, textures.target(), mode);
            for (int eye = 0; eye < 2; ++eye) {
                CAPTURE(eye);
                const EyePicture& whole = before[static_cast<std::size_t>(eye)];
                const EyePicture masked = textures.read(eye);
                int not_black = 0;
                int changed = 0;
                int hidden_count = 0;
                for (int y = 0; y < picture_height; ++y)
                    for (int x = 0; x < picture_width; ++x) {
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
                CHECK(hidden_count > picture_width * picture_height / 5);
                CHECK(not_black == 0);
                CHECK(changed == 0);
            }
        });
    }

    TEST_CASE("Indices that are no triangles of the corners are rejected") {
        Gl gl;
        std::array<HiddenArea, 2> areas;
        areas[1].corners = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};
        areas[1].indices = {0, 1, 3};
        CHECK_THROWS_WITH(gl.renderer->setHiddenArea(areas), "3 indices are no triangles of 3 corners");
        areas[1].indices = {0, 1};
        CHECK_THROWS_AS(gl.renderer->setHiddenArea(areas), std::invalid_argument);
    }
}
