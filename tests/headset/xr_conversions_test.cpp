#include <doctest/doctest.h>

#include <cmath>

#include "xr_input.hpp"

using namespace deixis;
using namespace deixis::app;

namespace {

constexpr float half = 0.70710678F;  // sine and cosine of 45 degrees

/// 1 m up and 2 m to the right, turned to the left by 90 degrees.
constexpr XrPosef turned_left{{0.0F, half, 0.0F, half}, {2.0F, 1.0F, 0.0F}};

bool near(const Vec3& a, const Vec3& b) {
    return std::abs(a.x - b.x) < 1e-6 && std::abs(a.y - b.y) < 1e-6 && std::abs(a.z - b.z) < 1e-6;
}

}  // namespace

TEST_SUITE("headset/conversions") {
    TEST_CASE("A runtime's pose moves points as the specification says") {
        const Pose pose = poseFrom(turned_left);
        // Forward (-z) turned to the left is -x.
        CHECK(near(transformPoint(pose, {0.0, 0.0, -1.0}), {1.0, 1.0, 0.0}));
        CHECK(near(transformPoint(pose, {0.0, 1.0, 0.0}), {2.0, 2.0, 0.0}));
    }

    TEST_CASE("An orientation that single precision left a little long has unit length") {
        const Pose pose = poseFrom({{0.6001F, 0.0F, 0.0F, 0.8001F}, {0.0F, 0.0F, 0.0F}});
        CHECK(glm::length(pose.orientation) == doctest::Approx(1.0).epsilon(1e-12));
    }

    TEST_CASE("A pose handed to the runtime and back is the same pose") {
        const XrPosef back = xrPose(poseFrom(turned_left));
        CHECK(back.orientation.x == doctest::Approx(0.0F));
        CHECK(back.orientation.y == doctest::Approx(half));
        CHECK(back.orientation.z == doctest::Approx(0.0F));
        CHECK(back.orientation.w == doctest::Approx(half));
        CHECK(back.position.x == doctest::Approx(2.0F));
        CHECK(back.position.y == doctest::Approx(1.0F));
        CHECK(back.position.z == doctest::Approx(0.0F));
    }

    TEST_CASE("What a runtime does not call valid is not looked at") {
        XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, nullptr, 0, {{NAN, NAN, NAN, NAN}, {NAN, NAN, NAN}}};
        const auto nothing = trackedPose(location);
        CHECK_FALSE(nothing.valid());
        CHECK_FALSE(nothing.tracked);
        CHECK(near(nothing.stage_from_device.position, Vec3(0.0)));
        CHECK(nothing.stage_from_device.orientation == no_rotation);

        location.pose.orientation = turned_left.orientation;
        location.locationFlags =
            XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
        const auto turned = trackedPose(location);
        CHECK(turned.orientation_valid);
        CHECK_FALSE(turned.position_valid);
        CHECK_FALSE(turned.valid());
        CHECK_FALSE(turned.tracked);
        CHECK(near(turned.stage_from_device.position, Vec3(0.0)));
        CHECK(near(turned.stage_from_device.orientation * Vec3(0.0, 0.0, -1.0), {-1.0, 0.0, 0.0}));
    }

    TEST_CASE("A pose is tracked only where both its place and its turn are measured now") {
        constexpr XrSpaceLocationFlags valid =
            XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
        XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, nullptr,
                                 valid | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT, turned_left};
        CHECK(trackedPose(location).valid());
        CHECK_FALSE(trackedPose(location).tracked);
        location.locationFlags |= XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
        CHECK(trackedPose(location).tracked);
    }
}
