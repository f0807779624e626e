#include "core/pose.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/random.hpp"

using namespace deixis;

namespace {

Vec3 randomDirection(Random& random) {
    return glm::normalize(Vec3(random.normal(), random.normal(), random.normal()));
}

}  // namespace

TEST_SUITE("core/pose") {
    TEST_CASE("a pose times its inverse is no change") {
        Random random(1);
        for (int i = 0; i < 100; ++i) {
            const Pose pose{Vec3(random.normal(), random.normal(), random.normal()),
                            glm::angleAxis(random.uniform(-3.0, 3.0), randomDirection(random))};
            const Vec3 point(random.normal(), random.normal(), random.normal());
            const Vec3 back = transformPoint(inverse(pose), transformPoint(pose, point));
            CHECK(glm::length(back - point) < 1e-12);
            CHECK(glm::length(transformPoint(pose * inverse(pose), point) - point) < 1e-12);
        }
    }

    TEST_CASE("a positive yaw turns from straight ahead to the avatar's left") {
        const Vec3 turned = yawRotation(radiansFromDegrees(90.0)) * Vec3(0, 0, 1);
        CHECK(turned.x == doctest::Approx(1.0));
        CHECK(std::abs(turned.z) < 1e-12);
    }

    TEST_CASE("the shortest rotation takes one direction to the other, opposite ones too") {
        Random random(2);
        for (int i = 0; i < 100; ++i) {
            const Vec3 a = randomDirection(random);
            const Vec3 b = i % 10 == 0 ? -a : randomDirection(random);
            CHECK(glm::length(rotationBetween(a, b) * a - b) < 1e-9);
        }
    }

    TEST_CASE("angles between nearly equal directions keep their digits") {
        CHECK(angleBetween({1, 0, 0}, {1, 1e-9, 0}) == doctest::Approx(1e-9));
        CHECK(angleBetween({1, 0, 0}, {-2, 0, 0}) == doctest::Approx(pi));
    }

    TEST_CASE("a ray meets a sphere where geometry says, and only ahead") {
        const Ray ray{{0, 0, 0}, {0, 0, 1}};
        CHECK(distanceToSphere(ray, {0, 0, 5}, 1.0) == doctest::Approx(4.0));
        CHECK(distanceToSphere(ray, {0, 1.5, 5}, 1.0) < 0.0);
        CHECK(distanceToSphere(ray, {0, 0, -5}, 1.0) < 0.0);
        CHECK(distanceToSphere(ray, {0, 0, 0.2}, 1.0) == doctest::Approx(0.0));
    }
}
