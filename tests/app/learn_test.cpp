// deixis learn project: demonstrations as a simulated body can move.
#include <cmath>
#include <glm/geometric.hpp>

#include "app/clips/clip_files.hpp"
#include "assets/tables/manifest.hpp"
#include "physics/body/body.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Two demonstrations, one of either hand.
std::string generated(const Scratch& scratch) {
    spill(scratch / "targets.csv", "target_id,x,y,z\nA,0.8,1.2,1.7\nB,-0.6,0.5,1.9\n");
    const std::string folder = scratch / "clips";
    REQUIRE(program("generate demonstration-nn --targets " + (scratch / "targets.csv") + " -o " + folder)
                .status == 0);
    return folder;
}

assets::Manifest manifestAt(const std::string& file) {
    auto manifest = assets::readManifest(file);
    REQUIRE_MESSAGE(manifest.has_value(), (manifest ? "" : manifest.error().text()));
    return *manifest;
}

bool withoutMujoco() {
    if (!physics::mujocoLibraryName().empty()) return false;
    tellSkipped("the program was built without MuJoCo");
    return true;
}

std::string project(const std::string& manifest, const std::string& folder, const std::string& more = "") {
    return "learn project " + manifest + " -o " + folder + " " + more;
}

}  // namespace

TEST_SUITE("app/learn") {
    TEST_CASE(
        "a manifest's clips are projected to another folder, with a manifest of the same rows that says so") {
        if (withoutMujoco()) return;
        const Scratch scratch;
        const std::string folder = generated(scratch), made = scratch / "projected";
        const auto done = program(project(folder + "/manifest.csv", made));
        REQUIRE_MESSAGE(done.status == 0, done.err);
        CHECK(contains(done.out, "2 clips physics-projected"));
        CHECK(contains(done.out, "demonstration-nn_A.bvh"));
        CHECK(contains(done.out, "\nall "));

        const auto before = manifestAt(folder + "/manifest.csv"), after = manifestAt(made + "/manifest.csv");
        REQUIRE(after.rows.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            assets::ManifestRow row = after.rows[i];
            CHECK(row.processing == "physics-projected");
            row.processing.clear();
            CHECK(assets::manifestCsv({row}) == assets::manifestCsv({before.rows[i]}));

            const auto given = app::readMappedClip(folder + "/" + row.clip);
            const auto seen = app::readMappedClip(made + "/" + row.clip);
            REQUIRE(given.has_value());
            REQUIRE(seen.has_value());
            REQUIRE(seen->clip.frameCount() == given->clip.frameCount());
            CHECK(seen->clip.frame_time_s == given->clip.frame_time_s);
            double farthest_m = 0.0;
            for (int f = 0; f < given->clip.frameCount(); ++f) {
                const auto frame = static_cast<std::size_t>(f);
                const auto a = motion::worldPose(given->clip.skeleton, given->clip.frames[frame]);
                const auto b = motion::worldPose(seen->clip.skeleton, seen->clip.frames[frame]);
                for (const motion::Bone bone : {motion::Bone::leftHand, motion::Bone::rightHand})
                    farthest_m = std::max(
                        farthest_m, glm::distance(a[static_cast<std::size_t>(given->map[bone])].position,
                                                  b[static_cast<std::size_t>(seen->map[bone])].position));
            }
            CHECK(farthest_m > 0.001);
            CHECK(farthest_m < 0.05);
        }
        // What it makes, other commands read.
        CHECK(program("clips mirror " + made + "/manifest.csv -o " + (scratch / "mirrored")).status == 0);
        CHECK(contains(slurp(scratch / "mirrored/manifest.csv"), "physics-projected"));
    }

    TEST_CASE("the same command gives the same bytes, and noise is of a seed") {
        if (withoutMujoco()) return;
        const Scratch scratch;
        const std::string manifest = generated(scratch) + "/manifest.csv";
        const auto run = [&](const char* name, const std::string& more) {
            const auto done = program(project(manifest, scratch / name, more));
            REQUIRE_MESSAGE(done.status == 0, done.err);
            return slurp(scratch / (std::string(name) + "/demonstration-nn_A.bvh"));
        };
        const std::string plain = run("a", "");
        CHECK(run("b", "") == plain);
        const std::string noisy = run("c", "--noise 0.02 --seed 3");
        CHECK(noisy != plain);
        CHECK(run("d", "--noise 0.02 --seed 3") == noisy);
        CHECK(run("e", "--noise 0.02 --seed 4") != noisy);
        CHECK(run("f", "--full-body") != plain);

        const auto again = program(project(manifest, scratch / "a"));
        CHECK_FAILS_SAYING(again, "is there already", "--force");
        CHECK(program(project(manifest, scratch / "a", "--force --noise 0.02 --seed 3")).status == 0);
        CHECK(slurp(scratch / "a/demonstration-nn_A.bvh") == noisy);
    }

    TEST_CASE("without MuJoCo one message says what to do, and everything else works") {
        const Scratch scratch;
        const std::string manifest = generated(scratch) + "/manifest.csv";
        const std::string command = project(manifest, scratch / "projected");
        const auto absent = program(command, "DEIXIS_MUJOCO=libmujoco-of-another-day.so");
        if (physics::mujocoLibraryName().empty())
            CHECK_FAILS_SAYING(absent, "built without MuJoCo", "libmujoco-dev");
        else
            CHECK_FAILS_SAYING(absent, "libmujoco-of-another-day.so", "apt-get install libmujoco",
                               "DEIXIS_MUJOCO");
        CHECK(absent.out.empty());
        CHECK_FALSE(fs::exists(scratch / "projected"));
        CHECK(program("clips info " + (scratch / "clips/demonstration-nn_A.bvh"),
                      "DEIXIS_MUJOCO=libmujoco-of-another-day.so")
                  .status == 0);
    }

    TEST_CASE("manifests without targets, broken clips and avatars without a body are rejected by name") {
        if (withoutMujoco()) return;
        const Scratch scratch;
        const std::string folder = generated(scratch), manifest = folder + "/manifest.csv";
        const std::string text = slurp(manifest);
        const std::string head = text.substr(0, text.find('\n') + 1);
        const std::string out = scratch / "projected";

        spill(folder + "/none.csv", head);
        CHECK_FAILS_SAYING(program(project(folder + "/none.csv", out)), "none.csv", "lists no clips");
        spill(folder + "/free.csv", head + "demonstration-nn_A.bvh,lab,A,,,,,,,,,30,1\n");
        CHECK_FAILS_SAYING(program(project(folder + "/free.csv", out)), "free.csv:2: target_x",
                           "has no target");
        spill(folder + "/long.csv",
              head + "demonstration-nn_A.bvh,lab,A,0.8,1.2,1.7,left,9,33,60,9000,30,1\n");
        CHECK_FAILS_SAYING(program(project(folder + "/long.csv", out)), "demonstration-nn_A.bvh", "end 9000");
        CHECK_FAILS_SAYING(program(project(manifest, folder)), "folder of the clips themselves");

        const std::string clip = folder + "/demonstration-nn_B.bvh";
        const std::string bvh = slurp(clip);
        const auto last = bvh.find_last_of(' ');
        spill(clip, bvh.substr(0, last) + " nan\n");
        CHECK_FAILS_SAYING(program(project(manifest, out)), "demonstration-nn_B.bvh:", "nan");
        // A figure without legs.
        spill(
            clip,
            "HIERARCHY\nROOT hips\n{\nOFFSET 0 0.9 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT "
            "head\n{\n"
            "OFFSET 0 0.6 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 0.2 0\n}\n}\n}\n"
            "MOTION\nFrames: 2\nFrame Time: 0.0333333\n0 0 0 0 0 0\n0 0 0 0 0 0\n");
        CHECK_FAILS_SAYING(program(project(manifest, out)), "demonstration-nn_B.bvh", "no joint was found");
        CHECK_FALSE(fs::exists(out));
        CHECK(program("learn project").status == 2);
        CHECK(program("learn").status == 2);
        CHECK(program(project(manifest, out, "--noise 2")).status == 2);
    }
}
