#include "studies/station/first_look.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/synthesis/generator.hpp"
#include "session_fixture.hpp"
#include "simulated_run.hpp"
#include "studies/study_file/standing.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

constexpr double eyes_m = 1.65;

/// Where a point falls in a picture of this width by height: within -1..1 in both directions it is in it.
struct InPicture {
    double x = 0.0, y = 0.0;
    [[nodiscard]] double farthest() const { return std::max(std::abs(x), std::abs(y)); }
};
InPicture pictured(const Pose& viewer, const FirstLook& look, double aspect, const Vec3& point) {
    // As a camera is built: turned by the look, x to the right, y up, looking along -z.
    const Vec3 ahead(-std::cos(look.pitch_rad) * std::sin(look.yaw_rad), std::sin(look.pitch_rad),
                     -std::cos(look.pitch_rad) * std::cos(look.yaw_rad));
    const Vec3 right = glm::normalize(glm::cross(ahead, up));
    const Vec3 above = glm::cross(right, ahead);
    const Vec3 there = transformPoint(inverse(viewer), point) - Vec3(0.0, eyes_m, 0.0);
    const double depth = glm::dot(there, ahead);
    REQUIRE(depth > 0.0);
    const double half = std::tan(0.5 * look.verticalView_rad(aspect));
    return {glm::dot(there, right) / depth / half / aspect, glm::dot(there, above) / depth / half};
}

}  // namespace

TEST_SUITE("studies/first_look") {
    TEST_CASE("One ball straight ahead is looked at, in the least view.") {
        // Eyes at (0, 1.65, 3), looking at the avatar; the ball 2 m before them and 1 m below.
        const Pose viewer{{0.0, 0.0, 3.0}, no_rotation};
        const FirstLook look = firstLook(viewer, eyes_m, {{{0.0, 0.65, 1.0}, 0.05}});
        CHECK(look.yaw_rad == doctest::Approx(0.0));
        CHECK(look.pitch_rad == doctest::Approx(-std::atan(0.5)).epsilon(1e-3));
        CHECK(look.verticalView_rad(16.0 / 9.0) == min_view_rad);
        // To the left, turned to the left.
        CHECK(firstLook(viewer, eyes_m, {{{-1.0, eyes_m, 2.0}, 0.05}}).yaw_rad ==
              doctest::Approx(pi / 4.0).epsilon(1e-3));
    }

    TEST_CASE("What lies 45 degrees to either side needs a view that a narrow picture widens upwards.") {
        const Pose viewer{};
        const FirstLook look =
            firstLook(viewer, eyes_m, {{{-2.0, eyes_m, -2.0}, 0.0}, {{2.0, eyes_m, -2.0}, 0.0}});
        CHECK(look.yaw_rad == doctest::Approx(0.0));
        CHECK(look.half_width == doctest::Approx(1.0));
        // A tenth of the half free: tan = 1 / 0.9 across, by hand 2 atan(0.8333) = 79.61 degrees for 4:3.
        CHECK(degreesFromRadians(look.verticalView_rad(4.0 / 3.0)) == doctest::Approx(79.611).epsilon(1e-4));
        CHECK(degreesFromRadians(look.verticalView_rad(16.0 / 9.0)) == doctest::Approx(64.011).epsilon(1e-4));
        CHECK(look.verticalView_rad(0.5) == max_view_rad);
    }

    TEST_CASE("The order of the balls changes nothing, so the look cannot tell which is the target.") {
        const motion::Skeleton& avatar = motion::referenceHumanoid();
        const motion::LocalPose idle = motion::relaxedPose(avatar);
        const Pose viewer = viewerPose({"side-by-side", -0.6, -0.95, 15.0});
        Random random(7, "first look");
        for (int i = 0; i < 100; ++i) {
            std::vector<Sphere> balls;
            for (int ball = 0; ball < 4; ++ball)
                balls.push_back(
                    {{random.uniform(-2.0, 2.0), random.uniform(0.1, 2.1), random.uniform(0.3, 2.0)}, 0.05});
            const FirstLook look = firstLook(viewer, eyes_m, pointingScene(balls, avatar, idle));
            random.shuffle(std::span<Sphere>(balls));
            const FirstLook again = firstLook(viewer, eyes_m, pointingScene(balls, avatar, idle));
            CHECK(look.yaw_rad == again.yaw_rad);
            CHECK(look.pitch_rad == again.pitch_rad);
            CHECK(look.half_width == again.half_width);
            CHECK(look.half_height == again.half_height);
        }
    }

    TEST_CASE(
        "The shipped studies: all balls and the arm that points are in the first view of every target.") {
        for (const char* name : {"pointing2023", "distractor-distance", "pointing-style"}) {
            const Prepared prepared(
                loadedStudy(source_tree / "assets/data/studies" / (std::string(name) + ".toml")));
            const auto generator = motion::makeGenerator("direct", prepared.avatar, {});
            REQUIRE(generator.has_value());
            const motion::HumanoidMap map = motion::mapByVrmNames(prepared.avatar);
            for (const TargetItem& item : prepared.targets) {
                const motion::GeneratedClip made = (*generator)->generate({item.id, item.target, 1, {}});
                const auto held = motion::worldPose(
                    prepared.avatar, made.clip.frames[static_cast<std::size_t>(made.hold_frame)]);
                const motion::ArmBones arm = motion::armBones(made.hand);
                std::vector<Vec3> arm_points{
                    motion::fingertipPosition(prepared.avatar, map, held, made.hand)};
                for (const motion::Bone bone : {arm.upper_arm, arm.lower_arm, arm.hand})
                    arm_points.push_back(held[static_cast<std::size_t>(map[bone])].position);
                for (const Layout& layout : prepared.study.layouts) {
                    const Pose viewer = viewerPose(viewerPlace(layout, Standing::desktop));
                    for (const std::vector<Vec3>& distractors : item.distractors) {
                        std::vector<Sphere> balls{{item.target, 0.05}};
                        for (const Vec3& ball : distractors) balls.push_back({ball, 0.05});
                        const FirstLook look =
                            firstLook(viewer, eyes_m, pointingScene(balls, prepared.avatar, prepared.idle));
                        for (const double aspect : {16.0 / 9.0, 4.0 / 3.0}) {
                            CAPTURE(name);
                            CAPTURE(item.id);
                            CAPTURE(layout.name);
                            CAPTURE(aspect);
                            for (const Sphere& ball : balls)
                                for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
                                    for (const double to : {-ball.radius_m, ball.radius_m})
                                        CHECK(pictured(viewer, look, aspect, ball.centre + to * way)
                                                  .farthest() < 0.95);
                            for (const Vec3& point : arm_points)
                                CHECK(pictured(viewer, look, aspect, point).farthest() < 0.98);
                        }
                    }
                }
            }
        }
    }

    TEST_CASE("Without a board a trial of the game has one look from first to last, and no page has one.") {
        Driver driver(2, 1.0, false);
        driver.start();
        std::optional<FirstLook> look;
        int trials = 0;
        SessionStatus before;
        while (driver.running() && driver.frame.number < 20000) {
            if (resting(driver.frame))
                driver.press(button_id::go_on);
            else if (answersOpen(driver.frame) && !driver.frame.balls.empty())
                driver.choose(0);
            else if (answersOpen(driver.frame))
                driver.digit(3);
            else
                driver.step();
            const PresentedFrame& frame = driver.frame;
            REQUIRE(frame.first_look.has_value() == !frame.balls.empty());
            if (frame.status != before) look = frame.first_look;
            if (frame.status != before && look) ++trials;
            before = frame.status;
            if (!look) continue;
            REQUIRE(frame.first_look->yaw_rad == look->yaw_rad);
            REQUIRE(frame.first_look->pitch_rad == look->pitch_rad);
            REQUIRE(frame.first_look->half_width == look->half_width);
        }
        CHECK(driver.finished());
        CHECK(trials >= 2);
    }
}
