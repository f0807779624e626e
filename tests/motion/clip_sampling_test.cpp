#include <doctest/doctest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/random.hpp"
#include "motion/skeleton/clip.hpp"

using namespace deixis;

namespace {

motion::Clip twoFrames(const Quat& a, const Quat& b) {
    motion::Clip clip;
    clip.skeleton.joints.resize(1);
    clip.frame_time_s = 1.0;
    clip.frames.resize(2);
    clip.frames[0].joints.push_back({Vec3(0.0), a});
    clip.frames[1].joints.push_back({Vec3(0.0), b});
    return clip;
}

}  // namespace

TEST_SUITE("motion/clip_sampling") {
    TEST_CASE("Rotations between frames lie on the arc at every angle, to a few last bits") {
        Random random(3);
        double worst = 0.0;
        for (int i = 0; i < 20000; ++i) {
            const Quat a =
                glm::normalize(Quat(random.normal(), random.normal(), random.normal(), random.normal()));
            const Vec3 axis = glm::normalize(Vec3(random.normal(), random.normal(), random.normal()));
            // Angles from 1e-9 to 170 degrees, many of them small and some just around the border of 23.
            const double angle = i % 3 == 0
                                     ? radiansFromDegrees(random.uniform(22.0, 24.0))
                                     : radiansFromDegrees(170.0) * std::pow(10.0, random.uniform(-9.0, 0.0));
            Quat b = a * glm::angleAxis(angle, axis);
            if (i % 2 == 0) b = -b;  // the same rotation
            const double t = random.uniform(1e-6, 1.0 - 1e-6);
            const Quat found = motion::sample(twoFrames(a, b), t).joints[0].orientation;
            Quat expected = a * glm::angleAxis(t * angle, axis);
            if (glm::dot(found, expected) < 0.0) expected = -expected;
            for (const double difference :
                 {found.w - expected.w, found.x - expected.x, found.y - expected.y, found.z - expected.z})
                worst = std::max(worst, std::abs(difference));
        }
        CHECK(worst < 2e-15);
    }

    TEST_CASE("A rotation that stays is kept") {
        const Quat q = glm::normalize(Quat(0.3, -0.5, 0.1, 0.8));
        const Quat found = motion::sample(twoFrames(q, q), 0.37).joints[0].orientation;
        CHECK(std::abs(found.w - q.w) < 1e-15);
        CHECK(std::abs(found.z - q.z) < 1e-15);
    }
}
