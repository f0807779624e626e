#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"
#include "shared_data.hpp"

using namespace deixis::tests;

namespace {

/// A generated clip of the avatar, as BVH.
std::string pointingClip(const Scratch& scratch) {
    spill(scratch / "targets.csv", "target_id,x,y,z\nA,0.8,1.3,1.9\n");
    const auto made =
        program("generate direct --targets " + (scratch / "targets.csv") + " --out " + (scratch / "clips"));
    REQUIRE_MESSAGE(made.status == 0, made.err);
    for (const auto& entry : fs::directory_iterator(scratch / "clips"))
        if (entry.path().extension() == ".bvh") return entry.path().string();
    FAIL("no clip was made");
    return {};
}

bool says(const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("app/clips") {
    TEST_CASE("clips info tells format, rate, unit, up axis and bones, for people and as JSON") {
        const Scratch scratch;
        const std::string clip = pointingClip(scratch);
        const auto text = program("clips info " + clip);
        CHECK(text.status == 0);
        for (const char* part : {"format   BVH", "30 fps (declared)", "metre (detected)", "y (detected)",
                                 "bones    55 of 55", "rightIndexDistal"})
            CHECK(says(text.out, part));
        const auto json = program("clips info --json --fps 24 --up=-y --unit cm " + clip);
        REQUIRE(json.status == 0);
        const auto info = nlohmann::json::parse(json.out);
        CHECK(info["format"] == "BVH");
        CHECK(info["frame_rate"]["fps"] == 24.0);
        CHECK(info["frame_rate"]["origin"] == "given");
        CHECK(info["up"]["axis"] == "-y");
        CHECK(info["unit"]["metres"] == 0.01);
        CHECK(info["humanoid"]["bones"]["leftHand"] == "leftHand");
        CHECK(info["humanoid"]["missing"].empty());
        CHECK(info["height_m"].get<double>() == doctest::Approx(0.0162).epsilon(0.05));
        for (const std::string wrong : {"parsec", "5e-324", "1e9", "0"})
            CHECK(program("clips info --unit " + wrong + " " + clip).status == 2);
        CHECK(program("clips info --up w " + clip).status == 2);
    }

    TEST_CASE("clips info and clips check go by the file beside the clip, as clips map does") {
        const Scratch scratch;
        const std::string clip = pointingClip(scratch);
        const std::string beside = fs::path(clip).replace_extension(".humanoid.toml").string();
        spill(beside, "jaw = \"\"\nleftEye = \"jaw\"\n");
        const auto info = nlohmann::json::parse(program("clips info --json " + clip).out);
        CHECK(info["humanoid"]["origin"] == "given");
        CHECK(info["humanoid"]["bones"]["leftEye"] == "jaw");
        CHECK_FALSE(info["humanoid"]["bones"].contains("jaw"));
        CHECK(says(program("clips info " + clip).out, "54 of 55 (as the file beside it says)"));
        CHECK(program("clips check " + clip).status == 0);

        spill(beside, "leftHand = \"\"\n");
        const auto handless = program("clips check " + clip);
        CHECK(handless.status == 1);
        CHECK(says(handless.out, "has no joint for leftHand. If it has one by another name, say so in " +
                                     fs::path(beside).filename().string() +
                                     " beside it, with a line such as leftHand = \"NAME OF THE JOINT\""));
        // The line that it asks for is the mend.
        spill(beside, "leftHand = \"leftHand\"\n");
        CHECK(program("clips check " + clip).status == 0);
        spill(beside, "leftHand = \"\"\n");
        CHECK(nlohmann::json::parse(program("clips info --json " + clip).out)["humanoid"]["missing"] ==
              nlohmann::json({"leftHand"}));

        spill(beside, "leftHnad = \"leftHand\"\n");
        CHECK(says(program("clips check " + clip).out, "leftHnad: unknown bone"));
        CHECK_FAILS_SAYING(program("clips info " + clip), "humanoid.toml:1", "leftHnad");
    }

    TEST_CASE("clips convert writes BVH and CSV that read back, whole, and overwrites only when told") {
        const Scratch scratch;
        const std::string clip = pointingClip(scratch);
        const auto csv = program("clips convert " + clip + " " + (scratch / "joints.csv"));
        CHECK_MESSAGE(csv.status == 0, csv.err);
        CHECK(slurp(scratch / "joints.csv") == program("clips joints --csv " + clip).out);
        const auto back = program("clips convert " + (scratch / "joints.csv") + " " + (scratch / "back.bvh"));
        CHECK_MESSAGE(back.status == 0, back.err);
        CHECK(says(back.out, "CSV of joint positions"));
        CHECK(program("clips check " + (scratch / "back.bvh")).status == 0);
        CHECK_FAILS_SAYING(program("clips convert " + clip + " " + (scratch / "back.bvh")), "back.bvh",
                           "is there already", "--force");
        CHECK(program("clips convert --force " + clip + " " + (scratch / "back.bvh")).status == 0);
        CHECK(slurp(scratch / "back.bvh") == slurp(clip));
        CHECK_FAILS_SAYING(program("clips convert " + clip + " " + (scratch / "clip.fbx")), "'.fbx'",
                           ".bvh, .glb or .csv");
        CHECK_FAILS_SAYING(program("clips convert " + (scratch / "none.bvh") + " " + (scratch / "new.bvh")),
                           "none.bvh");
        for (const auto& entry : fs::directory_iterator(scratch.path())) {
            const std::string name = entry.path().filename().string();
            CHECK_MESSAGE(name.find("partial") == std::string::npos, name);
            CHECK(name != "new.bvh");
        }
    }

    TEST_CASE("clips check names every problem of every file and fails where one cannot be used") {
        const Scratch scratch;
        const std::string clip = pointingClip(scratch);
        const auto good = program("clips check " + clip);
        CHECK_MESSAGE(good.status == 0, good.out);
        CHECK(says(good.out, "no problem found"));

        const std::string bvh = slurp(clip);
        spill(scratch / "cut.bvh", bvh.substr(0, bvh.size() / 2));
        spill(scratch / "stick.bvh",
              "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\n"
              "OFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0\n");
        // One frame far away, below the floor.
        std::string jump = bvh;
        const auto line = jump.find('\n', jump.find("Frame Time:")) + 1;
        const auto next = jump.find('\n', line) + 1;
        jump.replace(next, jump.find(' ', jump.find(' ', next) + 1) - next, "0.000000 -3.000000");
        spill(scratch / "jump.bvh", jump);
        const auto bad = program("clips check " + (scratch / "cut.bvh") + " " + (scratch / "stick.bvh") +
                                 " " + (scratch / "jump.bvh") + " " + clip);
        CHECK_FAILS_SAYING(bad, "2 of 4 files cannot be used");
        CHECK(says(bad.out, "cut.bvh:"));
        CHECK(says(bad.out, "stick.bvh: has no joint for hips, head"));
        CHECK(says(bad.out, "doubt: " + (scratch / "jump.bvh") + ": hips jumps by"));
        CHECK(says(bad.out, "below the floor"));
        CHECK(says(bad.out, clip + ": no problem found"));
    }

    TEST_CASE("Every format of recorded people is told, checked and played") {
        struct Case {
            const char* file;
            const char* format;
        };
        for (const Case& c :
             {Case{"pointing/labanotation_kinect/Ges05_demopoint.csv", "Kinect v2 joint positions"},
              Case{"bvh/bvhtoolbox_walk01/walk01_pos.csv", "CSV of joint positions"},
              Case{"bvh/pybvh_bvh_test1.bvh", "BVH"}}) {
            const auto path = sharedData(c.file);
            DEIXIS_SKIP_WITHOUT(path);
            INFO(std::string(c.file));
            const auto info = program("clips info " + path.string());
            CHECK(info.status == 0);
            CHECK(says(info.out, c.format));
            const auto checked = program("clips check " + path.string());
            CHECK_MESSAGE(checked.status == 0, checked.out);
        }
    }
}
