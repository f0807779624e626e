#include "gl_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

/// The sRGB byte of linear light (IEC 61966-2-1).
double srgbByte(double linear) {
    return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

int brightestOf(const Bytes& bytes) {
    return std::max({bytes.r, bytes.g, bytes.b});
}

}  // namespace

TEST_SUITE("renderer/balls") {
    TEST_CASE("A black ball is darker and a white ball brighter than the room behind, where each stands") {
        Gl gl;
        Scene scene = emptyScene();
        const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
        const Vec3 left(-0.5, 1.2, 0.3);
        const Vec3 right(0.5, 1.1, 0.6);
        scene.balls = {{left, 0.08, glm::vec3(0.02F), {}}, {right, 0.08, glm::vec3(0.9F), {}}};
        const Image image = gl.renderer->capture(scene, picture_width, picture_height);
        CHECK(brightestOf(pixelAt(image, scene.camera, left)) < 110);
        CHECK(pixelAt(image, scene.camera, left).sum() + 200 < pixelAt(empty, scene.camera, left).sum());
        // The white ball's upper side, towards the light.
        const Vec3 crown = right + Vec3(0.0, 0.05, 0.05);
        CHECK(pixelAt(image, scene.camera, crown).sum() > pixelAt(empty, scene.camera, crown).sum() + 60);
        // Beside them nothing has changed.
        const Vec3 between(0.0, 1.6, 0.3);
        CHECK(pixelAt(image, scene.camera, between).sum() == pixelAt(empty, scene.camera, between).sum());
    }

    TEST_CASE("Emitted light of 0.2140 from a ball without colour becomes the sRGB byte 127") {
        Gl gl;
        Scene scene = emptyScene();
        const Vec3 centre(0.0, 1.2, 1.0);
        for (const double light : {0.05, 0.2140, 0.5}) {
            scene.balls = {{centre, 0.3, glm::vec3(0.0F), glm::vec3(static_cast<float>(light))}};
            const Image image = gl.renderer->capture(scene, picture_width, picture_height);
            // The lower side, where no highlight falls; the mean evens the dithering out.
            double sum = 0.0;
            const auto [x, y] =
                project(scene.camera, centre - Vec3(0.0, 0.15, 0.0), picture_width, picture_height);
            for (int dx = -4; dx < 4; ++dx)
                for (int dy = -4; dy < 4; ++dy) sum += pixel(image, x + dx, y + dy).g;
            CHECK(sum / 64.0 == doctest::Approx(srgbByte(light)).epsilon(0.012));
        }
    }

    TEST_CASE("A hovering ball darkens the floor below it, and the farther from the axis the less") {
        Gl gl;
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.0, 2.0, 2.5}, {0.2, 0.0, 0.0});
        const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
        const Vec3 ball(0.27, 1.0, 0.22);
        scene.balls = {{ball, 0.12, glm::vec3(0.02F), {}}};
        const Image image = gl.renderer->capture(scene, picture_width, picture_height);
        const auto darkening = [&](const Vec3& p) {
            return pixelAt(empty, scene.camera, p).sum() - pixelAt(image, scene.camera, p).sum();
        };
        // Straight below and towards the back, where a lamp that stands 10 degrees to the front throws it.
        const Vec3 below(0.21, 0.0, 0.055);
        CHECK(darkening(below) > 60);
        CHECK(darkening(below + Vec3(0.55, 0.0, 0.0)) < 8);
        CHECK(glm::length(below - Vec3(ball.x, 0.0, ball.z)) < 0.2);
    }
}

TEST_SUITE("renderer/avatar") {
    TEST_CASE("The avatar is seen where its pose puts it, and moving one joint moves that part alone") {
        Gl gl;
        Scene scene = emptyScene();
        const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
        scene.avatars = {postPose()};
        const Image straight = gl.renderer->capture(scene, picture_width, picture_height);
        // The upper half leans by 60 degrees towards the avatar's left, which is +x.
        scene.avatars[0][1].orientation = glm::angleAxis(radiansFromDegrees(-60.0), Vec3(0.0, 0.0, 1.0));
        const Image leaning = gl.renderer->capture(scene, picture_width, picture_height);
        const auto red = [&](const Image& image, const Vec3& p) {
            const Bytes c = pixelAt(image, scene.camera, p);
            return c.r > 2 * c.g;
        };
        const Vec3 lower(0.0, 0.5, 0.12);
        const Vec3 upper(0.0, 1.4, 0.12);
        const Vec3 leant(0.6 * std::sin(radiansFromDegrees(60.0)),
                         0.8 + 0.6 * std::cos(radiansFromDegrees(60.0)), 0.12);
        CHECK_FALSE(red(empty, lower));
        CHECK(red(straight, lower));
        CHECK(red(straight, upper));
        CHECK_FALSE(red(straight, leant));
        CHECK(red(leaning, lower));
        CHECK_FALSE(red(leaning, upper));
        CHECK(red(leaning, leant));
    }

    TEST_CASE("The avatar's shadow falls on the floor beside what leans over it") {
        Gl gl;
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.4, 2.2, 2.2}, {0.3, 0.0, 0.0});
        scene.avatars = {postPose()};
        const Image straight = gl.renderer->capture(scene, picture_width, picture_height);
        scene.avatars[0][1].orientation = glm::angleAxis(radiansFromDegrees(-90.0), Vec3(0.0, 0.0, 1.0));
        const Image leaning = gl.renderer->capture(scene, picture_width, picture_height);
        // The arm lies 0.8 m up along +x; 10 degrees of slant move its shadow 0.05 m and 0.13 m back.
        const Vec3 under(0.45, 0.0, -0.13);
        CHECK(pixelAt(straight, scene.camera, under).sum() >
              pixelAt(leaning, scene.camera, under).sum() + 60);
    }

    TEST_CASE("A pose with another number of joints is rejected with both numbers") {
        Gl gl;
        Scene scene = emptyScene();
        scene.avatars = {postPose(), std::vector<Pose>(3)};
        CHECK_THROWS_WITH(static_cast<void>(gl.renderer->capture(scene, picture_width, picture_height)),
                          "one of Scene::avatars has 3 poses, the avatar 2 joints");
        scene.avatars = {postPose(), postPose(), postPose()};
        CHECK_THROWS_WITH(static_cast<void>(gl.renderer->capture(scene, picture_width, picture_height)),
                          "3 avatars were to be drawn, at most 2 can be");
    }
}

TEST_SUITE("renderer/two_avatars") {
    TEST_CASE("Two avatars stand where their poses put them, and each throws its shadow on the floor") {
        Gl gl;
        Scene scene = emptyScene();
        scene.camera = lookingFrom({0.4, 2.2, 2.6}, {0.1, 0.2, 0.0});
        const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
        // A post at either side, whose upper half lies along +x.
        const auto leaning = [](double x) {
            std::vector<Pose> pose = postPose();
            for (Pose& joint : pose) joint.position.x += x;
            pose[1].orientation = glm::angleAxis(radiansFromDegrees(-90.0), Vec3(0.0, 0.0, 1.0));
            return pose;
        };
        const double left = -0.7;
        const double right = 0.5;
        const Vec3 under(0.45, 0.0, -0.13);  // as for one that leans
        const auto darker = [&](const Image& image, double x) {
            const Vec3 p = under + Vec3(x, 0.0, 0.0);
            return pixelAt(empty, scene.camera, p).sum() - pixelAt(image, scene.camera, p).sum();
        };
        const auto red = [&](const Image& image, double x) {
            const Bytes c = pixelAt(image, scene.camera, {x, 0.4, 0.12});
            return c.r > 2 * c.g;
        };
        scene.avatars = {leaning(left), leaning(right)};
        const Image both = gl.renderer->capture(scene, picture_width, picture_height);
        scene.avatars = {leaning(right)};
        const Image one = gl.renderer->capture(scene, picture_width, picture_height);
        CHECK(red(both, left));
        CHECK(red(both, right));
        CHECK(darker(both, left) > 60);
        CHECK(darker(both, right) > 60);
        CHECK_FALSE(red(one, left));
        CHECK(red(one, right));
        CHECK(std::abs(darker(one, left)) < 8);
        CHECK(darker(one, right) > 60);
    }
}

TEST_SUITE("renderer/ring") {
    TEST_CASE("A ringed ball has a bright ring around it with a gap between, from wherever it is seen") {
        Gl gl;
        for (const Vec3 from : {Vec3(0.0, 1.5, 3.0), Vec3(2.2, 0.7, 1.5)}) {
            Scene scene = emptyScene();
            const Vec3 centre(0.0, 1.2, 0.4);
            scene.camera = lookingFrom(from, centre);
            scene.balls = {{centre, 0.1, glm::vec3(0.02F), {}}};
            const Image plain = gl.renderer->capture(scene, picture_width, picture_height);
            scene.balls[0].rings = 1;
            const Image ringed = gl.renderer->capture(scene, picture_width, picture_height);
            const Vec3 towards = glm::normalize(from - centre);
            const Vec3 side = glm::normalize(glm::cross(up, towards));
            const Vec3 above = glm::cross(towards, side);
            for (int i = 0; i < 8; ++i) {
                const double angle = 0.25 * pi * i;
                const Vec3 out = std::cos(angle) * side + std::sin(angle) * above;
                CHECK(pixelAt(ringed, scene.camera, centre + 0.155 * out).g > 220);
                const Vec3 gap = centre + 0.12 * out;
                CHECK(std::abs(pixelAt(ringed, scene.camera, gap).g - pixelAt(plain, scene.camera, gap).g) <
                      40);
                CHECK(pixelAt(ringed, scene.camera, centre + 0.25 * out).sum() ==
                      pixelAt(plain, scene.camera, centre + 0.25 * out).sum());
            }
        }
    }
}

TEST_SUITE("renderer/replay") {
    TEST_CASE("A trail is seen along its way, and the fainter the older") {
        Gl gl;
        Scene scene = emptyScene();
        const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
        Trail trail;
        for (int i = 0; i <= 40; ++i) trail.points.emplace_back(-0.8 + 0.04 * i, 1.2, 0.5);
        trail.colour = glm::vec3(0.02F, 0.1F, 1.0F);
        scene.trails = {trail, Trail{}, Trail{{Vec3(0.0)}, {}}};  // those of no way draw nothing
        const Image image = gl.renderer->capture(scene, picture_width, picture_height);
        const auto change = [&](double x, double y) {
            const Vec3 p(x, y, 0.5);
            return pixelAt(empty, scene.camera, p).r - pixelAt(image, scene.camera, p).r;
        };
        CHECK(change(0.7, 1.2) > 60);
        CHECK(change(0.7, 1.2) > change(0.0, 1.2) + 15);
        CHECK(change(0.0, 1.2) > change(-0.7, 1.2) + 15);
        CHECK(change(0.7, 1.35) == 0);
    }

    TEST_CASE("A head shows by its dark front where it looks") {
        Gl gl;
        Scene scene = emptyScene();
        const Vec3 eyes(0.0, 1.3, 1.2);
        scene.camera = lookingFrom({0.0, 1.3, 2.4}, eyes);
        scene.heads = {{{eyes, yawRotation(pi)}, glm::vec3(0.6F)}};  // towards the camera
        const Image front = gl.renderer->capture(scene, picture_width, picture_height);
        scene.heads[0].stage_from_head.orientation = no_rotation;  // away from it
        const Image back = gl.renderer->capture(scene, picture_width, picture_height);
        CHECK(brightestOf(pixelAt(front, scene.camera, eyes)) < 90);
        CHECK(brightestOf(pixelAt(back, scene.camera, eyes)) > 130);
        // The head lies behind the eyes, whose height is a little over its middle.
        CHECK(brightestOf(pixelAt(front, scene.camera, eyes + Vec3(0.0, -0.085, 0.0))) > 130);
    }
}

TEST_SUITE("renderer/beam") {
    TEST_CASE("The beam is red along its way, and hidden behind a ball") {
        Gl gl;
        Scene scene = emptyScene();
        const Vec3 from(-0.8, 1.2, 0.5);
        scene.beams = {{{from, Vec3(1.0, 0.0, 0.0)}, 1.6, {1.0F, 0.1F, 0.05F}}};
        const Image image = gl.renderer->capture(scene, picture_width, picture_height);
        const auto redness = [&](const Image& picture, const Vec3& p) {
            const Bytes c = pixelAt(picture, scene.camera, p);
            return c.r - std::max(c.g, c.b);
        };
        for (const double along : {0.5, 0.8, 1.1}) CHECK(redness(image, from + Vec3(along, 0.0, 0.0)) > 50);
        CHECK(redness(image, from + Vec3(0.8, 0.15, 0.0)) < 20);
        scene.balls = {{from + Vec3(0.8, 0.0, 0.4), 0.1, glm::vec3(0.5F), {}}};
        CHECK(redness(gl.renderer->capture(scene, picture_width, picture_height),
                      from + Vec3(0.8, 0.0, 0.4)) < 20);
    }
}

TEST_SUITE("renderer/picture") {
    TEST_CASE("A picture has the size asked for, one after the other, and the same content") {
        Gl gl;
        Scene scene = emptyScene();
        const Vec3 ball(0.3, 1.3, 0.4);
        scene.balls = {{ball, 0.1, glm::vec3(0.02F), {}}};
        for (const auto& [w, h] : {std::pair{320, 240}, std::pair{501, 333}, std::pair{320, 240}}) {
            const Image image = gl.renderer->capture(scene, w, h);
            CHECK(image.width == w);
            CHECK(image.height == h);
            REQUIRE(image.rgb.size() == static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3U);
            CHECK(brightestOf(pixelAt(image, scene.camera, ball)) < 110);
        }
        CHECK_THROWS_AS(static_cast<void>(gl.renderer->capture(scene, 0, 240)), std::invalid_argument);
    }

    TEST_CASE("The same scene gives the same bytes again") {
        Gl gl(4);
        Scene scene = emptyScene();
        scene.avatars = {postPose()};
        scene.balls = {{{0.3, 1.3, 0.4}, 0.1, glm::vec3(0.9F), {}}};
        const Image first = gl.renderer->capture(scene, picture_width, picture_height);
        CHECK(first.rgb == gl.renderer->capture(scene, picture_width, picture_height).rgb);
    }

    TEST_CASE("Multisampling puts values between ball and wall on the ball's edge") {
        Scene scene = emptyScene();
        scene.balls = {{{0.0, 1.3, 0.4}, 0.25, glm::vec3(0.0F), {}}};
        // Pixels of the ball's middle row whose brightness lies clearly between the two.
        const auto between = [&](int samples) {
            Gl gl(samples);
            const Image image = gl.renderer->capture(scene, picture_width, picture_height);
            int count = 0;
            for (int y = 0; y < picture_height; ++y)
                for (int x = 1; x + 1 < picture_width; ++x) {
                    const int here = pixel(image, x, y).g;
                    const int left = pixel(image, x - 1, y).g;
                    const int right = pixel(image, x + 1, y).g;
                    if (std::abs(left - right) > 80 && here > std::min(left, right) + 20 &&
                        here < std::max(left, right) - 20)
                        ++count;
                }
            return count;
        };
        const int without = between(1);
        const int with = between(4);
        CHECK(with > 20);
        CHECK(with > 3 * without);
    }
}
