// The body's masses against de Leva's sums, and which avatars have a body.
#include <cmath>
#include <glm/matrix.hpp>

#include "bodies.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::physics;
using namespace deixis::tests;

namespace {

double massOf(const Figure& figure, std::initializer_list<const char*> names) {
    double kg = 0.0;
    for (const char* name : names) kg += figure.segments[figure.segment(name)].mass.mass_kg;
    return kg;
}

}  // namespace

TEST_SUITE("physics/figure") {
    TEST_CASE(
        "the avatar's body is as tall as the avatar, and as heavy as the table's people of that height") {
        const Figure figure = figureOf(Stance::free);
        CHECK(figure.stature_m == doctest::Approx(1.75).epsilon(1e-9));
        // The mean of 73.0 kg / 1.741^2 m^2 and 61.9 kg / 1.735^2 m^2, times 1.75^2 m^2.
        CHECK(figure.mass_kg == doctest::Approx(68.366).epsilon(1e-4));
        double kg = 0.0;
        for (const Segment& segment : figure.segments) kg += segment.mass.mass_kg;
        // The women's column adds up to 99.99 percent.
        CHECK(kg == doctest::Approx(0.99995 * figure.mass_kg).epsilon(1e-9));
    }

    TEST_CASE("parts of the body are the table's shares of it") {
        const Figure figure = figureOf(Stance::free);
        const double kg = figure.mass_kg;
        // The table's whole trunk, 42.57 (women) and 43.46 percent (men).
        CHECK(massOf(figure, {"pelvis", "chest"}) / kg == doctest::Approx(0.43015).epsilon(1e-6));
        CHECK(massOf(figure, {"head"}) / kg == doctest::Approx(0.0681).epsilon(1e-6));
        CHECK(massOf(figure, {"left upper arm", "left forearm", "left hand"}) / kg ==
              doctest::Approx(0.5 * (0.0255 + 0.0138 + 0.0056 + 0.0271 + 0.0162 + 0.0061)).epsilon(1e-6));
        CHECK(massOf(figure, {"right thigh", "right shank", "right foot"}) / kg ==
              doctest::Approx(0.5 * (0.1478 + 0.0481 + 0.0129 + 0.1416 + 0.0433 + 0.0137)).epsilon(1e-6));
    }

    TEST_CASE("the trunk's three parts together have the centre and the radii of the table's whole trunk") {
        // C7 one metre above the middle of the hips. Rows of the table that the body is not made from: centre
        // 49.64 / 51.38 percent from C7; radii 30.7 / 32.8, 29.2 / 30.6, 14.7 / 16.9.
        const Vec3 front(0.0, 0.0, 1.0);
        const double xiphoid = 1.0 - upper_trunk_share, navel = xiphoid - middle_trunk_share;
        const auto part = [&](BodyPart which, double from, double to) {
            return massOf(which, 1.0, {0.0, from, 0.0}, {0.0, to, 0.0}, front);
        };
        const MassProperties trunk = together(
            together(part(BodyPart::upper_trunk, 1.0, xiphoid), part(BodyPart::middle_trunk, xiphoid, navel)),
            part(BodyPart::lower_trunk, navel, 0.0));
        CHECK(trunk.mass_kg == doctest::Approx(0.43015));
        CHECK(1.0 - trunk.centre_m.y == doctest::Approx(0.5051).epsilon(0.01));
        const auto radius = [&](int axis) {
            return std::sqrt(trunk.inertia_kg_m2[axis][axis] / trunk.mass_kg);
        };
        CHECK(radius(2) == doctest::Approx(0.3175).epsilon(0.02));
        CHECK(radius(0) == doctest::Approx(0.2990).epsilon(0.02));
        CHECK(radius(1) == doctest::Approx(0.1580).epsilon(0.05));
    }

    TEST_CASE("two points of one kilogram, two metres apart, turn with two kilogram square metres") {
        MassProperties a, b;
        a.mass_kg = b.mass_kg = 1.0;
        b.centre_m = {2.0, 0.0, 0.0};
        const MassProperties both = together(a, b);
        CHECK(both.centre_m == Vec3(1.0, 0.0, 0.0));
        CHECK(both.inertia_kg_m2[0][0] == 0.0);
        CHECK(both.inertia_kg_m2[1][1] == 2.0);
        CHECK(both.inertia_kg_m2[2][2] == 2.0);
    }

    TEST_CASE("every inertia is one that a rigid body can have, and both sides have the same") {
        const Figure figure = figureOf(Stance::free);
        for (const Segment& segment : figure.segments) {
            CAPTURE(segment.name);
            const glm::dmat3& i = segment.mass.inertia_kg_m2;
            CHECK(glm::determinant(i) > 0.0);
            CHECK(i[0][0] + i[1][1] > i[2][2]);
            CHECK(i[1][1] + i[2][2] > i[0][0]);
            CHECK(i[2][2] + i[0][0] > i[1][1]);
            if (!segment.name.starts_with("left")) continue;
            const Segment& other = figure.segments[figure.segment("right" + segment.name.substr(4))];
            CHECK(other.mass.mass_kg == segment.mass.mass_kg);
            for (int axis = 0; axis < 3; ++axis)
                CHECK(other.mass.inertia_kg_m2[axis][axis] == doctest::Approx(i[axis][axis]).epsilon(1e-12));
        }
    }

    TEST_CASE("a pinned body has 14 degrees of freedom, one on its feet 28 without the pelvis") {
        CHECK(figureOf(Stance::pinned).hinges.size() == 14);
        CHECK(figureOf(Stance::free).hinges.size() == 28);
    }

    TEST_CASE("an avatar without a bone, a trunk or a T pose has no body, and the message says why") {
        const auto problem = [](const auto& change) {
            motion::Skeleton avatar = motion::referenceHumanoid();
            change(avatar);
            const auto made = makeFigure(avatar, Stance::pinned);
            REQUIRE_FALSE(made.has_value());
            return made.error().text();
        };
        const auto rename = [](std::initializer_list<const char*> names) {
            return [names](motion::Skeleton& avatar) {
                for (const char* name : names)
                    avatar.joints[static_cast<std::size_t>(avatar.find(name))].name = std::string("x") + name;
            };
        };
        CHECK(contains(problem(rename({"rightLowerArm"})), "no bone 'rightLowerArm'"));
        CHECK(
            contains(problem(rename({"spine", "chest", "upperChest"})), "'spine', 'chest' and 'upperChest'"));
        CHECK(contains(problem([](motion::Skeleton& avatar) {
                           avatar.joints[3].rest.orientation = Quat(0.8, 0.6, 0.0, 0.0);
                       }),
                       "rest rotation"));
        CHECK(
            contains(problem([](motion::Skeleton& avatar) {
                         avatar.joints[static_cast<std::size_t>(avatar.find("leftHand"))].rest.position = {};
                     }),
                     "'leftLowerArm' has no length"));
    }

    TEST_CASE("an avatar with fewer joints in trunk and neck has the same body") {
        motion::Skeleton avatar = motion::referenceHumanoid();
        for (const char* name : {"spine", "chest", "neck"})
            avatar.joints[static_cast<std::size_t>(avatar.find(name))].name = std::string("x") + name;
        const Figure figure = valueOf(makeFigure(avatar, Stance::pinned));
        CHECK(figure.hinges.size() == 14);
        CHECK(figure.segments[figure.segment("chest")].turning.size() == 1);
        CHECK(figure.segments[figure.segment("chest")].turning.front().share == doctest::Approx(1.0));
    }
}
