// clips mirror, trim, resample and segment: the real program.
#include <cmath>
#include <sstream>

#include "assets/joints/bvh.hpp"
#include "assets/tables/manifest.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis::tests;
using deixis::tests::contains;
namespace assets = deixis::assets;

namespace {

const std::string targets = "target_id,x,y,z\nA,1.2,1.3,1.6\nB,-0.9,0.8,1.8\nC,-1.5,1.6,1.3\n";

/// Three clips of `direct` with their manifest.
std::string generated(const Scratch& scratch) {
    spill(scratch / "targets.csv", targets);
    const std::string folder = scratch / "clips";
    const auto made = program("generate direct --targets " + (scratch / "targets.csv") + " --out " + folder);
    REQUIRE_MESSAGE(made.status == 0, made.err);
    return folder;
}

struct BvhText {
    std::string head;  ///< up to and with "MOTION"
    std::vector<std::string> frames;
};

BvhText parts(const std::string& text) {
    BvhText out;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line) && line != "MOTION") out.head += line + "\n";
    std::getline(lines, line);
    std::getline(lines, line);
    while (std::getline(lines, line)) out.frames.push_back(line);
    return out;
}

/// The clips one after the other, at 30 fps, each followed by half a second of rest.
std::string recorded(const std::string& folder) {
    BvhText all;
    for (const char* id : {"A", "B", "C"}) {
        const BvhText clip = parts(slurp(folder + "/direct_" + id + ".bvh"));
        all.head = clip.head;
        all.frames.insert(all.frames.end(), clip.frames.begin(), clip.frames.end());
        all.frames.insert(all.frames.end(), 15, clip.frames.back());
    }
    std::string text = all.head + "MOTION\nFrames: " + std::to_string(all.frames.size()) +
                       "\nFrame Time: 0.03333333333333333\n";
    for (const std::string& frame : all.frames) text += frame + "\n";
    return text;
}

assets::Manifest manifestAt(const std::string& file) {
    auto manifest = assets::readManifest(file);
    REQUIRE_MESSAGE(manifest.has_value(), (manifest ? "" : manifest.error().text()));
    return *manifest;
}

std::size_t filesIn(const fs::path& folder) {
    if (!fs::exists(folder)) return 0;
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator()));
}

}  // namespace

TEST_SUITE("app/clips_edit") {
    TEST_CASE("a clip mirrored twice is the same file, and nothing is replaced unasked") {
        const Scratch scratch;
        const std::string clip = generated(scratch) + "/direct_A.bvh";
        CHECK(program("clips mirror " + clip + " " + (scratch / "m.bvh")).status == 0);
        CHECK(program("clips mirror " + (scratch / "m.bvh") + " " + (scratch / "mm.bvh")).status == 0);
        CHECK(slurp(scratch / "mm.bvh") == slurp(clip));
        CHECK(slurp(scratch / "m.bvh") != slurp(clip));

        const auto again = program("clips mirror " + clip + " " + (scratch / "mm.bvh"));
        CHECK_FAILS_SAYING(again, "mm.bvh", "is there already", "--force");
        CHECK(program("clips mirror --force " + clip + " " + (scratch / "mm.bvh")).status == 0);
        CHECK(slurp(scratch / "mm.bvh") == slurp(scratch / "m.bvh"));
        CHECK_FAILS_SAYING(program("clips mirror " + clip + " " + (scratch / "m.fbx")), "m.fbx", ".bvh");
        CHECK(program("clips mirror " + clip).status == 2);
    }

    TEST_CASE("a manifest mirrored has new ids, the other hands and the mirrored targets") {
        const Scratch scratch;
        const std::string folder = generated(scratch);
        const std::string image = scratch / "image";
        const auto made = program("clips mirror " + folder + "/manifest.csv --out " + image);
        REQUIRE_MESSAGE(made.status == 0, made.err);
        CHECK(contains(made.out, "3 rows mirrored"));
        const auto before = manifestAt(folder + "/manifest.csv");
        const auto after = manifestAt(image + "/manifest.csv");
        REQUIRE(after.rows.size() == 3);
        CHECK(filesIn(image) == 4);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& row = before.rows[i];
            const auto& seen = after.rows[i];
            CHECK(seen.target_id == row.target_id + "-mirrored");
            CHECK(seen.clip == "direct_" + row.target_id + "-mirrored.bvh");
            CHECK(seen.system == row.system);
            CHECK(*seen.target == deixis::Vec3(-row.target->x, row.target->y, row.target->z));
            CHECK(seen.phases->hand != row.phases->hand);
            CHECK(seen.phases->peak_frame == row.phases->peak_frame);
            CHECK(fs::exists(fs::path(image) / seen.clip));
        }
        const std::string twice = scratch / "twice";
        REQUIRE(program("clips mirror " + image + "/manifest.csv --out " + twice).status == 0);
        CHECK(slurp(twice + "/manifest.csv") == slurp(folder + "/manifest.csv"));
        for (const char* name : {"/direct_A.bvh", "/direct_B.bvh", "/direct_C.bvh"})
            CHECK(slurp(twice + name) == slurp(folder + name));

        const auto again = program("clips mirror " + folder + "/manifest.csv --out " + image);
        CHECK_FAILS_SAYING(again, "is there already", "--force");
        CHECK(program("clips mirror --force " + folder + "/manifest.csv --out " + image).status == 0);
        CHECK_FAILS_SAYING(program("clips mirror " + folder + "/manifest.csv --out " + folder),
                           "folder of the manifest itself");
    }

    TEST_CASE("a manifest that fails half-way leaves nothing behind") {
        const Scratch scratch;
        const std::string folder = generated(scratch);
        spill(folder + "/direct_C.bvh", "HIERARCHY\nROOT");
        const std::string image = scratch / "image";
        CHECK_FAILS_SAYING(program("clips mirror " + folder + "/manifest.csv --out " + image),
                           "direct_C.bvh");
        CHECK_FALSE(fs::exists(image));
        spill(image + "/mine.txt", "kept");
        CHECK(program("clips mirror " + folder + "/manifest.csv --out " + image).status == 1);
        CHECK(filesIn(image) == 1);
        CHECK(slurp(image + "/mine.txt") == "kept");
    }

    TEST_CASE("a clip is trimmed by frames or by seconds") {
        const Scratch scratch;
        const std::string clip = generated(scratch) + "/direct_A.bvh";
        const BvhText whole = parts(slurp(clip));
        REQUIRE(program("clips trim " + clip + " " + (scratch / "t.bvh") + " --from 10 --to 20").status == 0);
        const BvhText trimmed = parts(slurp(scratch / "t.bvh"));
        CHECK(trimmed.frames == std::vector(whole.frames.begin() + 10, whole.frames.begin() + 21));
        REQUIRE(program("clips trim " + clip + " " + (scratch / "s.bvh") + " --from 0.5s --to 1.5s").status ==
                0);
        CHECK(parts(slurp(scratch / "s.bvh")).frames ==
              std::vector(whole.frames.begin() + 15, whole.frames.begin() + 46));
        REQUIRE(program("clips trim " + clip + " " + (scratch / "e.bvh") + " --from 30").status == 0);
        CHECK(parts(slurp(scratch / "e.bvh")).frames ==
              std::vector(whole.frames.begin() + 30, whole.frames.end()));

        const std::string out = " " + (scratch / "no.bvh");
        CHECK_FAILS_SAYING(program("clips trim " + clip + out + " --to 9999"), "direct_A.bvh", "9999");
        CHECK_FAILS_SAYING(program("clips trim " + clip + out + " --from 1e300s"), "--from", "1e300s");
        CHECK_FAILS_SAYING(program("clips trim " + clip + out + " --from ten"), "--from", "'ten'");
        CHECK_FAILS_SAYING(program("clips trim " + clip + out + " --from 20 --to 10"), "after the last");
        CHECK_FALSE(fs::exists(scratch / "no.bvh"));
    }

    TEST_CASE("a clip is resampled") {
        const Scratch scratch;
        const std::string clip = generated(scratch) + "/direct_A.bvh";
        const auto whole = assets::readBvh(clip);
        REQUIRE(program("clips resample " + clip + " " + (scratch / "r.bvh") + " --fps 60").status == 0);
        const auto fast = assets::readBvh(scratch / "r.bvh");
        REQUIRE(fast.has_value());
        CHECK(fast->clip.frameCount() == 2 * (whole->clip.frameCount() - 1) + 1);
        CHECK(fast->clip.framesPerSecond() == doctest::Approx(60.0));
        CHECK(program("clips resample " + clip + " " + (scratch / "x.bvh") + " --fps 0").status == 2);
    }

    TEST_CASE("a recording is cut into clips with targets from a list in order") {
        const Scratch scratch;
        const std::string folder = generated(scratch);
        spill(scratch / "take.bvh", recorded(folder));
        const std::string out = scratch / "cut";
        const auto listed = program("clips segment " + (scratch / "take.bvh"));
        REQUIRE_MESSAGE(listed.status == 0, listed.err);
        CHECK(contains(listed.out, "3 gestures"));
        const auto made = program("clips segment " + (scratch / "take.bvh") + " --out " + out +
                                  " --targets " + (scratch / "targets.csv") + " --system lab");
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const auto truth = manifestAt(folder + "/manifest.csv");
        const auto cut = manifestAt(out + "/manifest.csv");
        REQUIRE(cut.rows.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& row = cut.rows[i];
            const auto& known = truth.rows[i];
            CHECK(row.clip == "lab_" + known.target_id + ".bvh");
            CHECK(row.system == "lab");
            CHECK(*row.target == *known.target);
            CHECK(row.phases->hand == known.phases->hand);
            const auto length = [](const auto& p) { return p.end_frame - p.onset_frame; };
            CHECK(std::abs(length(*row.phases) - length(*known.phases)) <= 6);
            const auto clip = assets::readBvh(out + "/" + row.clip);
            REQUIRE(clip.has_value());
            CHECK(row.phases->end_frame < clip->clip.frameCount());
        }
        spill(scratch / "two.csv", "target_id,x,y,z\nA,1,1,1\nB,1,1,1\n");
        CHECK_FAILS_SAYING(program("clips segment " + (scratch / "take.bvh") + " --targets " +
                                   (scratch / "two.csv") + " --out " + (scratch / "none")),
                           "two.csv", "lists 2 targets, and 3 gestures were found");
        CHECK_FALSE(fs::exists(scratch / "none"));
        CHECK_FAILS_SAYING(program("clips segment " + (scratch / "take.bvh") + " --system ../x"), "--system");
    }

    TEST_CASE("a marker beside the recording gives the targets, front and back apart") {
        const Scratch scratch;
        const std::string folder = generated(scratch);
        const std::string take = recorded(folder);
        spill(scratch / "take.bvh", take);
        const auto truth = manifestAt(folder + "/manifest.csv");
        // In centimetres: the first two as they are, the second one behind the person; hidden for the third.
        std::string marker = "frame,x,y,z,quality\n";
        const std::size_t lengths[] = {parts(slurp(folder + "/direct_A.bvh")).frames.size() + 15,
                                       parts(slurp(folder + "/direct_B.bvh")).frames.size() + 15};
        for (std::size_t f = 0; f < parts(take).frames.size(); ++f) {
            const std::string frame = std::to_string(f);
            if (f < lengths[0])
                marker += frame + ",120,130,160,1\n";
            else if (f < lengths[0] + lengths[1])
                marker += frame + ",-90,80,-180,1\n";
            else
                marker += frame + ",,,,0\n";
        }
        spill(scratch / "marker.csv", marker);
        const std::string out = scratch / "cut";
        const auto made =
            program("clips segment " + (scratch / "take.bvh") + " --out " + out + " --targets " +
                    (scratch / "marker.csv") + " --target-metres-per-unit 0.01 --split");
        REQUIRE_MESSAGE(made.status == 0, made.err);
        CHECK(contains(made.out, "the marker is hidden during the hold"));
        const auto front = manifestAt(out + "/front/manifest.csv");
        const auto back = manifestAt(out + "/back/manifest.csv");
        const auto without = manifestAt(out + "/no-target/manifest.csv");
        REQUIRE(front.rows.size() == 1);
        REQUIRE(back.rows.size() == 1);
        REQUIRE(without.rows.size() == 1);
        const auto near = [](const deixis::Vec3& a, const deixis::Vec3& b) {
            return std::abs(a.x - b.x) < 0.01 && std::abs(a.y - b.y) < 0.01 && std::abs(a.z - b.z) < 0.01;
        };
        CHECK(near(*front.rows[0].target, {1.2, 1.3, 1.6}));
        CHECK(near(*back.rows[0].target, {-0.9, 0.8, -1.8}));
        CHECK_FALSE(without.rows[0].target.has_value());
        CHECK(fs::exists(out + "/back/recorded_G002.bvh"));
        CHECK_FALSE(fs::exists(out + "/manifest.csv"));

        // A joint of the recording can be the marker.
        const auto joint = program("clips segment " + (scratch / "take.bvh") + " --out " +
                                   (scratch / "joint") + " --marker head");
        REQUIRE_MESSAGE(joint.status == 0, joint.err);
        const auto at_head = manifestAt(scratch / "joint/manifest.csv");
        REQUIRE(at_head.rows.size() == 3);
        CHECK(at_head.rows[0].target->y > 1.4);
        CHECK_FAILS_SAYING(program("clips segment " + (scratch / "take.bvh") + " --marker ball"), "take.bvh",
                           "no joint 'ball'", "clips joints");
    }

    TEST_CASE("a marker file that is wrong is rejected with line and column") {
        const Scratch scratch;
        const std::string folder = generated(scratch);
        const std::string run =
            "clips segment " + folder + "/direct_A.bvh --targets " + (scratch / "marker.csv");
        spill(scratch / "marker.csv", "time,x,y\n0,1,2\n");
        CHECK_FAILS_SAYING(program(run), "marker.csv:1", "'z' is missing");
        spill(scratch / "marker.csv", "time,x,y,z\n0,1,nan,2\n");
        CHECK_FAILS_SAYING(program(run), "marker.csv:2: y", "'nan'");
        spill(scratch / "marker.csv", "time,x,y,z\n0,1,2\n");
        CHECK_FAILS_SAYING(program(run), "marker.csv:2", "found 3 fields, expected 4");
        spill(scratch / "marker.csv", "frame,x,y,z\n0,,,\n");
        CHECK_FAILS_SAYING(program(run), "marker.csv", "no position");
        spill(scratch / "marker.csv", "a,b\n0,1\n");
        CHECK_FAILS_SAYING(program(run), "marker.csv:1", "target_id");
    }
}
