#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/joints/joint_positions.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/generator.hpp"
#include "shared_data.hpp"
#include "text.hpp"

using namespace deixis;
using assets::ImportedClip;
using assets::Origin;
using deixis::tests::contains;
using doctest::Approx;
using motion::Bone;

namespace {

ImportedClip parsed(const std::string& text, const assets::ImportOptions& options = {}) {
    auto clip = assets::parseJointCsv(text, "j.csv", options);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    return std::move(*clip);
}

std::string jointCsvError(const std::string& text) {
    const auto clip = assets::parseJointCsv(text, "j.csv");
    REQUIRE_FALSE(clip.has_value());
    return clip.error().text();
}

motion::Clip pointingClip() {
    const auto direct =
        motion::makeGenerator("direct", motion::referenceHumanoid(), motion::DemonstrationParameters{});
    REQUIRE(direct.has_value());
    return (*direct)->generate({"T001", {0.8, 1.3, 1.9}, 1}).clip;
}

Vec3 at(const motion::Clip& clip, std::size_t frame, Bone bone) {
    return motion::worldPose(clip.skeleton, clip.frames[frame])[static_cast<std::size_t>(bone)].position;
}

struct Named {
    const char* name;
    Vec3 position;
};

/// Somebody 1.7 m tall who stands, faces +z and holds the right arm out to the side (-x), by hand.
std::vector<Named> person() {
    return {
        {"head", {0, 1.6, 0}},          {"leftUpperArm", {0.2, 1.4, 0}},   {"leftLowerArm", {0.2, 1.1, 0}},
        {"leftHand", {0.2, 0.85, 0}},   {"rightUpperArm", {-0.2, 1.4, 0}}, {"rightLowerArm", {-0.5, 1.4, 0}},
        {"rightHand", {-0.75, 1.4, 0}}, {"leftUpperLeg", {0.1, 0.9, 0}},   {"leftLowerLeg", {0.1, 0.5, 0}},
        {"leftFoot", {0.1, 0.08, 0}},   {"rightUpperLeg", {-0.1, 0.9, 0}}, {"rightLowerLeg", {-0.1, 0.5, 0}},
        {"rightFoot", {-0.1, 0.08, 0}}};
}

/// A header in the style that `title` makes of a joint and an axis.
template <typename Title>
std::string header(const Title& title, const std::string& first = "time", char separator = ',') {
    std::string out = first;
    for (const Named& joint : person())
        for (const char axis : {'x', 'y', 'z'}) {
            if (!out.empty()) out += separator;
            out += title(std::string(joint.name), axis);
        }
    return out + "\n";
}

std::string dotted(const std::string& joint, char axis) {
    return joint + "." + axis;
}

std::string row(const std::string& first, double scale = 1.0, char separator = ',', int unknown = -1) {
    std::string out = first;
    int number = 0;
    for (const Named& joint : person()) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!out.empty()) out += separator;
            if (number != unknown) out += fmt::format("{:.4f}", scale * joint.position[axis]);
        }
        ++number;
    }
    return out + "\n";
}

}  // namespace

TEST_SUITE("assets/joint_csv") {
    TEST_CASE("Joints written and read again point every limb as before") {
        const motion::Clip clip = pointingClip();
        const ImportedClip back = parsed(assets::writeJointCsv(clip));
        CHECK(back.rate.fps == Approx(clip.framesPerSecond()));
        CHECK(back.rate.origin == Origin::declared);
        CHECK(back.unit.metres == 1.0);
        CHECK(back.up.axis == assets::UpAxis::y);
        REQUIRE(back.clip.frameCount() == clip.frameCount());
        double worst_deg = 0.0;
        for (std::size_t f = 0; f < clip.frames.size(); ++f)
            for (const auto& [from, to] : {std::pair{Bone::rightUpperArm, Bone::rightLowerArm},
                                           {Bone::rightLowerArm, Bone::rightHand},
                                           {Bone::leftUpperArm, Bone::leftLowerArm},
                                           {Bone::leftLowerArm, Bone::leftHand},
                                           {Bone::rightIndexProximal, Bone::rightIndexIntermediate}})
                worst_deg =
                    std::max(worst_deg,
                             degreesFromRadians(angleBetween(at(clip, f, to) - at(clip, f, from),
                                                             at(back.clip, f, to) - at(back.clip, f, from))));
        CHECK(worst_deg < 3.0);  // the whole is levelled by the mean pose, which leans a little
    }

    TEST_CASE("The columns' names come in several styles, with other separators and units") {
        const std::string plain = header(dotted) + row("0") + row("0.04") + row("0.08");
        const motion::Clip expected = parsed(plain).clip;
        const auto same = [&](const ImportedClip& found) {
            REQUIRE(found.clip.frameCount() == 3);
            for (std::size_t j = 0; j < expected.skeleton.joints.size(); ++j)
                CHECK(glm::length(at(found.clip, 1, static_cast<Bone>(j)) -
                                  at(expected, 1, static_cast<Bone>(j))) < 1e-9);
            CHECK(found.rate.fps == Approx(25.0));
        };
        const auto lines = [](double scale, char separator) {
            return row("0", scale, separator) + row("0.04", scale, separator) + row("0.08", scale, separator);
        };
        same(parsed(header([](const std::string& j, char a) { return j + "_" + a; }) + lines(1.0, ',')));
        same(parsed(header([](const std::string& j, char a) { return std::string(1, a) + "." + j; }) +
                    lines(1.0, ',')));
        same(
            parsed(header([](const std::string& j, char a) { return "\"" + j + "." + char(a - 32) + "\""; }) +
                   lines(1.0, ',')));
        same(parsed(header(dotted, "time", ';') + lines(1.0, ';')));
        same(parsed(header(dotted, "time", '\t') + lines(1.0, '\t')));
        const ImportedClip centimetres = parsed(header(dotted) + lines(100.0, ','));
        same(centimetres);
        CHECK(centimetres.unit.metres == 0.01);
        CHECK(centimetres.unit.origin == Origin::detected);
        const ImportedClip milliseconds =
            parsed(header(dotted, "time_ms") + row("0") + row("40") + row("80"));
        same(milliseconds);
        assets::ImportOptions options;
        options.fps = 25.0;
        const ImportedClip given = parsed(header(dotted) + row("0") + row("1") + row("7"), options);
        same(given);
        CHECK(given.rate.origin == Origin::given);
    }

    TEST_CASE("Without times 30 fps are assumed, and other columns are passed over") {
        const ImportedClip found = parsed(header(dotted, "comment") + row("hello") + row("world"));
        CHECK(found.rate.fps == 30.0);
        CHECK(found.rate.origin == Origin::assumed);
        REQUIRE(found.remarks.size() == 1);
        CHECK(contains(found.remarks[0], "'comment'"));
        CHECK(found.clip.frameCount() == 2);
    }

    TEST_CASE("Names in quotes may hold the separator, and letters be those of Windows") {
        const ImportedClip found = parsed("\xEF\xBB\xBF" + header(dotted, "\"size, cm\"") + row("\"1,7\"") +
                                          "  \r\n" + row("\"1,8\""));
        REQUIRE(found.remarks.size() == 1);
        CHECK(contains(found.remarks[0], "'size, cm'"));
        CHECK(found.clip.frameCount() == 2);
        CHECK(contains(parsed(header(dotted,
                                     "Gr\xF6\xDF"
                                     "e") +
                              row("1"))
                           .remarks[0],
                       "'Gr\u00F6\u00DFe'"));
    }

    TEST_CASE("A blank is a position that nobody knows, bridged by a straight line") {
        const ImportedClip whole = parsed(header(dotted) + row("0") + row("0.1") + row("0.2"));
        const ImportedClip bridged = parsed(header(dotted) + row("0") + row("0.1", 1.0, ',', 6) + row("0.2"));
        CHECK(glm::length(at(bridged.clip, 1, Bone::rightHand) - at(whole.clip, 1, Bone::rightHand)) < 1e-9);
        REQUIRE(bridged.remarks.size() == 1);
        CHECK(contains(bridged.remarks[0], "interpolated"));
        // The right arm points to the person's right.
        const Vec3 arm = at(bridged.clip, 1, Bone::rightHand) - at(bridged.clip, 1, Bone::rightUpperArm);
        CHECK(glm::normalize(arm).x < -0.999);
    }

    TEST_CASE("Uneven times are sampled at their middle step") {
        const ImportedClip found =
            parsed(header(dotted) + row("0") + row("0.1") + row("0.2") + row("0.5") + row("0.6"));
        CHECK(found.rate.fps == Approx(10.0));
        CHECK(found.clip.frameCount() == 7);
        REQUIRE(found.remarks.size() == 1);
        CHECK(contains(found.remarks[0], "not evenly spaced"));
    }

    TEST_CASE("Each fault is reported with its line, what was found and what was expected") {
        const std::string head = header(dotted);
        CHECK(contains(jointCsvError(""), "j.csv: found no lines"));
        CHECK(contains(jointCsvError(head), "j.csv: found no frames"));
        CHECK(contains(jointCsvError("a,b,c,d\n1,2,3,4\n"), "j.csv:1: found no columns of joints"));
        CHECK(contains(jointCsvError("time,head.x,head.y\n"), "j.csv:1: found no column head.z"));
        CHECK(contains(jointCsvError("head.x,head.y,head.z,head.x\n"), "'head.x' twice"));
        CHECK(contains(jointCsvError("p1.x,p1.y,p1.z\n1,2,3\n"), "no joint with the name of a human bone"));
        CHECK(contains(jointCsvError(head + "0,1,2\n"), "j.csv:2: found 3 fields, expected 40"));
        CHECK(contains(jointCsvError(head + row("soon")), "j.csv:2: time: found 'soon'"));
        CHECK(contains(jointCsvError(head + row("1") + row("1")),
                       "j.csv:3: time: found a time that is not after"));
        CHECK(contains(jointCsvError(head + row("0") + row("0.1") + row("1e9")), "with gaps"));
        std::string bad = row("0");
        bad.replace(bad.find("1.6"), 3, "inf");
        CHECK(contains(jointCsvError(head + bad), "head.y: found 'inf000'"));
        // A hand that no line knows.
        CHECK(contains(jointCsvError(head + row("0", 1.0, ',', 6) + row("0.1", 1.0, ',', 6)),
                       "has no position for rightHand"));
        CHECK(contains(jointCsvError(head + row("0", 0.0)), "in one place"));
        std::string far = row("0");
        far.replace(far.find("1.6000"), 6, "1e200");
        CHECK(contains(jointCsvError(head + far), "j.csv: frame 0: found head"));
    }

    TEST_CASE("The joint positions of bvh-toolbox's walk give the pose that its BVH has") {
        const auto folder = tests::sharedData("bvh/bvhtoolbox_walk01");
        DEIXIS_SKIP_WITHOUT(folder);
        const auto csv = assets::importClip(folder / "walk01_pos.csv");
        REQUIRE_MESSAGE(csv.has_value(), (csv ? "" : csv.error().text()));
        CHECK(csv->unit.name == "centimetre");
        CHECK(csv->rate.fps == Approx(24.0));
        const auto bvh = assets::importClip(folder / "walk01.bvh");
        REQUIRE(bvh.has_value());
        REQUIRE(csv->clip.frameCount() == bvh->clip.frameCount());
        // The bend of an elbow does not depend on how the figure is turned.
        const auto bend = [](const Vec3& shoulder, const Vec3& elbow, const Vec3& wrist) {
            return degreesFromRadians(angleBetween(elbow - shoulder, wrist - elbow));
        };
        double worst = 0.0;
        const auto joint = [&](const char* name) {
            const int index = bvh->clip.skeleton.find(name);
            REQUIRE(index >= 0);
            return static_cast<std::size_t>(index);
        };
        const std::size_t arm = joint("LeftArm"), forearm = joint("LeftForeArm"), hand = joint("LeftHand");
        for (std::size_t f = 0; f < bvh->clip.frames.size(); ++f) {
            const auto world = motion::worldPose(bvh->clip.skeleton, bvh->clip.frames[f]);
            worst = std::max(
                worst,
                std::abs(bend(world[arm].position, world[forearm].position, world[hand].position) -
                         bend(at(csv->clip, f, Bone::leftUpperArm), at(csv->clip, f, Bone::leftLowerArm),
                              at(csv->clip, f, Bone::leftHand))));
        }
        CHECK(worst < 0.01);
    }
}
