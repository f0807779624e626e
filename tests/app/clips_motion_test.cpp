#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "core/pose.hpp"
#include "program.hpp"

using namespace deixis::tests;

namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
    return out;
}

void makeClips(const Scratch& scratch, const std::string& system) {
    spill(scratch / "targets.csv", "target_id,x,y,z\nT001,-1.2,1.3,1.6\nT002,0.9,0.6,1.8\n");
    const auto made = program("generate " + system + " --targets " + (scratch / "targets.csv") + " --out " +
                              (scratch / system));
    INFO(made.err);
    REQUIRE(made.status == 0);
}

/// A figure in the T pose, all bones along the axes; its left forearm, 0.25 m along x, is turned by 90
/// degrees about z in the frames named.
std::string figureBvh(const std::set<int>& turned, int frames = 30) {
    std::string out =
        "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition "
        "Zrotation Xrotation Yrotation\n";
    int joints = 0;
    const auto joint = [&](const std::string& name, const std::string& offset, const std::string& below) {
        ++joints;
        return "JOINT " + name + "\n{\nOFFSET " + offset + "\nCHANNELS 3 Zrotation Xrotation Yrotation\n" +
               (below.empty() ? "End Site\n{\nOFFSET 0 0.1 0\n}\n" : below) + "}\n";
    };
    const std::string left_hand = joint("LeftHand", "0.25 0 0", "");
    const std::string left = joint("LeftArm", "0.2 0 0", joint("LeftForeArm", "0.3 0 0", left_hand));
    const std::string right =
        joint("RightArm", "-0.2 0 0", joint("RightForeArm", "-0.3 0 0", joint("RightHand", "-0.25 0 0", "")));
    const std::string neck = joint("Neck", "0 0.1 0", joint("Head", "0 0.1 0", ""));
    out += joint("Spine", "0 0.4 0", neck + left + right);
    for (const std::string side : {"Left", "Right"})
        out += joint(side + "UpLeg", (side == "Left" ? "0.1" : "-0.1") + std::string(" 0 0"),
                     joint(side + "Leg", "0 -0.45 0", joint(side + "Foot", "0 -0.45 0", "")));
    out += "}\nMOTION\nFrames: " + std::to_string(frames) + "\nFrame Time: 0.0666667\n";
    // Channels stand as the joints do in the text: spine, neck, head, left arm, left forearm, ...
    for (int f = 0; f < frames; ++f) {
        out += "0 1 0 0 0 0";
        for (int j = 0; j < joints; ++j) out += j == 4 && turned.contains(f) ? " 90 0 0" : " 0 0 0";
        out += "\n";
    }
    return out;
}

}  // namespace

TEST_SUITE("app/clips-motion") {
    TEST_CASE("Pose compliance of a made clip with poses asked for is what the figure's bones say") {
        const Scratch scratch;
        spill(scratch / "asked.bvh", figureBvh({}));
        // The hand leaves its place by 0.25 m along x and 0.25 m along y, in three of the five frames asked
        // for: eq. 8 over 9 joints, 3 coordinates and 5 frames.
        spill(scratch / "made.bvh", figureBvh({9, 11, 12, 14, 15}));
        const double expected = 3 * 0.5 / (9 * 3 * 5);
        const std::string command = "clips statistics " + (scratch / "made.bvh") + " " +
                                    (scratch / "asked.bvh") + " --asked " + (scratch / "asked.bvh");
        const auto done = program(command + " --json");
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const auto json = nlohmann::json::parse(done.out);
        const auto& found = json["pose_compliance"];
        CHECK(found["frames"] == std::vector<int>{10, 14});
        CHECK(found["joints"] == 9);
        REQUIRE(found["clips"].size() == 2);
        CHECK(found["clips"][0]["compliance_m"].get<double>() == doctest::Approx(expected).epsilon(1e-5));
        CHECK(std::abs(found["clips"][1]["compliance_m"].get<double>()) < 1e-9);
        CHECK(found["mean_m"].get<double>() == doctest::Approx(expected / 2).epsilon(1e-5));
        CHECK(found["sd_m"].get<double>() == doctest::Approx(expected / 2).epsilon(1e-5));
        CHECK(json["clips"] == 2);
        CHECK(json["style"]["handedness"]["mean"].is_number());
        CHECK(program(command).out.find("pose compliance, frames 10 to 14, 9 joints") != std::string::npos);
        const auto one = nlohmann::json::parse(program(command + " --json --asked-frames 11,12").out);
        CHECK(one["pose_compliance"]["clips"][0]["compliance_m"].get<double>() ==
              doctest::Approx(2 * 0.5 / (9 * 3 * 2)).epsilon(1e-5));

        CHECK_FAILS_SAYING(program(command + " --asked-frames 14,10"), "--asked-frames", "14 to 10");
        CHECK_FAILS_SAYING(program(command + " --asked-frames 25,30"), "made.bvh", "found 30 frames");
        CHECK_FAILS_SAYING(program("clips statistics " + (scratch / "made.bvh") + " --asked " +
                                   (scratch / "asked.bvh") + " " + (scratch / "made.bvh")),
                           "--asked", "found poses of 2 clips, expected 1");
        CHECK(program("clips statistics " + (scratch / "made.bvh") + " --asked-frames 1,2").status == 2);
    }

    TEST_CASE("a manifest's clips are measured, as CSV and as JSON, with its phases or with those found") {
        const Scratch scratch;
        makeClips(scratch, "direct");
        const std::string manifest = scratch / "direct/manifest.csv";
        const auto csv = program("clips measure --csv " + manifest);
        INFO(csv.err);
        REQUIRE(csv.status == 0);
        std::istringstream lines(csv.out);
        std::string header, line;
        std::getline(lines, header);
        const auto names = split(header);
        int rows = 0;
        for (; std::getline(lines, line); ++rows) {
            auto cells = split(line);
            cells.resize(names.size());  // the last cells may be empty
            std::map<std::string, std::string> row;
            for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells[i];
            CHECK(row["system"] == "direct");
            CHECK(row["hand"] == (rows == 0 ? "right" : "left"));
            CHECK(std::stod(row["eye-fingertip_error_deg"]) < 1.0);
            CHECK(std::stod(row["forearm_error_deg"]) > 15.0);
            CHECK(row["intersection_cm"] == "0");
            CHECK(row["clear_hold"].empty());  // the phases are the manifest's
        }
        CHECK(rows == 2);

        const auto given = nlohmann::json::parse(program("clips measure --json " + manifest).out);
        const auto found = nlohmann::json::parse(program("clips measure --detect --json " + manifest).out);
        REQUIRE(given.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(found[i]["clear_hold"] == true);
            CHECK(given[i]["clear_hold"].is_null());
            for (const char* phase : {"onset_frame", "peak_frame", "hold_frame", "end_frame"})
                CHECK(std::abs(given[i][phase].get<int>() - found[i][phase].get<int>()) <= 2);
        }
    }

    TEST_CASE("a single file is measured against a target that is given, or without one") {
        const Scratch scratch;
        makeClips(scratch, "stiff");
        const std::string clip = scratch / "stiff/stiff_T001.bvh";
        const auto aimed = program("clips measure " + clip + " --target -1.2,1.3,1.6 --json");
        INFO(aimed.err);
        REQUIRE(aimed.status == 0);
        CHECK(nlohmann::json::parse(aimed.out)[0]["eye-fingertip_error_deg"].get<double>() < 1.0);
        const auto plain = program("clips measure " + clip);
        CHECK(plain.status == 0);
        CHECK(plain.out.find("peak_speed_m_s") != std::string::npos);
        CHECK(plain.out.find("error_deg") == std::string::npos);
    }

    TEST_CASE("a clip that cannot be measured is named; the others are measured") {
        const Scratch scratch;
        makeClips(scratch, "stiff");
        spill(scratch / "broken.bvh", "HIERARCHY\nROOT hips\n");
        const std::string good = scratch / "stiff/stiff_T001.bvh";
        const auto both = program("clips measure --csv " + good + " " + (scratch / "broken.bvh"));
        CHECK(both.status == 1);
        CHECK(both.err.find("broken.bvh") != std::string::npos);
        CHECK(both.err.find("1 of 2 clips") != std::string::npos);
        CHECK(std::count(both.out.begin(), both.out.end(), '\n') == 2);
        CHECK(program("clips measure " + (scratch / "none.bvh")).err.find("none.bvh") != std::string::npos);
        CHECK(program("clips measure " + good + " --target 1,2").status == 2);
    }

    TEST_CASE("with a list of balls, each ray's ball and margin are those that the angles give") {
        const Scratch scratch;
        // The left hand is at (0.75, 1.4, 0), its forearm along x: the target lies 10 degrees above that way,
        // d1 4 degrees before it, d2 behind the hand.
        spill(scratch / "pose.bvh", figureBvh({}));
        const double rise = 2.0 * std::tan(10.0 * deixis::pi / 180.0);
        const double ahead = 2.0 * std::tan(4.0 * deixis::pi / 180.0);
        const std::string target = "2.75," + std::to_string(1.4 + rise) + ",0";
        const std::string row = "T1," + target + ",2.75,1.4," + std::to_string(ahead) + ",-3,1.4,0\n";
        spill(scratch / "balls.csv", "target_id,x,y,z,d1_x,d1_y,d1_z,d2_x,d2_y,d2_z\n" + row);
        const std::string manifest =
            "clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,fps,seed\npose.bvh,"
            "mine,T1," +
            target + ",left,2,6,10,14,15,0\n";
        spill(scratch / "manifest.csv", manifest);
        const std::string command = "clips measure " + (scratch / "manifest.csv") + " --balls ";
        const auto done = program(command + (scratch / "balls.csv") + " --json");
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const auto clip = nlohmann::json::parse(done.out)[0];
        CHECK(clip["forearm_error_deg"].get<double>() == doctest::Approx(10.0).epsilon(1e-4));
        CHECK(clip["forearm_ball"] == "d1");
        CHECK(clip["forearm_margin_deg"].get<double>() == doctest::Approx(6.0).epsilon(1e-4));
        for (const char* ray : {"eye-fingertip", "index-finger", "shoulder-hand", "shoulder-fingertip",
                                "elbow-fingertip", "head"})
            CHECK(clip[std::string(ray) + "_ball"].is_string());

        // Two distances are two sets, and the file's only line serves a clip that names no target.
        spill(scratch / "bands.csv",
              "target_id,x,y,z,near_d1_x,near_d1_y,near_d1_z,far_d1_x,far_d1_y,far_d1_z\n" + row);
        const auto bands =
            program("clips measure " + (scratch / "pose.bvh") + " --balls " + (scratch / "bands.csv"));
        CHECK(bands.err.find("no gesture") != std::string::npos);  // a list does not stand for phases
        const auto both =
            nlohmann::json::parse(program(command + (scratch / "bands.csv") + " --json").out)[0];
        CHECK(both["forearm_near_ball"] == "d1");
        CHECK(both["forearm_far_ball"] == "target");
        CHECK(both["forearm_far_margin_deg"].get<double>() == doctest::Approx(170.0).epsilon(1e-4));
        CHECK_FALSE(both.contains("forearm_ball"));

        spill(scratch / "others.csv", "target_id,x,y,z,d1_x,d1_y,d1_z\nT2,1,1,1,2,2,2\n");
        CHECK_FAILS_SAYING(program(command + (scratch / "others.csv")), "pose.bvh", "points at T1",
                           "others.csv");
        spill(scratch / "moved.csv", "target_id,x,y,z,d1_x,d1_y,d1_z\nT1,2.75,1.4,0,2,2,2\n");
        CHECK_FAILS_SAYING(program(command + (scratch / "moved.csv")), "its target is at 2.7500, 1.7527");
        CHECK_FAILS_SAYING(program(command + (scratch / "none.csv")), "none.csv");
    }

    TEST_CASE(
        "the balls of a study's targets are read as they are printed, and the target is mostly chosen") {
        const Scratch scratch;
        const auto targets = program("targets pointing2023 --no-picture");
        REQUIRE_MESSAGE(targets.status == 0, targets.err);
        std::istringstream lines(targets.out);
        std::string header, first;
        std::getline(lines, header);
        std::getline(lines, first);
        spill(scratch / "balls.csv", header + "\n" + first + "\n");
        const auto made = program("generate direct --targets " + (scratch / "balls.csv") + " --out " +
                                  (scratch / "direct"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const auto done = program("clips measure " + (scratch / "direct/manifest.csv") + " --balls " +
                                  (scratch / "balls.csv") + " --json");
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const auto clip = nlohmann::json::parse(done.out)[0];
        int choices = 0;
        for (const auto& [name, value] : clip.items())
            if (name.starts_with("eye-fingertip_") && name.ends_with("_ball")) {
                ++choices;
                CHECK(value == "target");  // this system points to within a degree by that ray
                const auto margin = clip[name.substr(0, name.size() - 4) + "margin_deg"];
                CHECK(margin.get<double>() > 0.0);
            }
        CHECK(choices > 0);
    }

    TEST_CASE("statistics of a set of clips, and its distance to itself and to another") {
        const Scratch scratch;
        makeClips(scratch, "direct");
        makeClips(scratch, "stiff");
        const std::string direct = scratch / "direct/manifest.csv";
        const auto same = program("clips statistics " + direct + " --against " + direct);
        INFO(same.err);
        REQUIRE(same.status == 0);
        CHECK(same.out.find("2 clips at 30 frames per second, 8 joints") != std::string::npos);
        const auto distance = [](const std::string& out) {
            const auto table = out.find("Hellinger");
            REQUIRE(table != std::string::npos);
            std::istringstream from(out.substr(out.find("\nspeed ", table) + 7));
            double pooled = -1.0, mean = -1.0;
            from >> pooled >> mean;
            return std::vector<double>{pooled, mean};
        };
        CHECK(distance(same.out) == std::vector<double>{0.0, 0.0});
        const auto other =
            program("clips statistics " + direct + " --against " + (scratch / "stiff/manifest.csv"));
        REQUIRE(other.status == 0);
        CHECK(distance(other.out)[0] > 0.2);
        CHECK(distance(other.out)[1] <= 1.0);
        CHECK(other.out.find("handedness") != std::string::npos);
    }
}
