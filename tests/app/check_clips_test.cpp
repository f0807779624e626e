// check looks into the manifests and clips that a study names, and tells all that is wrong with them at once.
#include <sstream>

#include "lab_study.hpp"
#include "text.hpp"

using namespace deixis::tests;
using deixis::tests::contains;

namespace {

/// One row of the manifest with a field replaced; rows count from 1, as targets do.
std::string withField(const std::string& manifest, int row, int field, const std::string& value) {
    std::size_t at = 0;
    for (int line = 0; line < row; ++line) at = manifest.find('\n', at) + 1;
    for (int i = 0; i < field; ++i) at = manifest.find(',', at) + 1;
    return manifest.substr(0, at) + value + manifest.substr(manifest.find_first_of(",\n", at));
}

constexpr int clip = 0, target_x = 3, end_frame = 10, fps = 11;

}  // namespace

TEST_SUITE("app/check_clips") {
    TEST_CASE("Every fault of a manifest and its clips is told at once, with the study's line and the row") {
        const LabFolder lab;
        CHECK(program("check " + lab.path("study.toml")).status == 0);
        std::string manifest = lab.read("clips/manifest.csv");
        manifest = withField(manifest, 1, clip, "nowhere.bvh");
        manifest = withField(manifest, 2, target_x, "9");
        manifest = withField(manifest, 3, end_frame, "99999");
        manifest = withField(manifest, 4, fps, "12");
        // In the place of T006 stands T003 once more.
        const std::string sound = lab.read("clips/manifest.csv");
        const auto third = sound.find("direct_T003");
        manifest = manifest.substr(0, manifest.find("direct_T006")) +
                   sound.substr(third, sound.find('\n', third) + 1 - third);
        lab.write("clips/manifest.csv", manifest);
        const std::string bvh = lab.read("clips/direct_T005.bvh");
        lab.write("clips/direct_T005.bvh", bvh.substr(0, bvh.size() / 2));

        const auto checked = program("check " + lab.path("study.toml"));
        CHECK(checked.status == 1);
        CAPTURE(checked.err);
        const std::string place = lab.path("study.toml") + ":24: systems.manifest: ";
        const std::string file = lab.path("clips/manifest.csv");
        for (const std::string& line :
             {place + file + ":2: clip: No such file: " + lab.path("clips/nowhere.bvh"),
              place + file + ":3: target_x: was made for the target (9.0000, ",
              place + file + ":4: end: found 99999, which lies outside the clip direct_T003.bvh",
              place + file + ":5: fps: found 12, but the clip direct_T004.bvh has 30",
              place + file + ":6: clip: " + lab.path("clips/direct_T005.bvh") + ":",
              place + file +
                  ":7: clip: the clip direct_T003.bvh of system 'direct' a second time for target T003; line "
                  "4",
              place + file + ": has no clip of system 'ours' for 1 of 6 targets: T006",
              std::string("has 7 problems")})
            CHECK_MESSAGE(contains(checked.err, line), line);
        // A run says the first of them, and how many more there are.
        const auto ran = lab.run("P01");
        CHECK_FAILS_SAYING(ran, place + file, "lists 6 more problems");
        CHECK_FALSE(fs::exists(lab.path("study.locked")));
    }

    TEST_CASE("Centimetres, an unknown system, garbage, a broken row and no manifest at all are told") {
        const LabFolder lab;
        const std::string manifest = lab.read("clips/manifest.csv");
        const auto says = [&](const std::string& words) {
            const auto checked = program("check " + lab.path("study.toml"));
            CHECK(checked.status == 1);
            CHECK_MESSAGE(contains(checked.err, lab.path("study.toml") + ":24: systems.manifest: "),
                          checked.err);
            CHECK_MESSAGE(contains(checked.err, words), checked.err);
            CHECK_FAILS_SAYING(lab.simulate(), "study.toml:24: systems.manifest: ", words);
        };
        SUBCASE("centimetres") {
            std::string in_cm;
            std::istringstream lines(manifest);
            std::string line;
            std::getline(lines, line);
            in_cm = line + "\n";
            while (std::getline(lines, line)) {
                std::vector<std::string> fields;
                std::istringstream cells(line);
                for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
                for (std::size_t i = 3; i < 6; ++i) fields[i] = std::to_string(100.0 * std::stod(fields[i]));
                for (std::size_t i = 0; i < fields.size(); ++i) in_cm += (i > 0 ? "," : "") + fields[i];
                in_cm += "\n";
            }
            lab.write("clips/manifest.csv", in_cm);
            says("targets of 6 rows are the study's a hundredfold: they look like centimetres");
        }
        SUBCASE("a system that does not occur") {
            std::string two = manifest;
            two = withField(two, 1, 1, "mine");
            two = withField(two, 2, 1, "yours");
            lab.write("clips/manifest.csv", two);
            says("has clips of the systems direct, mine, yours, but none named 'ours'");
        }
        SUBCASE("garbage") {
            lab.write("clips/direct_T001.bvh", "HIERARCHY\nnonsense");
            says("clips/manifest.csv:2: clip: ");
        }
        SUBCASE("a row that is none") {
            lab.write("clips/manifest.csv", withField(manifest, 2, fps, "fast"));
            says("clips/manifest.csv:3: fps: found 'fast'");
        }
        SUBCASE("no manifest") {
            fs::remove(lab.path("clips/manifest.csv"));
            says("clips/manifest.csv: cannot be opened: No such file");
        }
    }

    TEST_CASE("The manifests that targets come from are named by the study's line and key") {
        const LabFolder lab;
        lab.change("study.toml", "height_m = [0.5, 1.5]\narc_deg = [-60, 60]\nradius_m = [1.5, 2.0]",
                   "fit_manifest = \"lost.csv\"");
        const auto checked = program("check " + lab.path("study.toml"));
        CHECK_MESSAGE(contains(checked.err, "study.toml:8: targets.fit_manifest: " + lab.path("lost.csv")),
                      checked.err);
    }

    TEST_CASE("What only another machine would meet, and headings that look like radians, are doubted") {
        const LabFolder lab;
        const Scratch elsewhere;
        const auto own = buildDir() / "share/deixis/avatar.glb";
        fs::copy_file(own, elsewhere / "figure.glb");
        lab.change("study.toml", "seed = 7", "seed = 7\navatar = \"" + (elsewhere / "figure.glb") + "\"");
        lab.change("study.toml", "heading_deg = 180", "heading_deg = 3.14159");
        lab.write("clips/manifest.csv",
                  withField(lab.read("clips/manifest.csv"), 1, clip, lab.path("clips/direct_T001.bvh")));
        const auto checked = program("check " + lab.path("study.toml"));
        CHECK_MESSAGE(checked.status == 0, checked.err);
        for (const char* words : {"study.toml:5: study.avatar: ", "is outside the study's folder",
                                  "clips/manifest.csv:2: clip: ", "is an absolute path",
                                  "study.toml:21: layouts.heading_deg: 3.14159 looks like radians, expected "
                                  "degrees (180?)"})
            CHECK_MESSAGE(contains(checked.out, words), checked.out);
    }
}
