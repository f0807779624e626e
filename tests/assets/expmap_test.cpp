#include "assets/joints/expmap_rows.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <vector>

#include "assets/joints/clip_import.hpp"
#include "motion/retarget/retarget.hpp"
#include "shared_data.hpp"
#include "text.hpp"

using namespace deixis;
using assets::ImportedClip;
using assets::Origin;
using deixis::tests::contains;
using doctest::Approx;

namespace {

constexpr double cmu_unit = 0.0254 / 0.45;

/// A row of so many joints: the root's position and the maps of some joints.
std::string row(std::size_t joints, const Vec3& root, const std::map<std::size_t, Vec3>& maps,
                const char* separator = ",") {
    std::string out = fmt::format("{}{}{}{}{}", root.x, separator, root.y, separator, root.z);
    for (std::size_t j = 0; j < joints; ++j) {
        const auto at = maps.find(j);
        const Vec3 map = at == maps.end() ? Vec3(0.0) : at->second;
        for (int axis = 0; axis < 3; ++axis) out += fmt::format("{}{}", separator, map[axis]);
    }
    return out + "\n";
}

ImportedClip parsed(const std::string& text, const assets::ImportOptions& options = {}) {
    auto clip = assets::parseExpmapRows(text, "e.txt", options);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    return std::move(*clip);
}

std::string expmapError(const std::string& text) {
    const auto clip = assets::parseExpmapRows(text, "e.txt");
    REQUIRE_FALSE(clip.has_value());
    return clip.error().text();
}

Vec3 at(const ImportedClip& file, std::size_t frame, const char* joint) {
    const int index = file.clip.skeleton.find(joint);
    REQUIRE(index >= 0);
    return motion::worldPose(file.clip.skeleton, file.clip.frames[frame])[static_cast<std::size_t>(index)]
        .position;
}

}  // namespace

TEST_SUITE("assets/expmap") {
    TEST_CASE("The T pose that begins CMU's rows stands with its thighs upright") {
        // The first row of the published walking_6.txt turns the left thigh by (0, 0, 0.366519143), 21
        // degrees, and the right one back. The thigh's offset (2.59720, -7.13576) leans outwards by
        // atan(2.5972 / 7.13576) = 20.0 degrees; turned the other way round it would lean by 41.
        const ImportedClip file = parsed(
            row(38, {1.3189, 18.0284, -29.6171}, {{2, {0, 0, 0.366519143}}, {8, {0, 0, -0.366519143}}}));
        const Vec3 thigh = at(file, 0, "LeftLeg") - at(file, 0, "LeftUpLeg");
        CHECK(degreesFromRadians(angleBetween(thigh, Vec3(0, -1, 0))) < 1.1);
        const Vec3 other = at(file, 0, "RightLeg") - at(file, 0, "RightUpLeg");
        CHECK(degreesFromRadians(angleBetween(other, Vec3(0, -1, 0))) < 1.1);
        CHECK(glm::length(at(file, 0, "Hips") - cmu_unit * Vec3(1.3189, 18.0284, -29.6171)) < 1e-9);
        CHECK(file.unit.metres == Approx(cmu_unit));
        CHECK(file.unit.origin == Origin::declared);
        CHECK(file.up.axis == assets::UpAxis::y);
        CHECK(file.rate.fps == 30.0);
        CHECK(file.rate.origin == Origin::assumed);
        REQUIRE(file.remarks.size() == 1);
        CHECK(contains(file.remarks[0], "do not give their rate"));
    }

    TEST_CASE("Rotations go down the chain as in the published forward kinematics of row vectors") {
        // By hand: R(v) turns columns by v; a row is turned by the inverse. Spine1 turned about x by a right
        // angle takes Neck's offset (0, 257, 0) to (0, 0, -257); Neck turned about z in that frame takes
        // Head's (0, 121, 0) to (121, 0, 0) before it.
        const double right_angle = pi / 2;
        assets::ImportOptions options;
        options.up_axis = assets::UpAxis::y;
        const ImportedClip file = parsed(
            row(32, {0, 900, 0}, {{12, {right_angle, 0, 0}}, {13, {0, 0, right_angle}}}, " "), options);
        CHECK(glm::length(at(file, 0, "Neck") - at(file, 0, "Spine1") - Vec3(0, 0, -0.257077681)) < 1e-9);
        CHECK(glm::length(at(file, 0, "Head") - at(file, 0, "Neck") - Vec3(0.121134938, 0, 0)) < 1e-9);
        CHECK(file.rate.fps == 25.0);
        CHECK(file.clip.skeleton.size() == 32);
        CHECK(motion::detectHumanoid(file.clip.skeleton).has(motion::Bone::leftHand));
        options.fps = 50.0;
        CHECK(parsed(row(32, {0, 900, 0}, {}, " "), options).rate.origin == Origin::given);
    }

    TEST_CASE("Rows made of the directing-traffic BVH give its joint positions back") {
        const auto path =
            tests::sharedData("pointing/cmu_directing_traffic/DERIVED_directing_traffic_4_30fps.bvh");
        DEIXIS_SKIP_WITHOUT(path);
        const auto bvh = assets::importClip(path);
        REQUIRE(bvh.has_value());
        // That file was made from such rows; its joints are the rows' without the tips, in the same order.
        const ImportedClip skeleton = parsed(row(38, {0, 0, 0}, {}));
        std::string text;
        for (std::size_t f = 0; f < bvh->clip.frames.size(); f += 50) {
            std::map<std::size_t, Vec3> maps;
            for (std::size_t j = 0; j < bvh->clip.skeleton.joints.size(); ++j) {
                const int place = skeleton.clip.skeleton.find(bvh->clip.skeleton.joints[j].name);
                REQUIRE(place >= 0);
                const Quat& q = bvh->clip.frames[f].joints[j].orientation;
                const Vec3 v(q.x, q.y, q.z);
                const double length = glm::length(v);
                if (length > 0.0)
                    maps[static_cast<std::size_t>(place)] = -v * (2.0 * std::atan2(length, q.w) / length);
            }
            text += row(38, bvh->clip.frames[f].joints[0].position / cmu_unit, maps);
        }
        const ImportedClip rows = parsed(text);
        double worst = 0.0;
        for (std::size_t f = 0; f < rows.clip.frames.size(); ++f) {
            const auto expected = motion::worldPose(bvh->clip.skeleton, bvh->clip.frames[50 * f]);
            for (std::size_t j = 0; j < bvh->clip.skeleton.joints.size(); ++j)
                worst = std::max(worst, glm::length(expected[j].position -
                                                    at(rows, f, bvh->clip.skeleton.joints[j].name.c_str())));
        }
        CHECK(worst < 1e-6);
        CHECK(rows.clip.frameCount() == 19);
    }

    TEST_CASE("A figure whose rows are z up stands upright") {
        // The root's map turns the figure from y up to z up: R(-v) with v = (-90 degrees, 0, 0).
        const ImportedClip file = parsed(row(32, {0, 0, 900}, {{0, {-pi / 2, 0, 0}}}));
        CHECK(file.up.axis == assets::UpAxis::z);
        CHECK(file.up.origin == Origin::detected);
        CHECK(at(file, 0, "Head").y > at(file, 0, "Hips").y + 0.5);
        CHECK(at(file, 0, "Hips").y == Approx(0.9));
    }

    TEST_CASE("Each fault is reported with its line") {
        CHECK(contains(expmapError(""), "e.txt: found no lines"));
        CHECK(contains(expmapError("1 2 3\n"),
                       "e.txt:1: found 3 numbers, expected 99 (Human3.6M) or 117 (CMU)"));
        CHECK(contains(expmapError(row(32, {0, 0, 0}, {}) + row(38, {0, 0, 0}, {})),
                       "e.txt:2: found 117 numbers, expected 99"));
        std::string bad = row(32, {0, 0, 0}, {});
        bad.replace(0, 1, "nan");
        CHECK(contains(expmapError(bad), "e.txt:1: found 'nan' in column 1, expected a number from"));
    }
}
