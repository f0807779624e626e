// The simulated body against closed forms and numerical derivatives.
#include "physics/body/body.hpp"

#include <glm/gtc/quaternion.hpp>

#include "bodies.hpp"
#include "physics/figure/mjcf.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::physics;
using namespace deixis::tests;

namespace {

constexpr double gravity_m_s2 = 9.81;

BodyState restOf(const Figure& figure) {
    BodyState state;
    state.root.pose.position = figure.segments.front().joint_m;
    state.angles_rad.assign(figure.hinges.size(), 0.0);
    state.speeds_rad_s.assign(figure.hinges.size(), 0.0);
    return state;
}

/// In the field of gravity.
double potentialEnergy(const Figure& figure, const Pose& root, const std::vector<double>& angles) {
    const auto poses = segmentPoses(figure, root, angles);
    double joule = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const MassProperties& mass = figure.segments[i].mass;
        joule += mass.mass_kg * gravity_m_s2 * transformPoint(poses[i], mass.centre_m).y;
    }
    return joule;
}

/// The body as one pendulum: its left arm, stiff and straight, on an axis that points ahead, without actuator
/// or damping.
Figure armAsPendulum() {
    Figure figure = figureOf(Stance::pinned);
    figure.hinges.clear();
    for (Segment& segment : figure.segments) segment.first = segment.count = 0;
    figure.segments[figure.segment("left upper arm")].count = 1;
    Hinge hinge;
    hinge.name = "pendulum";
    hinge.axis = {0.0, 0.0, 1.0};
    hinge.min_rad = -4.0;
    hinge.max_rad = 4.0;
    hinge.max_torque_nm = 1.0;
    figure.hinges.push_back(hinge);
    return figure;
}

}  // namespace

TEST_SUITE("physics/body") {
    TEST_CASE("MuJoCo has the joints where the body's own kinematics have them") {
        for (const Stance stance : {Stance::pinned, Stance::free}) {
            const Figure figure = figureOf(stance);
            Body body = valueOf(Body::make(figure));
            Random random(6, "angles");
            for (int i = 0; i < 20; ++i) {
                BodyState state = restOf(figure);
                state.angles_rad = drawAngles(figure, random);
                state.root.pose = {{0.3, 1.2, -0.4}, glm::normalize(Quat(0.9, 0.1, -0.3, 0.2))};
                body.setState(state);
                const auto expected = segmentPoses(figure, state.root.pose, state.angles_rad);
                const auto found = body.jointPositions_m();
                REQUIRE(found.size() == expected.size());
                for (std::size_t s = 0; s < found.size(); ++s)
                    CHECK(glm::distance(found[s], expected[s].position) < 1e-9);
            }
        }
    }

    TEST_CASE("a state that is set is read again") {
        const Figure figure = figureOf(Stance::free);
        Body body = valueOf(Body::make(figure));
        BodyState state = restOf(figure);
        Random random(7, "state");
        state.angles_rad = drawAngles(figure, random);
        for (double& speed : state.speeds_rad_s) speed = random.normal();
        state.root = {{{0.1, 2.0, 0.3}, yawRotation(1.0)}, {0.4, -0.5, 0.6}, {0.7, 0.8, -0.9}};
        body.setState(state);
        const BodyState found = body.state();
        CHECK(found.angles_rad == state.angles_rad);
        CHECK(found.speeds_rad_s == state.speeds_rad_s);
        CHECK(glm::distance(found.root.pose.position, state.root.pose.position) == 0.0);
        CHECK(glm::distance(found.root.velocity_m_s, state.root.velocity_m_s) == 0.0);
        CHECK(glm::distance(found.root.angular_velocity_rad_s, state.root.angular_velocity_rad_s) < 1e-12);
    }

    TEST_CASE("a body that falls freely falls as a stone, and turns as it was turned") {
        const Figure figure = figureOf(Stance::free);
        Body body = valueOf(Body::make(figure));
        BodyState state = restOf(figure);
        state.root.pose.position.y = 20.0;
        body.setState(state);
        const int steps = 60;
        body.step(state.angles_rad, steps);
        // Of steps that take the new speed: y - g h^2 n (n + 1) / 2.
        const double expected = 20.0 - gravity_m_s2 * step_s * step_s * steps * (steps + 1) / 2.0;
        CHECK(body.root().pose.position.y == doctest::Approx(expected).epsilon(1e-9));
        CHECK(body.root().velocity_m_s.y == doctest::Approx(-gravity_m_s2 * 0.5).epsilon(1e-9));
        for (const double angle : body.angles_rad()) CHECK(std::abs(angle) < 1e-9);

        // Turned about its own upright, after a quarter turn to its left, about what is then the world's
        // axis.
        state.root.pose.orientation = yawRotation(pi / 2.0);
        state.root.angular_velocity_rad_s = {0.0, 0.2, 0.0};
        body.setState(state);
        body.step(state.angles_rad, 1);
        const Vec3 ahead = body.root().pose.orientation * Vec3(0.0, 0.0, 1.0);
        CHECK(std::atan2(ahead.x, ahead.z) == doctest::Approx(pi / 2.0 + 0.2 * step_s).epsilon(1e-6));
    }

    TEST_CASE("an arm that hangs freely swings with a physical pendulum's period") {
        const Figure figure = armAsPendulum();
        Body body = valueOf(Body::make(figure));
        double inertia = 0.0, moment = 0.0;  // about the axis; the arm lies along x
        for (const char* name : {"left upper arm", "left forearm", "left hand"}) {
            const auto poses = segmentPoses(figure, {}, std::vector<double>{0.0});
            const std::size_t s = figure.segment(name);
            const MassProperties& mass = figure.segments[s].mass;
            const Vec3 arm =
                poses[s].position + mass.centre_m - poses[figure.segment("left upper arm")].position;
            inertia += mass.inertia_kg_m2[2][2] + mass.mass_kg * (arm.x * arm.x + arm.y * arm.y);
            moment += mass.mass_kg * arm.x;
        }
        // From rest, 90 degrees from hanging: T = 4 K(sin 45 deg) sqrt(I / (m g d)), K = 1.8540746773.
        const double period_s = 4.0 * 1.8540746773 * std::sqrt(inertia / (moment * gravity_m_s2));
        BodyState state = restOf(figure);
        body.setState(state);
        std::vector<double> low_s;  // when it passes its lowest place
        double before = 0.0;
        for (int i = 1; i <= 1200; ++i) {
            body.step(std::vector<double>{0.0}, 1);
            const double angle = body.angles_rad()[0] + pi / 2.0;
            if (before * angle < 0.0) low_s.push_back(step_s * (i - 1 + before / (before - angle)));
            before = angle;
        }
        REQUIRE(low_s.size() > 8);
        CHECK(low_s.front() == doctest::Approx(period_s / 4.0).epsilon(0.01));
        CHECK(low_s[8] - low_s[0] == doctest::Approx(4.0 * period_s).epsilon(0.002));
    }

    TEST_CASE("actuators sag under gravity until stiffness times what is missing is the weight's torque") {
        const Figure figure = figureOf(Stance::pinned);
        Body body = valueOf(Body::make(figure));
        BodyState state = restOf(figure);
        const std::vector<double> targets(figure.hinges.size(), 0.1);
        body.setState(state);
        body.step(targets, 120 * 20);
        const std::vector<double> angles(body.angles_rad().begin(), body.angles_rad().end());
        double largest_nm = 0.0;
        for (std::size_t h = 0; h < figure.hinges.size(); ++h) {
            CAPTURE(figure.hinges[h].name);
            CHECK(std::abs(body.speeds_rad_s()[h]) < 1e-6);
            std::vector<double> more = angles, less = angles;
            more[h] += 1e-5;
            less[h] -= 1e-5;
            const double weight_nm = (potentialEnergy(figure, state.root.pose, more) -
                                      potentialEnergy(figure, state.root.pose, less)) /
                                     2e-5;
            CHECK(figure.hinges[h].stiffness_nm_rad * (targets[h] - angles[h]) ==
                  doctest::Approx(weight_nm).epsilon(1e-3).scale(1.0));
            largest_nm = std::max(largest_nm, std::abs(weight_nm));
        }
        CHECK(largest_nm > 5.0);
    }

    TEST_CASE("the torques of gravity are the derivatives of the energy, also of a leaning pelvis") {
        const Figure figure = figureOf(Stance::pinned);
        Body body = valueOf(Body::make(figure));
        Random random(8, "angles");
        for (int i = 0; i < 10; ++i) {
            BodyState state = restOf(figure);
            state.angles_rad = drawAngles(figure, random);
            state.root.pose.orientation = glm::angleAxis(0.3, Vec3(1.0, 0.0, 0.0));
            body.setState(state);
            const auto bias = body.biasTorques_nm();
            for (std::size_t h = 0; h < bias.size(); ++h) {
                std::vector<double> more = state.angles_rad, less = state.angles_rad;
                more[h] += 1e-5;
                less[h] -= 1e-5;
                CHECK(bias[h] == doctest::Approx((potentialEnergy(figure, state.root.pose, more) -
                                                  potentialEnergy(figure, state.root.pose, less)) /
                                                 2e-5)
                                     .epsilon(1e-5)
                                     .scale(1.0));
            }
        }
    }

    TEST_CASE("no joint is driven beyond its limits by more than three degrees, and it stays there") {
        const Figure figure = figureOf(Stance::pinned);
        Body body = valueOf(Body::make(figure));
        for (const double direction : {-1.0, 1.0}) {
            body.setState(restOf(figure));
            std::vector<double> targets;
            for (const Hinge& hinge : figure.hinges)
                targets.push_back(direction > 0.0 ? hinge.max_rad + 0.2 : hinge.min_rad - 0.2);
            body.step(targets, 480);
            for (std::size_t h = 0; h < targets.size(); ++h) {
                CAPTURE(figure.hinges[h].name);
                CHECK(body.angles_rad()[h] < figure.hinges[h].max_rad + radiansFromDegrees(3.0));
                CHECK(std::abs(body.speeds_rad_s()[h]) < 1e-3);
                CHECK(body.angles_rad()[h] > figure.hinges[h].min_rad - radiansFromDegrees(3.0));
            }
        }
    }

    TEST_CASE("a body on its feet stands at ease for ten seconds with targets that never change") {
        const Figure figure = figureOf(Stance::free);
        Body body = valueOf(Body::make(figure));
        const motion::LocalPose pose = motion::relaxedPose(figure.skeleton);
        const PoseFit fit = fitPose(figure, pose);
        BodyState state = restOf(figure);
        state.root.pose = rootOf(figure, pose);
        state.angles_rad = fit.angles_rad;
        body.setState(state);
        body.step(fit.angles_rad, 1200);
        const Vec3 hips = body.root().pose.position;
        CHECK(hips.y == doctest::Approx(0.93).epsilon(0.01));
        CHECK(std::abs(hips.x) < 0.03);
        CHECK(std::abs(hips.z) < 0.03);
    }

    TEST_CASE("two bodies do the same bit for bit, and a copy is a body of its own") {
        const Figure figure = figureOf(Stance::free);
        Body one = valueOf(Body::make(figure));
        Body two = valueOf(Body::make(figure));
        const auto run = [&](Body& body) {
            body.setState(restOf(figure));
            Random random(9, "targets");
            for (int i = 0; i < 30; ++i) body.step(drawAngles(figure, random, 0.1), steps_per_control);
            return body.state();
        };
        const BodyState first = run(one), second = run(two);
        CHECK(first.angles_rad == second.angles_rad);
        CHECK(first.speeds_rad_s == second.speeds_rad_s);
        CHECK(first.root.pose.position == second.root.pose.position);

        Body copy(one);
        CHECK(copy.state().angles_rad == first.angles_rad);
        copy.step(first.angles_rad, 4);
        CHECK(copy.state().angles_rad != first.angles_rad);
        CHECK(one.state().angles_rad == first.angles_rad);
        CHECK(run(copy).angles_rad == first.angles_rad);
    }

    TEST_CASE("without MuJoCo no body is made, and the message says which library and what to do") {
        const Figure figure = figureOf(Stance::pinned);
        const auto absent = Body::make(figure, "libmujoco-of-another-day.so.9");
        REQUIRE_FALSE(absent.has_value());
        const std::string text = absent.error().text();
        CHECK(contains(text, "libmujoco-of-another-day.so.9"));
        CHECK(contains(text, "apt-get install libmujoco"));
        CHECK(contains(text, "DEIXIS_MUJOCO"));
        CHECK_FALSE(contains(text, "\n"));

        const auto other = Body::make(figure, "libm.so.6");
        REQUIRE_FALSE(other.has_value());
        CHECK(contains(other.error().text(), "libm.so.6: has no function mj_version"));
        CHECK(Body::make(figure).has_value());
        CHECK(mujocoLibraryName().starts_with("libmujoco"));
    }
}
