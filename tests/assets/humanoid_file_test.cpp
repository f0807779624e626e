#include "assets/tables/humanoid_file.hpp"

#include <doctest/doctest.h>

#include <string>

#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using motion::Bone;

namespace {

Result<void> applied(const std::string& text, const motion::Skeleton& skeleton,
                     motion::HumanoidMapping& mapping) {
    const auto said = assets::parseHumanoidText(text, "walk.humanoid.toml");
    if (!said) return tl::unexpected(said.error());
    return assets::applyHumanoidWords(*said, skeleton, mapping);
}

std::string overrideError(const std::string& text) {
    const auto& skeleton = motion::referenceHumanoid();
    auto mapping = motion::mapHumanoid(skeleton);
    const auto done = applied(text, skeleton, mapping);
    REQUIRE_FALSE(done.has_value());
    return done.error().text();
}

}  // namespace

TEST_SUITE("assets/humanoid_file") {
    TEST_CASE("The file's name follows the clip's") {
        CHECK(assets::humanoidFileOf("a/walk.bvh") == "a/walk.humanoid.toml");
        CHECK(assets::humanoidFileOf("a/walk.1.bvh.gz") == "a/walk.1.humanoid.toml");
    }

    TEST_CASE("What the file says stands, and takes a joint from the bone that it was found for") {
        const auto& skeleton = motion::referenceHumanoid();
        auto mapping = motion::mapHumanoid(skeleton);
        REQUIRE(
            applied("leftHand = \"leftLowerArm\"\nleftToes = \"\"  # none\n", skeleton, mapping).has_value());
        CHECK(mapping.map[Bone::leftHand] == skeleton.find("leftLowerArm"));
        CHECK(mapping.foundBy(Bone::leftHand) == motion::FoundBy::override_);
        CHECK_FALSE(mapping.map.has(Bone::leftLowerArm));
        CHECK_FALSE(mapping.map.has(Bone::leftToes));
        CHECK(mapping.map[Bone::rightHand] == skeleton.find("rightHand"));
    }

    TEST_CASE("A whole mapping written and applied is the same mapping") {
        const auto& skeleton = motion::referenceHumanoid();
        auto found = motion::mapHumanoid(skeleton);
        std::swap(found.map[Bone::leftHand], found.map[Bone::rightHand]);
        found.map[Bone::jaw] = -1;
        auto mapping = motion::mapHumanoid(skeleton);
        REQUIRE(applied(assets::humanoidToml(found, skeleton), skeleton, mapping).has_value());
        CHECK(mapping.map.joint == found.map.joint);
    }

    TEST_CASE("Mistakes are told with line, what was found and expected, and the nearest name") {
        CHECK(
            overrideError("# bones\nleftHnad = \"leftHand\"\n") ==
            "walk.humanoid.toml:2: leftHnad: unknown bone, expected a bone of VRM 1.0, such as leftUpperArm. "
            "Did you mean leftHand?");
        CHECK(overrideError("leftHand = \"leftHnad\"\n") ==
              "walk.humanoid.toml:1: leftHand: found \"leftHnad\", expected one of the figure's 55 joints. "
              "Did you mean leftHand?");
        CHECK(overrideError("leftHand = 3\n").find("found no text, expected a joint's name") !=
              std::string::npos);
        CHECK(overrideError("leftHand = \"head\"\nrightHand = \"head\"\n").find("already has") !=
              std::string::npos);
        CHECK(overrideError("leftHand = \n").find("walk.humanoid.toml:1") == 0);
        for (const std::string height : {"nan", "inf", "0", "-1.7", "17", "\"1.7\""})
            CHECK(overrideError("height_m = " + height + "\n") ==
                  "walk.humanoid.toml:1: height_m: expected an avatar's height from 0.3 to 3 metres");
    }
}
