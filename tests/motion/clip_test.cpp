#include "motion/skeleton/clip.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace deixis;
using doctest::Approx;

namespace {

// One joint that moves 1 m and turns 90 degrees about y in each of its steps.
motion::Clip twoSteps() {
    motion::Clip clip;
    clip.skeleton.joints.push_back({"root", -1, {}, std::nullopt});
    clip.frame_time_s = 0.5;
    for (int f = 0; f < 3; ++f) clip.frames.push_back({{{Vec3(f, 0, 0), yawRotation(f * pi / 2)}}});
    return clip;
}

}  // namespace

TEST_SUITE("motion/clip") {
    TEST_CASE("Between two frames positions are linear and rotations on the arc") {
        const auto pose = motion::sample(twoSteps(), 0.75);
        CHECK(pose.joints[0].position.x == Approx(1.5));
        // +z turned by 135 degrees towards +x
        const Vec3 z = pose.joints[0].orientation * Vec3(0, 0, 1);
        CHECK(glm::length(z - Vec3(std::sqrt(0.5), 0, -std::sqrt(0.5))) < 1e-12);
    }

    TEST_CASE("Times outside the clip give its ends") {
        const auto clip = twoSteps();
        CHECK(motion::sample(clip, -3.0).joints[0].position.x == 0.0);
        CHECK(motion::sample(clip, 1.0).joints[0].position.x == 2.0);
        CHECK(motion::sample(clip, 99.0).joints[0].position.x == 2.0);
    }

    TEST_CASE("The sign of a quaternion does not send a rotation the long way round") {
        auto clip = twoSteps();
        clip.frames[1].joints[0].orientation = -clip.frames[1].joints[0].orientation;
        const Vec3 z = motion::sample(clip, 0.25).joints[0].orientation * Vec3(0, 0, 1);
        CHECK(glm::length(z - Vec3(std::sqrt(0.5), 0, std::sqrt(0.5))) < 1e-12);
    }

    TEST_CASE("A resampled clip has the length and the poses of the old one") {
        const auto clip = motion::resample(twoSteps(), 0.2).value();
        CHECK(clip.frameCount() == 6);
        CHECK(clip.duration_s() == Approx(1.0));
        for (int f = 0; f < 6; ++f)
            CHECK(clip.frames[static_cast<std::size_t>(f)].joints[0].position.x == Approx(0.4 * f));
        CHECK(motion::resample(twoSteps(), 0.3)->frameCount() == 4);  // 0, 0.3, 0.6, 0.9 s
    }

    TEST_CASE("Resampling at the clip's own rate changes nothing") {
        const auto clip = twoSteps();
        const auto same = motion::resample(clip, clip.frame_time_s).value();
        REQUIRE(same.frameCount() == 3);
        for (std::size_t f = 0; f < 3; ++f)
            CHECK(same.frames[f].joints[0].orientation == clip.frames[f].joints[0].orientation);
    }

    TEST_CASE("A clip of hours is not resampled to more than memory holds, however high the rate") {
        auto clip = twoSteps();
        clip.frame_time_s = 33.3;
        for (const double frame_time_s : {1e-9, 1e-300, 1e-6}) {
            const auto many = motion::resample(clip, frame_time_s);
            REQUIRE_FALSE(many.has_value());
            CHECK(many.error().message.find("found a clip of 66 s") != std::string::npos);
        }
        CHECK(motion::resample(clip, 0.1)->frameCount() == 667);
    }
}
