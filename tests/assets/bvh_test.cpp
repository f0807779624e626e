#include "assets/joints/bvh.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>
#include <string>

#include "core/files.hpp"
#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "shared_data.hpp"
#include "text.hpp"

using namespace deixis;
using assets::parseBvh;
using deixis::tests::contains;
using doctest::Approx;

namespace {

// A root with two joints; the arm's channels are given by the test.
std::string smallFile(const std::string& arm_channels, const std::string& motion) {
    return "HIERARCHY\nROOT base\n{\n OFFSET 1 2 3\n CHANNELS 6 Xposition Yposition Zposition Zrotation "
           "Xrotation Yrotation\n JOINT arm\n {\n  OFFSET 0 5 0\n  CHANNELS " +
           arm_channels + "\n  JOINT tip\n  {\n   OFFSET 2 0 0\n   CHANNELS 0\n  }\n }\n}\nMOTION\n" + motion;
}

const assets::BvhOptions in_metres{1.0};

std::string errorOf(const std::string& text) {
    const auto file = parseBvh(text, "f.bvh", in_metres);
    REQUIRE_FALSE(file.has_value());
    return file.error().text();
}

Vec3 worldOf(const assets::BvhFile& file, int frame, const char* joint) {
    const auto& clip = file.clip;
    return motion::worldPose(clip.skeleton, clip.frames.at(static_cast<std::size_t>(frame)))
        .at(static_cast<std::size_t>(clip.skeleton.find(joint)))
        .position;
}

void checkNear(const Vec3& found, const Vec3& expected, double tolerance = 1e-9) {
    INFO("found " << found.x << " " << found.y << " " << found.z);
    CHECK(glm::length(found - expected) < tolerance);
}

}  // namespace

TEST_SUITE("assets/bvh_read") {
    TEST_CASE("Positions of a joint with six channels replace its OFFSET") {
        const auto file = parseBvh(smallFile("6 Xposition Yposition Zposition Xrotation Yrotation Zrotation",
                                             "Frames: 1\nFrame Time: 0.1\n10 0 0 0 0 0 0 7 1 0 0 90\n"),
                                   "f", in_metres);
        REQUIRE(file.has_value());
        checkNear(worldOf(*file, 0, "base"), {10, 0, 0});
        checkNear(worldOf(*file, 0, "arm"), {10, 7, 1});
        checkNear(worldOf(*file, 0, "tip"), {10, 9, 1});  // 2 along x, turned by 90 degrees about z
        checkNear(file->clip.skeleton.joints[1].rest.position, {0, 5, 0});
    }

    TEST_CASE("Positions that are all next to nothing are shifts from OFFSET, and the reader says so") {
        const auto file = parseBvh(smallFile("6 Xposition Yposition Zposition Xrotation Yrotation Zrotation",
                                             "Frames: 1\nFrame Time: 0.1\n10 0 0 0 0 0 0.01 0 0 0 0 0\n"),
                                   "f", in_metres);
        REQUIRE(file.has_value());
        checkNear(worldOf(*file, 0, "arm"), {10.01, 5, 0});
        REQUIRE(file->remarks.size() == 1);
        CHECK(contains(file->remarks[0], "shifts from OFFSET"));
    }

    TEST_CASE("Rotations are applied in the order of the channels") {
        const auto at = [](const char* channels) {
            const auto file = parseBvh(
                smallFile(channels, "Frames: 1\nFrame Time: 0.1\n0 0 0 0 0 0 90 90 0\n"), "f", in_metres);
            REQUIRE(file.has_value());
            return worldOf(*file, 0, "tip");
        };
        // By hand: Rx(90) Rz(90) (2,0,0) = Rx(90) (0,2,0) = (0,0,2); Rz(90) Rx(90) (2,0,0) = (0,2,0).
        checkNear(at("3 Xrotation Zrotation Yrotation"), Vec3(0, 5, 0) + Vec3(0, 0, 2));
        checkNear(at("3 Zrotation Xrotation Yrotation"), Vec3(0, 5, 0) + Vec3(0, 2, 0));
    }

    TEST_CASE("A root whose rotations come first is read by the names of its channels") {
        const auto file = parseBvh(
            "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 6 Zrotation Yrotation Xrotation Zposition Yposition "
            "Xposition }\nMOTION\nFrames: 1\nFrame Time: 0.02\n90 0 0 3 2 1\n",
            "f", in_metres);
        REQUIRE(file.has_value());
        checkNear(file->clip.frames[0].joints[0].position, {1, 2, 3});
        checkNear(file->clip.frames[0].joints[0].orientation * Vec3(1, 0, 0), {0, 1, 0});
    }

    TEST_CASE("CRLF, tabs, a byte order mark, blank lines and unusual numbers are read") {
        std::string text =
            "\xEF\xBB\xBFHIERARCHY\r\nROOT\tmy root \r\n{\r\n\tOFFSET\t0\t+1.5e-1\t-.5\r\n\tCHANNELS 3 "
            "xRotation YROTATION Zrotation\r\n\tEnd Site\r\n\t{\r\n\tOFFSET 0 1 "
            "0\r\n\t}\r\n}\r\nMOTION\r\nFrames:\t2\r\nFrame "
            "Time:\t.0083333\r\n1e1\t0\t-0 \r\n\r\n.5 0 0";
        const auto file = parseBvh(text, "f", in_metres);
        REQUIRE(file.has_value());
        CHECK(file->clip.skeleton.joints[0].name == "my root");
        checkNear(file->clip.skeleton.joints[0].rest.position, {0, 0.15, -0.5});
        CHECK(file->clip.frameCount() == 2);
        CHECK(file->clip.frame_time_s == 0.0083333);
        CHECK(file->clip.skeleton.joints[0].end_site.value() == Vec3(0, 1, 0));
    }

    TEST_CASE("A frame time of thirteen digits keeps them all") {
        const auto file =
            parseBvh(smallFile("0", "Frames: 1\nFrame Time: 0.0333333333333\n0 0 0 0 0 0\n"), "f", in_metres);
        REQUIRE(file.has_value());
        CHECK(file->clip.frame_time_s == 0.0333333333333);
    }

    TEST_CASE("A joint name that stands twice is made unique") {
        const auto file = parseBvh(
            "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xrotation JOINT a { OFFSET 0 1 0 CHANNELS 0 } JOINT "
            "a "
            "{ "
            "OFFSET 0 1 0 CHANNELS 0 } }\nMOTION Frames: 1\nFrame Time: 1\n0\n",
            "f", in_metres);
        REQUIRE_MESSAGE(file.has_value(), (file ? "" : file.error().text()));
        CHECK(file->clip.skeleton.find("a#2") == 1);
        CHECK(file->clip.skeleton.find("a#3") == 2);
    }

    TEST_CASE("Each fault is reported with its line, what was found and what was expected") {
        const std::string three = "3 Zrotation Xrotation Yrotation";
        const std::string head = "Frames: 2\nFrame Time: 0.1\n";
        const std::string line = "0 0 0 0 0 0 0 0 0\n";
        CHECK(contains(errorOf(""), "f.bvh:1: found the end of the file, expected 'HIERARCHY'"));
        CHECK(contains(errorOf(smallFile(three, head + line)),
                       "f.bvh:21: found the end of the file after 1 frames, expected 2"));
        CHECK(contains(errorOf(smallFile(three, head + line + line + line)),
                       "f.bvh:22: found more lines of motion, expected 2"));
        CHECK(contains(errorOf(smallFile(three, head + line + "0 0 0 0 0 0 0 0\n")),
                       "f.bvh:21: found 8 values, expected 9"));
        CHECK(contains(errorOf(smallFile(three, head + line + "0 0 0 0 0 0 0 0 0 0\n")),
                       "f.bvh:21: found 10 values, expected 9"));
        for (const char* bad : {"nan", "inf", "-inf", "1e999", "1,5", "0x10", "--1"})
            CHECK(contains(errorOf(smallFile(three, head + line + "0 0 0 0 0 0 0 0 " + bad + "\n")),
                           std::string("f.bvh:21: found '") + bad + "', expected a finite number"));
        CHECK(contains(errorOf(smallFile("3 Zrotation Wrotation Yrotation", head + line + line)),
                       "f.bvh:9: found channel 'Wrotation', expected"));
        CHECK(contains(errorOf(smallFile("2 Zrotation Zrotation", head + line + line)), "twice"));
        CHECK(contains(errorOf(smallFile("7 Zrotation", head)), "expected 0 to 6"));
        CHECK(contains(errorOf(smallFile(three, "Frames: 0\nFrame Time: 0.1\n")), "f.bvh:18"));
        CHECK(contains(errorOf(smallFile(three, "Frames: 2\nFrame Time: 0\n" + line + line)),
                       "f.bvh:19: found frame time '0', expected seconds from 0.0001 to 1"));
        CHECK(
            contains(errorOf("HIERARCHY\nROOT a\nOFFSET 0 0 0\n"), "f.bvh:3: found 'OFFSET', expected '{'"));
        CHECK(contains(errorOf("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nMOTION\n"),
                       "f.bvh:5: found 'MOTION' in joint 'a', expected"));
        CHECK(contains(errorOf("HIERARCHY\nROOT a\n{\nOFFSET 0 0\n}\n"), "f.bvh:5: found '}'"));
        CHECK(contains(errorOf("HIERARCHY\nROOT a\n{\n CHANNELS 1 Xrotation\n}\nROOT b\n{\n}\n"),
                       "f.bvh:6: found a second ROOT, expected one figure"));
        CHECK(contains(assets::readBvh("no_such_file.bvh").error().text(), "no_such_file.bvh"));
    }

    TEST_CASE("A file cut off anywhere gives an error, never a crash or a clip") {
        const std::string whole = smallFile("3 Zrotation Xrotation Yrotation",
                                            "Frames: 2\nFrame Time: 0.1\n0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0");
        REQUIRE(parseBvh(whole + " 0", "f", in_metres).has_value());
        for (std::size_t length = 0; length <= whole.size(); ++length)
            CHECK_FALSE(parseBvh(whole.substr(0, length), "f", in_metres).has_value());
    }

    TEST_CASE("Noise in the bytes never crashes the reader") {
        const std::string whole =
            smallFile("3 Zrotation Xrotation Yrotation", "Frames: 1\nFrame Time: 0.1\n0 0 0 0 0 0 0 0 0\n");
        Random random(7);
        int rejected = 0;
        for (int i = 0; i < 2000; ++i) {
            std::string text = whole;
            for (int k = 0; k < 3; ++k)
                text[random.below(text.size())] = static_cast<char>(random.below(256));
            rejected += parseBvh(text, "f").has_value() ? 0 : 1;
        }
        CHECK(rejected > 1000);
    }

    TEST_CASE("The walk of bvh-toolbox has the joint positions that its CSV lists") {
        const auto path = tests::sharedData("bvh/bvhtoolbox_walk01");
        DEIXIS_SKIP_WITHOUT(path);
        const auto file = assets::readBvh(path / "walk01.bvh", assets::BvhOptions{1.0});
        REQUIRE(file.has_value());
        const auto& clip = file->clip;
        std::istringstream csv(*readFile(path / "walk01_pos.csv"));
        std::string line;
        std::getline(csv, line);
        std::vector<std::string> columns;
        std::istringstream head(line);
        for (std::string cell; std::getline(head, cell, ',');) columns.push_back(cell);
        double worst = 0.0;
        int compared = 0;
        for (const auto& frame : clip.frames) {
            REQUIRE(std::getline(csv, line));
            const auto world = motion::worldPose(clip.skeleton, frame);
            std::istringstream row(line);
            std::string cell;
            std::getline(row, cell, ',');
            for (std::size_t c = 1; c < columns.size(); ++c) {
                std::getline(row, cell, ',');
                std::string name = columns[c].substr(0, columns[c].size() - 2);
                const bool tip = name.ends_with("_End");
                if (tip) name.resize(name.size() - 4);
                const int joint = clip.skeleton.find(name);
                REQUIRE(joint >= 0);
                const Vec3 p = tip ? motion::tipPosition(clip.skeleton, world, joint)
                                   : world[static_cast<std::size_t>(joint)].position;
                worst = std::max(worst, std::abs(p[columns[c].back() - 'x'] - std::stod(cell)));
                ++compared;
            }
        }
        CHECK(compared == 101 * 72);
        CHECK(worst < 1e-4);
    }
}

TEST_SUITE("assets/bvh_unit") {
    TEST_CASE("Real files are read in the unit that their makers used") {
        struct Case {
            const char* file;
            double metres;
            const char* words;
        };
        const double cgspeed = 0.0254 / 0.45;
        for (const Case& c : {Case{"bvh/bvhpython_test_freebvh.bvh", 0.01, "centimetre"},
                              Case{"bvh/bvhtoolbox_walk01/walk01.bvh", 0.01, "centimetre"},
                              Case{"bvh/cmu_iclone_002_01.bvh", 0.01, "centimetre"},
                              Case{"bvh/optitrack_arena_louise.bvh.gz", 0.01, "centimetre"},
                              Case{"bvh/makehuman_tpose.bvh", 0.1, "decimetre"},
                              Case{"bvh/pybvh_bvh_test1.bvh", 0.0254, "inch"},
                              Case{"bvh/cmu_cgspeed_motionbuilder_02_01.bvh", cgspeed, "1/0.45 inch"},
                              Case{"bvh/dme_example.bvh", cgspeed, "1/0.45 inch"}}) {
            const auto path = tests::sharedData(c.file);
            DEIXIS_SKIP_WITHOUT(path);
            const auto file = assets::readBvh(path);
            REQUIRE_MESSAGE(file.has_value(), (file ? "" : file.error().text()));
            INFO(std::string(c.file));
            CHECK(file->unit.metres == Approx(c.metres));
            CHECK(file->unit.name == std::string(c.words));
            CHECK(file->unit.origin == assets::Origin::detected);
        }
    }

    TEST_CASE("The unit can be given, and then no detection happens") {
        const auto path = tests::sharedData("bvh/bvhtoolbox_walk01/walk01.bvh");
        DEIXIS_SKIP_WITHOUT(path);
        const auto file = assets::readBvh(path, assets::BvhOptions{0.02});
        REQUIRE(file.has_value());
        CHECK(file->clip.skeleton.joints[0].rest.position.y == Approx(103.511 * 0.02));
        CHECK(file->unit.origin == assets::Origin::given);
    }

    TEST_CASE("The avatar scaled to each unit is recognised in it") {
        for (const double unit : {1.0, 0.1, 0.0254 / 0.45, 0.0254, 0.01, 0.001}) {
            motion::Clip clip;
            clip.skeleton = motion::referenceHumanoid();
            for (auto& joint : clip.skeleton.joints) {
                joint.rest.position /= unit;
                if (joint.end_site) *joint.end_site /= unit;
            }
            clip.frames.assign(1, motion::restPose(clip.skeleton));
            const auto file = parseBvh(assets::writeBvh(clip), "f");
            REQUIRE(file.has_value());
            CHECK(file->unit.metres == Approx(unit));
        }
    }
}

TEST_SUITE("assets/bvh_write") {
    TEST_CASE("A clip written and read again has every joint within 10 micrometres") {
        Random random(11);
        motion::Clip clip;
        clip.skeleton = motion::referenceHumanoid();
        clip.frame_time_s = 1.0 / 30.0;
        for (int f = 0; f < 40; ++f) {
            auto pose = motion::restPose(clip.skeleton);
            for (auto& joint : pose.joints) {
                joint.orientation =
                    glm::normalize(Quat(random.normal(), random.normal(), random.normal(), random.normal()));
            }
            pose.joints[0].position += Vec3(random.normal(), random.normal(), random.normal());
            pose.joints[9].position += Vec3(0.01 * random.normal(), 0, 0);  // a joint that slides
            clip.frames.push_back(pose);
        }
        // Turns at the pole of the angles, where two axes fall together.
        std::size_t at_pole = 20;
        for (const double degrees : {90.0, -90.0, 89.9999999})
            clip.frames[0].joints[at_pole++].orientation =
                glm::angleAxis(radiansFromDegrees(30), Vec3(0, 0, 1)) *
                glm::angleAxis(radiansFromDegrees(degrees), Vec3(1, 0, 0)) *
                glm::angleAxis(radiansFromDegrees(20), Vec3(0, 1, 0));
        const auto file = parseBvh(assets::writeBvh(clip), "f");
        REQUIRE_MESSAGE(file.has_value(), (file ? "" : file.error().text()));
        CHECK(file->unit.metres == 1.0);
        CHECK(file->clip.frame_time_s == clip.frame_time_s);
        REQUIRE(file->clip.frameCount() == clip.frameCount());
        double worst = 0.0;
        for (std::size_t f = 0; f < clip.frames.size(); ++f) {
            const auto before = motion::worldPose(clip.skeleton, clip.frames[f]);
            const auto after = motion::worldPose(file->clip.skeleton, file->clip.frames[f]);
            for (int j = 0; j < clip.skeleton.size(); ++j) {
                const int k =
                    file->clip.skeleton.find(clip.skeleton.joints[static_cast<std::size_t>(j)].name);
                REQUIRE(k >= 0);
                worst = std::max(worst, glm::length(motion::tipPosition(clip.skeleton, before, j) -
                                                    motion::tipPosition(file->clip.skeleton, after, k)));
            }
        }
        CHECK(worst < 1e-5);
    }

    TEST_CASE("What was read and written twice is the same text") {
        motion::Clip clip;
        clip.skeleton = motion::referenceHumanoid();
        clip.frames.assign(3, motion::relaxedPose(clip.skeleton));
        const std::string first = assets::writeBvh(clip);
        const auto file = parseBvh(first, "f");
        REQUIRE(file.has_value());
        CHECK(assets::writeBvh(file->clip) == first);
        CHECK(first.find("-0.000000") == std::string::npos);
    }

    TEST_CASE("A small clip is written exactly as documented") {
        motion::Clip clip;
        clip.skeleton.joints.push_back({"a", -1, {{0, 1, 0}, no_rotation}, std::nullopt});
        clip.skeleton.joints.push_back({"b", 0, {{0.5, 0, 0}, no_rotation}, Vec3(0.25, 0, 0)});
        clip.frame_time_s = 0.04;
        clip.frames.assign(1, motion::restPose(clip.skeleton));
        clip.frames[0].joints[1].orientation = glm::angleAxis(pi / 2, Vec3(0, 0, 1));
        CHECK(assets::writeBvh(clip) ==
              "HIERARCHY\nROOT a\n{\n\tOFFSET 0.000000 1.000000 0.000000\n\tCHANNELS 6 Xposition Yposition "
              "Zposition Zrotation Xrotation Yrotation\n\tJOINT b\n\t{\n\t\tOFFSET 0.500000 0.000000 "
              "0.000000\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n\t\tEnd Site\n\t\t{\n\t\t\tOFFSET "
              "0.250000 0.000000 0.000000\n\t\t}\n\t}\n}\nMOTION\nFrames: 1\nFrame Time: 0.04\n0.000000 "
              "1.000000 0.000000 0.000000 0.000000 0.000000 90.000000 0.000000 0.000000\n");
    }

    TEST_CASE("A skeleton with two roots cannot be written") {
        motion::Clip clip;
        clip.skeleton.joints.push_back({"a", -1, {}, std::nullopt});
        clip.skeleton.joints.push_back({"b", -1, {}, std::nullopt});
        clip.frames.assign(1, motion::restPose(clip.skeleton));
        CHECK_THROWS_AS((void)assets::writeBvh(clip), std::invalid_argument);
    }
}
