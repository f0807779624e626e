#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

#include "assets/joints/clip_import.hpp"
#include "assets/joints/joint_positions.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "shared_data.hpp"

using namespace deixis;
using motion::Bone;

namespace {

// A person in Kinect's camera space, 2.5 m away and facing it (-z): x, y, z of the 25 joints by hand; the
// right arm (joints 8 to 11) stretched out to the side, the left hanging. The person's left is -x.
std::array<Vec3, 25> standingPerson() {
    std::array<Vec3, 25> p{};
    p[0] = {0, 0, 2.5};
    p[1] = {0, 0.3, 2.5};
    p[2] = {0, 0.6, 2.5};
    p[3] = {0, 0.75, 2.5};
    p[4] = {-0.2, 0.5, 2.5};
    p[5] = {-0.2, 0.2, 2.5};
    p[6] = {-0.2, -0.05, 2.5};
    p[8] = {0.2, 0.5, 2.5};
    p[9] = {0.5, 0.5, 2.5};
    p[10] = {0.75, 0.5, 2.5};
    p[12] = {-0.1, 0, 2.5};
    p[13] = {-0.1, -0.4, 2.5};
    p[14] = {-0.1, -0.8, 2.5};
    p[16] = {0.1, 0, 2.5};
    p[17] = {0.1, -0.4, 2.5};
    p[18] = {0.1, -0.8, 2.5};
    p[20] = {0, 0.52, 2.5};
    return p;
}

std::string line(double time_s, const std::array<Vec3, 25>& p, int untracked = -1) {
    std::string out = fmt::format("{}", static_cast<long long>(std::llround(time_s * 1e7)) + 97771535532);
    for (int j = 0; j < 25; ++j)
        out += fmt::format(",{},{},{},{}", p[static_cast<std::size_t>(j)].x, p[static_cast<std::size_t>(j)].y,
                           p[static_cast<std::size_t>(j)].z, j == untracked ? 0 : 2);
    return out + ",\r\n";
}

Result<motion::Clip> parsedKinect(const std::string& text, const assets::ImportOptions& options = {}) {
    return assets::parseKinectClip(text, "k.csv", options).map([](assets::ImportedClip&& imported) {
        return std::move(imported.clip);
    });
}

Result<motion::Clip> readKinectClip(const std::filesystem::path& path) {
    return assets::importClip(path).map([](assets::ImportedClip&& imported) {
        CHECK(imported.format == "Kinect v2 joint positions");
        return std::move(imported.clip);
    });
}

std::string kinectError(const std::string& text) {
    const auto clip = parsedKinect(text);
    REQUIRE_FALSE(clip.has_value());
    return clip.error().text();
}

Vec3 jointAt(const motion::Clip& clip, std::size_t frame, Bone bone) {
    return motion::worldPose(clip.skeleton, clip.frames[frame])[static_cast<std::size_t>(bone)].position;
}

}  // namespace

TEST_SUITE("assets/kinect") {
    TEST_CASE("A person who faces the camera stands on the avatar's feet and faces +z") {
        const auto p = standingPerson();
        const auto clip = parsedKinect(line(0, p) + line(0.5, p) + line(1.0, p));
        REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
        CHECK(clip->frameCount() == 31);
        CHECK(clip->framesPerSecond() == doctest::Approx(30.0));
        CHECK(jointAt(*clip, 7, Bone::leftUpperLeg).x > 0.05);
        // The right arm is stretched to the person's right, -x for the avatar; the left hangs.
        const Vec3 right =
            glm::normalize(jointAt(*clip, 7, Bone::rightHand) - jointAt(*clip, 7, Bone::rightUpperArm));
        CHECK(right.x < -0.999);
        const Vec3 left =
            glm::normalize(jointAt(*clip, 7, Bone::leftHand) - jointAt(*clip, 7, Bone::leftUpperArm));
        CHECK(left.y < -0.999);
        CHECK(jointAt(*clip, 7, Bone::head).y == doctest::Approx(1.53).epsilon(0.02));
        CHECK(jointAt(*clip, 7, Bone::leftToes).y == doctest::Approx(0.025).epsilon(0.02));
    }

    TEST_CASE("Gaps and untracked joints are bridged by straight lines") {
        auto p = standingPerson();
        auto raised = p;  // the right arm turns up by 90 degrees
        raised[9] = {0.2, 0.8, 2.5};
        raised[10] = {0.2, 1.05, 2.5};
        auto nonsense = p;
        nonsense[10] = {9, 9, 9};
        const auto clip = parsedKinect(line(0, p) + line(0.1, nonsense, 10) + line(0.2, p) +
                                       line(1.2, raised) + line(1.4, raised));
        REQUIRE(clip.has_value());
        CHECK(clip->frameCount() == 43);
        for (const std::size_t f : {2U, 3U, 4U}) {
            const Vec3 arm =
                glm::normalize(jointAt(*clip, f, Bone::rightHand) - jointAt(*clip, f, Bone::rightUpperArm));
            CHECK(arm.x < -0.99);
        }
        // Half way through the gap the elbow is half way along the line: 45 degrees up.
        const Vec3 upper = jointAt(*clip, 21, Bone::rightLowerArm) - jointAt(*clip, 21, Bone::rightUpperArm);
        CHECK(degreesFromRadians(std::atan2(upper.y, -upper.x)) == doctest::Approx(45.0).epsilon(0.05));
        CHECK(
            glm::normalize(jointAt(*clip, 42, Bone::rightHand) - jointAt(*clip, 42, Bone::rightUpperArm)).y >
            0.99);
    }

    TEST_CASE("With a given rate the lines follow each other at it, whatever their times") {
        const auto p = standingPerson();
        assets::ImportOptions options;
        options.fps = 60.0;
        const auto clip = parsedKinect(line(0, p) + line(0.5, p) + line(3.0, p), options);
        REQUIRE(clip.has_value());
        CHECK(clip->frameCount() == 3);
        CHECK(clip->framesPerSecond() == doctest::Approx(60.0));
    }

    TEST_CASE("Faults are reported with file and line") {
        const auto p = standingPerson();
        const std::string good = line(0, p);
        const auto contains = [](const std::string& text, const std::string& part) {
            INFO(text);
            return text.find(part) != std::string::npos;
        };
        CHECK(contains(kinectError(""), "k.csv: found no lines"));
        CHECK(contains(kinectError(good + "1,2,3\n"), "k.csv:2: found 3 columns, expected 101"));
        CHECK(contains(kinectError(good + "hello\n"),
                       "k.csv:2: found 'hello' in column 1, expected a finite number"));
        CHECK(contains(kinectError("5,nan" + good.substr(good.find(',', 12)) + "\n"), "column 2"));
        CHECK(contains(kinectError(line(1, p) + good), "k.csv:2: found a time that is not after"));
        CHECK(contains(kinectError(good + line(1e5, p)), "found 2 lines spread over 100000 s, with gaps"));
        CHECK(contains(kinectError(line(0, p, 10)), "no position for rightHand"));
    }

    TEST_CASE("In the recorded pointing gesture the right arm is straight and raised at 3.6 s") {
        const auto path = tests::sharedData("pointing/labanotation_kinect/Ges05_demopoint.csv");
        DEIXIS_SKIP_WITHOUT(path);
        const auto clip = readKinectClip(path);
        REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
        CHECK(clip->duration_s() == doctest::Approx(6.33).epsilon(0.01));
        const std::size_t f = 108;  // 3.6 s
        const Vec3 upper = jointAt(*clip, f, Bone::rightLowerArm) - jointAt(*clip, f, Bone::rightUpperArm);
        const Vec3 lower = jointAt(*clip, f, Bone::rightHand) - jointAt(*clip, f, Bone::rightLowerArm);
        CHECK(degreesFromRadians(angleBetween(upper, lower)) < 20.0);
        CHECK(jointAt(*clip, f, Bone::rightHand).y > jointAt(*clip, f, Bone::rightUpperArm).y + 0.2);
        CHECK(jointAt(*clip, f, Bone::rightHand).x < -0.4);
        CHECK(jointAt(*clip, 0, Bone::rightHand).y <
              jointAt(*clip, 0, Bone::hips).y + 0.05);  // at the start it hangs
        for (std::size_t i = 0; i < clip->frames.size(); ++i) {
            CHECK(jointAt(*clip, i, Bone::head).y - jointAt(*clip, i, Bone::hips).y > 0.5);
            const double lowest =
                std::min(jointAt(*clip, i, Bone::leftToes).y, jointAt(*clip, i, Bone::rightToes).y);
            CHECK(lowest == doctest::Approx(0.025).epsilon(0.02));
        }
    }

    TEST_CASE("All six recorded gestures play") {
        for (const char* name : {"Ges01_wavehand", "Ges02_balancinghands", "Ges03_drawlines",
                                 "Ges04_comehere", "Ges05_demopoint", "Ges06_chickenwing"}) {
            const auto path = tests::sharedData("pointing/labanotation_kinect/" + std::string(name) + ".csv");
            DEIXIS_SKIP_WITHOUT(path);
            const auto clip = readKinectClip(path);
            INFO(std::string(name));
            REQUIRE(clip.has_value());
            double fastest_deg = 0.0;  // no bone flips from one frame to the next
            for (std::size_t f = 1; f < clip->frames.size(); ++f)
                for (std::size_t j = 0; j < clip->frames[f].joints.size(); ++j) {
                    const double cosine = std::abs(glm::dot(clip->frames[f].joints[j].orientation,
                                                            clip->frames[f - 1].joints[j].orientation));
                    fastest_deg =
                        std::max(fastest_deg, degreesFromRadians(2.0 * std::acos(std::min(1.0, cosine))));
                }
            CHECK(fastest_deg < 60.0);
        }
    }
}
