// Files as people really have them: times and lengths in other units, other separators, damaged numbers.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "assets/joints/bvh.hpp"
#include "assets/joints/clip_import.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using motion::Bone;

namespace {

/// The reference humanoid with legs for this stature (thigh and shin are 0.491 of it), in some unit.
std::string bvhOf(double stature_units, int frames = 3) {
    motion::Clip clip;
    clip.skeleton = motion::referenceHumanoid();
    const auto world = motion::worldPose(clip.skeleton, motion::restPose(clip.skeleton));
    const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(bone)].position; };
    const double legs = glm::length(at(Bone::leftLowerLeg) - at(Bone::leftUpperLeg)) +
                        glm::length(at(Bone::leftFoot) - at(Bone::leftLowerLeg));
    const double scale = stature_units * 0.491 / legs;
    for (auto& joint : clip.skeleton.joints) {
        joint.rest.position *= scale;
        if (joint.end_site) *joint.end_site *= scale;
    }
    clip.frames.assign(static_cast<std::size_t>(frames), motion::restPose(clip.skeleton));
    return assets::writeBvh(clip);
}

std::string withLine(std::string text, const std::string& begins, const std::string& instead) {
    const auto at = text.find(begins);
    REQUIRE(at != std::string::npos);
    return text.replace(at, text.find('\n', at) - at, instead);
}

std::string rejection(const std::string& text, const std::string& name,
                      const assets::ImportOptions& options = {}) {
    const auto clip = assets::importClipBytes(text, name, options);
    REQUIRE_FALSE(clip.has_value());
    return clip.error().text();
}

assets::ImportedClip imported(const std::string& text, const std::string& name,
                              const assets::ImportOptions& options = {}) {
    auto clip = assets::importClipBytes(text, name, options);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    return std::move(*clip);
}

/// A person who stands, 1.7 m tall, with the right hand going out at 1 m/s; a line for each time.
std::string csvOf(const std::vector<double>& times_s, const std::string& time = "time", double unit_s = 1.0) {
    std::string out = time;
    const std::vector<std::pair<const char*, Vec3>> joints{{"hips", {0, 0.95, 0}},
                                                           {"neck", {0, 1.45, 0}},
                                                           {"head", {0, 1.6, 0}},
                                                           {"leftUpperArm", {0.2, 1.4, 0}},
                                                           {"leftLowerArm", {0.2, 1.1, 0}},
                                                           {"leftHand", {0.2, 0.85, 0}},
                                                           {"rightUpperArm", {-0.2, 1.4, 0}},
                                                           {"rightLowerArm", {-0.2, 1.1, 0}},
                                                           {"rightHand", {-0.2, 0.85, 0}},
                                                           {"leftUpperLeg", {0.1, 0.9, 0}},
                                                           {"leftLowerLeg", {0.1, 0.5, 0}},
                                                           {"leftFoot", {0.1, 0.08, 0}},
                                                           {"rightUpperLeg", {-0.1, 0.9, 0}},
                                                           {"rightLowerLeg", {-0.1, 0.5, 0}},
                                                           {"rightFoot", {-0.1, 0.08, 0}}};
    for (const auto& [name, place] : joints) out += fmt::format(",{0}.x,{0}.y,{0}.z", name);
    for (const double t : times_s) {
        out += fmt::format("\n{:.6f}", t / unit_s);
        for (const auto& [name, place] : joints) {
            const bool hand = std::string(name) == "rightHand";
            // The forearm turns from hanging to level in the time that the course lasts.
            const double angle = 0.5 * pi * (t - times_s.front()) / (times_s.back() - times_s.front());
            const Vec3 p =
                hand ? Vec3(-0.2 - 0.25 * std::sin(angle), 1.1 - 0.25 * std::cos(angle), 0.0) : place;
            out += fmt::format(",{:.6f},{:.6f},{:.6f}", p.x, p.y, p.z);
        }
    }
    return out + "\n";
}

double forearmDegrees(const motion::Clip& clip, std::size_t frame) {
    const auto world = motion::worldPose(clip.skeleton, clip.frames[frame]);
    const Vec3 forearm = world[static_cast<std::size_t>(Bone::rightHand)].position -
                         world[static_cast<std::size_t>(Bone::rightLowerArm)].position;
    return degreesFromRadians(std::atan2(-forearm.x, -forearm.y));
}

std::string replacedAll(std::string text, const std::string& what, const std::string& with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

/// Lines of a Kinect recording: the same person, 30 lines a second.
std::string kinectLines() {
    const std::vector<std::pair<int, Vec3>> person{
        {0, {0, 0, 2.5}},        {3, {0, 0.75, 2.5}},     {4, {-0.2, 0.5, 2.5}},   {5, {-0.2, 0.2, 2.5}},
        {6, {-0.2, -0.05, 2.5}}, {8, {0.2, 0.5, 2.5}},    {9, {0.5, 0.5, 2.5}},    {10, {0.75, 0.5, 2.5}},
        {12, {-0.1, 0, 2.5}},    {13, {-0.1, -0.4, 2.5}}, {14, {-0.1, -0.8, 2.5}}, {16, {0.1, 0, 2.5}},
        {17, {0.1, -0.4, 2.5}},  {18, {0.1, -0.8, 2.5}},  {20, {0, 0.52, 2.5}}};
    std::string out;
    for (int line = 0; line < 6; ++line) {
        out += fmt::format("{}", 97771535532LL + line * 333333LL);
        for (int j = 0; j < 25; ++j) {
            Vec3 p(0.0);
            for (const auto& [joint, place] : person)
                if (joint == j) p = place;
            out += fmt::format(",{},{},{},2", p.x, p.y, p.z);
        }
        out += "\n";
    }
    return out;
}

}  // namespace

TEST_SUITE("assets/odd_files") {
    TEST_CASE("A frame time in milliseconds, or that is a rate, is rejected with file, line and hint") {
        const std::string text = bvhOf(1.75);
        for (const char* wrong : {"33.3", "30", "1.1", "0.00001", "1e300"}) {
            const std::string odd = withLine(text, "Frame Time:", fmt::format("Frame Time: {}", wrong));
            const std::string error = rejection(odd, "a.bvh");
            CHECK(contains(error,
                           fmt::format("found frame time '{}', expected seconds from 0.0001 to 1", wrong)));
            CHECK(contains(error, "--fps"));
            assets::ImportOptions options;
            options.fps = 30.0;
            CHECK(imported(odd, "a.bvh", options).clip.framesPerSecond() == doctest::Approx(30.0));
        }
        CHECK(imported(withLine(text, "Frame Time:", "Frame Time: 1"), "a.bvh").rate.fps ==
              doctest::Approx(1.0));
        CHECK(
            contains(rejection(withLine(text, "Frame Time:", "Frame Time: nan"), "a.bvh"), "finite number"));
    }

    TEST_CASE("A bone of hundreds of metres is rejected, with its joint, whatever unit was found") {
        const std::string text = bvhOf(175.0);
        const auto knee = text.find("leftLowerLeg");
        const auto offset = text.find("OFFSET", knee);
        const std::string odd =
            text.substr(0, offset) + "OFFSET 0 -1000000 0" + text.substr(text.find('\n', offset));
        const std::string error = rejection(odd, "a.bvh");
        CHECK(contains(error, "joint 'leftLowerLeg': found a bone of 1000 m, in unit millimetre"));
        CHECK(contains(error, "--unit"));
        assets::ImportOptions options;
        options.metres_per_unit = 1e-5;
        CHECK(imported(odd, "a.bvh", options).clip.skeleton.size() == motion::referenceHumanoid().size());
        for (const char* wrong : {"nan", "inf", "-inf", "1e999"})
            CHECK(contains(rejection(replacedAll(odd, "-1000000", wrong), "a.bvh"),
                           "expected a finite number"));
    }

    TEST_CASE("Children in centimetres are not read as adults in inches") {
        for (const double stature_cm : {96.0, 102.0, 115.0, 130.0, 139.0}) {
            CAPTURE(stature_cm);
            const auto child = imported(bvhOf(stature_cm), "child.bvh");
            CHECK(child.unit.metres == doctest::Approx(0.01));
            CHECK(child.unit.origin == assets::Origin::assumed);
            CHECK(contains(
                child.unit.name,
                fmt::format("centimetre, in which the figure is a child {:.2f} m tall", stature_cm / 100.0)));
        }
        CHECK(imported(bvhOf(1.1), "child.bvh").unit.metres == doctest::Approx(1.0));
        CHECK(imported(bvhOf(1100.0), "child.bvh").unit.metres == doctest::Approx(0.001));
        // Adults as before, of any unit; somebody taller than any unit allows is taken as the nearest.
        for (const double inches : {56.0, 68.0, 82.0})
            CHECK(imported(bvhOf(inches), "a.bvh").unit.metres == doctest::Approx(0.0254));
        CHECK(imported(bvhOf(215.0), "a.bvh").unit.metres == doctest::Approx(0.01));
    }

    TEST_CASE(
        "Uneven times are sampled at their middle step, also where that gives as many frames as lines") {
        // Steps of 40, 20, ... ms: as many frames of the middle step as there are lines.
        std::vector<double> times{0.0};
        for (int i = 0; i < 20; ++i)
            times.push_back(times.back() + (i % 3 == 0 ? 0.04 : i % 3 == 1 ? 0.02 : 0.03));
        const auto clip = imported(csvOf(times), "a.csv");
        const double step_s = clip.clip.frame_time_s;
        CHECK(step_s == doctest::Approx(0.03));
        CHECK(clip.clip.frameCount() == static_cast<int>(times.size()));
        for (std::size_t f = 0; f < times.size(); ++f)
            CHECK(forearmDegrees(clip.clip, f) ==
                  doctest::Approx(90.0 * std::min(1.0, static_cast<double>(f) * step_s / times.back()))
                      .epsilon(0.02));
    }

    TEST_CASE("Seconds that are milliseconds are rejected with the column's right name") {
        std::vector<double> times;
        for (int i = 0; i < 10; ++i) times.push_back(0.0333 * i);
        CHECK(imported(csvOf(times, "time_ms", 1e-3), "a.csv").rate.fps ==
              doctest::Approx(30.0).epsilon(0.01));
        const std::string error = rejection(csvOf(times, "time", 1e-3), "a.csv");
        CHECK(contains(error, "a.csv: found lines that are 33.3 s apart"));
        CHECK(contains(error, "time_ms"));
    }

    TEST_CASE("Kinect recordings with a byte order mark, blanks, semicolons or tabs are read alike") {
        const std::string plain = kinectLines();
        const auto expected = imported(plain, "k.csv");
        CHECK(expected.format == "Kinect v2 joint positions");
        for (const std::string& other : {"\xEF\xBB\xBF" + plain, replacedAll(plain, ",", ", "),
                                         replacedAll(plain, ",", ";"), replacedAll(plain, ",", "; "),
                                         replacedAll(plain, ",", "\t"), replacedAll(plain, "\n", ",\r\n")}) {
            const auto clip = imported(other, "k.csv");
            CHECK(clip.format == expected.format);
            REQUIRE(clip.clip.frameCount() == expected.clip.frameCount());
            for (std::size_t j = 0; j < clip.clip.skeleton.joints.size(); ++j)
                CHECK(clip.clip.frames[2].joints[j].orientation ==
                      expected.clip.frames[2].joints[j].orientation);
        }
    }

    TEST_CASE("Decimal commas are rejected in one message, as are numbers that are not finite") {
        std::string commas = replacedAll(replacedAll(kinectLines(), ",", ";"), ".", ",");
        const std::string error = rejection(commas, "k.csv");
        CHECK(contains(error, "k.csv:1: found '2,5' in column 4, expected a finite number"));
        CHECK(contains(error, "Decimals must have a point"));
        const std::vector<double> times{0.0, 0.0333, 0.0667};
        CHECK(contains(rejection(replacedAll(csvOf(times), "0.950000", "inf"), "a.csv"),
                       "hips.y: found 'inf', expected a finite number or nothing"));
        CHECK(contains(rejection(replacedAll(kinectLines(), ",0.75,", ",inf,"), "k.csv"), "'inf' in column"));
        CHECK(contains(rejection(replacedAll(kinectLines(), "97771868865", "nan"), "k.csv"),
                       "k.csv:2: found 'nan' in column 1"));
        // Kinect's times in milliseconds would be one moment.
        std::string brief = kinectLines();
        for (int line = 0; line < 6; ++line)
            brief = replacedAll(brief, fmt::format("{},", 97771535532LL + line * 333333LL),
                                fmt::format("{},", 9777153 + 33 * line));
        CHECK(contains(rejection(brief, "k.csv"), "in units of 100 ns"));
    }
}
