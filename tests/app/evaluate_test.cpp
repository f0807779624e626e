// evaluate and targets --grid: the real program, from made clips to a page.
#include <fcntl.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/program/progress_line.hpp"
#include "csv_table.hpp"
#include "program.hpp"
#include "schema_check.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis::tests;
using deixis::tests::contains;

namespace {

/// Clips of two systems for a grid of eight points, made once.
const fs::path& corpus() {
    static const fs::path folder = [] {
        const fs::path made = buildDir() / "evaluate-clips";
        fs::create_directories(made);
        const auto grid = program("targets --grid 8");
        REQUIRE_MESSAGE(grid.status == 0, grid.err);
        spill(made / "grid.csv", grid.out);
        for (const std::string system : {"direct", "stiff"}) {
            const auto clips = program("generate " + system + " --targets " + (made / "grid.csv").string() +
                                       " --force --out " + (made / system).string());
            REQUIRE_MESSAGE(clips.status == 0, clips.err);
        }
        return made;
    }();
    return folder;
}

std::string manifests() {
    return (corpus() / "direct").string() + " " + (corpus() / "stiff/manifest.csv").string();
}

/// A manifest of its own folder with one clip of `direct` under the name clip.bvh; `row` follows the clip's
/// name.
std::string manifestWith(const Scratch& scratch, const std::string& row) {
    fs::copy_file(corpus() / "direct/direct_G0001.bvh", scratch / "clip.bvh",
                  fs::copy_options::overwrite_existing);
    spill(scratch / "manifest.csv",
          "clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,fps,seed\nclip.bvh," +
              row + "\n");
    return scratch / "manifest.csv";
}

}  // namespace

TEST_SUITE("app/evaluate") {
    TEST_CASE("Two systems' clips become a page, numbers and tables, the same whatever the threads") {
        const Scratch scratch;
        const auto evaluated = [&](const std::string& name, const std::string& more) {
            const auto done =
                program("evaluate " + manifests() + " -o " + (scratch / (name + ".html")) + " --json " +
                        (scratch / (name + ".json")) + " --csv " + (scratch / name) + more);
            REQUIRE_MESSAGE(done.status == 0, done.err);
            CHECK(contains(done.out, name + ".html"));
        };
        evaluated("one", " --threads 1");
        evaluated("five", " --threads 5");
        for (const std::string ending : {".html", ".json", "/clips.csv", "/systems.csv", "/comparisons.csv",
                                         "/profiles.csv", "/targets.csv", "/clusters.csv"}) {
            CAPTURE(ending);
            CHECK(slurp(scratch / ("one" + ending)) == slurp(scratch / ("five" + ending)));
            CHECK(slurp(scratch / ("one" + ending)).size() > 100);
        }
        CHECK(schemaProblems("evaluation", scratch / "one.json") == "");
        const auto json = nlohmann::json::parse(slurp(scratch / "one.json"));
        REQUIRE(json["systems"].size() == 2);
        for (const auto& system : json["systems"]) {
            CHECK(system["clips"] == 8);
            CHECK(system["missing"] == 0);
            CHECK(system["synthetic"] == true);
            CHECK(system["placed"] == 0);
            CHECK(system["phases_found"] == 0);
            // Equation 2 of the paper, of each clip's own angle.
            double sum = 0.0;
            const auto clips =
                CsvTable(slurp(scratch / "one/clips.csv")).having({{"system", system["system"]}});
            REQUIRE(clips.size() == 8);
            for (const auto& clip : clips) {
                const double theta = 1.0 - std::stod(clip.at("error_deg")) / 180.0;
                const double reward = (std::exp(theta) - 1.0) / std::exp(1.0);
                CHECK(std::stod(clip.at("accuracy")) == doctest::Approx(reward).epsilon(1e-9));
                sum += reward;
            }
            CHECK(system["accuracy"]["mean"].get<double>() == doctest::Approx(sum / 8.0).epsilon(1e-9));
        }
        REQUIRE(json["comparisons"].size() == 1);
        CHECK(json["comparisons"][0]["a"] == "direct");
        CHECK(json["comparisons"][0]["b"] == "stiff");
        CHECK(json["comparisons"][0]["targets"] == 8);
        CHECK(json["training"]["synthetic"] == true);
        CHECK(json["training"]["targets"].size() == 104);
        CHECK(json["targets"].size() == 8);
        CHECK(json["files"].size() == 3);
        CHECK(XmlDocument(slurp(scratch / "one.html")).count("//*[@class='synthetic']") > 0);
    }

    TEST_CASE("Every ray stands side by side, and that they disagree is said at the page's head") {
        const Scratch scratch;
        const auto made = program("evaluate " + (corpus() / "direct").string() + " " +
                                  (corpus() / "stiff").string() + " -o " + (scratch / "e.html") + " --json " +
                                  (scratch / "e.json") + " --csv " + (scratch / "t"));
        INFO(made.err);
        REQUIRE(made.status == 0);
        const auto systems = nlohmann::json::parse(slurp(scratch / "e.json"))["systems"];
        const auto& rays = systems[0]["ray_errors_deg"];
        CHECK(systems[0]["system"] == "direct");
        CHECK(rays.size() == 6);
        // The forearm's is the angle of the accuracy; direct is made to have eye, fingertip and target in
        // line.
        CHECK(rays["forearm"]["mean"].get<double>() ==
              doctest::Approx(systems[0]["error_deg"]["mean"].get<double>()).epsilon(1e-6));
        CHECK(rays["eye-fingertip"]["mean"].get<double>() < 1.0);
        CHECK(rays["forearm"]["mean"].get<double>() > 10.0);
        const std::string page = slurp(scratch / "e.html");
        CHECK(contains(page, "All rays side by side"));
        CHECK(XmlDocument(page).count("//h:b[.='direct'][contains(preceding-sibling::text()[1], "
                                      "'Mean angle between ray and target: ')]") > 0);
        CHECK_FALSE(contains(page, "strongest for"));
        CHECK(contains(page, "p (Holm)"));
        const CsvTable table(slurp(scratch / "t/rays.csv"));
        const auto rows = table.find({{"system", "direct"}, {"ray", "eye-fingertip"}});
        REQUIRE(rows.size() == 1);
        CHECK(table.cell(rows[0], "clips") == "8");
    }

    TEST_CASE("Bandwidths and training targets can be given; the settings stand in the numbers") {
        const Scratch scratch;
        const auto done =
            program("evaluate " + manifests() + " --training " + (corpus() / "grid.csv").string() +
                    " --bandwidth 0.80,0.36,0.35 --meanshift-bandwidth 0.78 -o " + (scratch / "e.html") +
                    " --json " + (scratch / "e.json"));
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const auto json = nlohmann::json::parse(slurp(scratch / "e.json"));
        CHECK(json["settings"]["bandwidths_m"] == std::vector<double>{0.80, 0.36, 0.35});
        CHECK(json["settings"]["mean_shift_bandwidth_m"] == 0.78);
        CHECK(json["training"]["synthetic"] == false);
        CHECK(json["training"]["targets"].size() == 8);
        const auto by_manifest =
            program("evaluate " + manifests() + " --training " + (corpus() / "direct/manifest.csv").string() +
                    " -o " + (scratch / "m.html") + " --json " + (scratch / "m.json"));
        REQUIRE_MESSAGE(by_manifest.status == 0, by_manifest.err);
        CHECK(nlohmann::json::parse(slurp(scratch / "m.json"))["training"]["synthetic"] == true);
    }

    TEST_CASE("With a study, observers read its games, and ceilings stand beside them") {
        const Scratch scratch{WithSharedStimuli{}};
        const auto list = program("targets pointing2023 --no-picture");
        REQUIRE(list.status == 0);
        // The first eight targets of the study, whose clips are quickly made.
        std::string eight;
        std::size_t end = 0;
        for (int lines = 0; lines < 9; ++lines) end = list.out.find('\n', end) + 1;
        spill(scratch / "eight.csv", list.out.substr(0, end));
        for (const std::string system : {"direct", "drifting"})
            REQUIRE(program("generate " + system + " --targets " + (scratch / "eight.csv") + " --out " +
                            (scratch / system))
                        .status == 0);
        const auto done = program("evaluate " + (scratch / "direct") + " " + (scratch / "drifting") +
                                  " --study pointing2023 -o " + (scratch / "e.html") + " --json " +
                                  (scratch / "e.json") + " --csv " + (scratch / "tables"));
        REQUIRE_MESSAGE(done.status == 0, done.err);
        CHECK(schemaProblems("evaluation", scratch / "e.json") == "");
        const auto observers = nlohmann::json::parse(slurp(scratch / "e.json"))["observers"];
        CHECK(observers["study"] == "pointing2023");
        REQUIRE(observers["readings"].size() == 6);  // two systems, all layouts and each of two
        CHECK(observers["readings"][0]["layout"] == "all");
        CHECK(observers["readings"][0]["trials"] == 16.0);
        const auto& direct = observers["readings"][0]["observers"];
        CHECK(direct["eye-fingertip"]["without_error"] == 1.0);
        CHECK(direct["eye-fingertip"]["accuracy"].get<double>() >
              direct["arm-finger"]["accuracy"].get<double>() + 0.2);
        CHECK(direct["two-cue"]["accuracy"].get<double>() > 0.75);
        CHECK(observers["nearest_training_target"]["targets"] == 100);
        const double ceiling = observers["nearest_training_target"]["share_right"].get<double>();
        CHECK(ceiling > 0.5);
        CHECK(ceiling < 0.85);
        const std::string page = slurp(scratch / "e.html");
        CHECK(contains(page, "Read by observers"));
        CHECK(contains(page, "None of them has been shown to read as people do"));
        const CsvTable readings(slurp(scratch / "tables/observers.csv"));
        for (auto one = direct.begin(); one != direct.end(); ++one)
            CHECK_MESSAGE(readings.has({{"system", "direct"}, {"observer", one.key()}}), one.key());
        const XmlDocument well_formed(page);
        CHECK_FAILS_SAYING(
            program("evaluate " + manifests() + " --study pointing2023 -o " + (scratch / "n.html")),
            "--study", "no clip was made for a target of the study");
        CHECK_FAILS_SAYING(
            program("evaluate " + manifests() + " --study genea-pairwise -o " + (scratch / "n.html")),
            "genea-pairwise", "has no referential game");
    }

    TEST_CASE("A clip without phases is measured at the peak of the gesture that is found") {
        const Scratch scratch;
        const auto grid = slurp(corpus() / "grid.csv");
        const auto line = grid.substr(grid.find("G0001,") + 6);
        const std::string target = line.substr(0, line.find('\n'));
        const auto done = program("evaluate " + manifestWith(scratch, "mine,G0001," + target + ",,,,,,30,0") +
                                  " -o " + (scratch / "e.html") + " --json " + (scratch / "e.json"));
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const auto found = nlohmann::json::parse(slurp(scratch / "e.json"))["systems"][0];
        CHECK(found["phases_found"] == 1);
        CHECK(found["synthetic"] == false);
        CHECK(found["n"] == 1);
        CHECK(found["accuracy"]["mean"].get<double>() > 0.4);
    }

    TEST_CASE(
        "A figure and its target moved together by 2 cm have the same accuracy, however near the origin") {
        const Scratch scratch;
        const auto grid = slurp(corpus() / "grid.csv");
        std::istringstream line(grid.substr(grid.find("G0001,") + 6));
        double x = 0.0, y = 0.0, z = 0.0;
        char comma = 0;
        line >> x >> comma >> y >> comma >> z;
        const auto accuracyAt = [&](double shift_x, const std::string& frame) {
            std::string bvh = slurp(corpus() / "direct/direct_G0001.bvh");
            // Each line of the motion begins with the hips' x, metres.
            const auto from = bvh.find('\n', bvh.find("Frame Time")) + 1;
            std::istringstream motion(bvh.substr(from));
            std::string out = bvh.substr(0, from);
            for (std::string pose; std::getline(motion, pose);) {
                std::size_t end = 0;
                const double hips_x = std::stod(pose, &end);
                out += std::to_string(hips_x + shift_x) + pose.substr(end) + "\n";
            }
            spill(scratch / "clip.bvh", out);
            spill(scratch / "manifest.csv",
                  "clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,fps,seed,"
                  "target_frame\nclip.bvh,mine,G0001," +
                      std::to_string(x + (frame == "figure" ? 0.0 : shift_x)) + "," + std::to_string(y) +
                      "," + std::to_string(z) + ",,,,,,30,0," + frame + "\n");
            const auto done = program("evaluate " + (scratch / "manifest.csv") + " -o " +
                                      (scratch / "e.html") + " --force --json " + (scratch / "e.json"));
            REQUIRE_MESSAGE(done.status == 0, done.err);
            const auto system = nlohmann::json::parse(slurp(scratch / "e.json"))["systems"][0];
            CHECK(system["placed"] == (frame == "figure" ? 1 : 0));
            return system["accuracy"]["mean"].get<double>();
        };
        const double here = accuracyAt(0.0, "clip");
        for (const double shift_x : {0.24, 0.26, 3.0})
            CHECK(accuracyAt(shift_x, "") == doctest::Approx(here).epsilon(1e-4));
        // Given from the figure, a target needs no moving.
        const double own = accuracyAt(0.0, "figure");
        for (const double shift_x : {0.24, 0.26, 3.0})
            CHECK(accuracyAt(shift_x, "figure") == doctest::Approx(own).epsilon(1e-4));
    }

    TEST_CASE("Every clip that is missing or cannot be measured is told at once, and nothing is written") {
        const Scratch scratch;
        for (const char* name : {"direct", "stiff"})
            fs::copy(corpus() / name, scratch / name, fs::copy_options::recursive);
        fs::remove(scratch / "direct/direct_G0002.bvh");
        fs::remove(scratch / "stiff/stiff_G0007.bvh");
        const std::string command =
            "evaluate " + (scratch / "direct") + " " + (scratch / "stiff") + " -o " + (scratch / "e.html");
        const auto missing = program(command);
        CHECK(missing.status == 1);
        for (const std::string words : {"direct_G0002.bvh: the clip's file is not there",
                                        "stiff_G0007.bvh: the clip's file is not there",
                                        "deixis: error: 2 clips missing; nothing was written"})
            CHECK_MESSAGE(contains(missing.err, words), missing.err);

        spill(scratch / "direct/direct_G0002.bvh", "HIERARCHY\nnonsense");
        spill(
            scratch / "stiff/stiff_G0007.bvh",
            "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nEnd Site\n{\n"
            "OFFSET 0 1 0\n}\n}\nMOTION\nFrames: 200\nFrame Time: 0.0333333\n" +
                [] {
                    std::string frames;
                    for (int i = 0; i < 200; ++i) frames += "0 1 0\n";
                    return frames;
                }());
        const auto bad = program(command);
        CHECK(bad.status == 1);
        CHECK_MESSAGE(contains(bad.err, "direct_G0002.bvh:2: found 'nonsense', expected 'ROOT'"), bad.err);
        CHECK_MESSAGE(contains(bad.err, "stiff_G0007.bvh: no joint was found for"), bad.err);
        CHECK_MESSAGE(contains(bad.err, "2 clips cannot be measured"), bad.err);
        CHECK_FALSE(fs::exists(scratch / "e.html"));
    }

    TEST_CASE("Progress tells share, time elapsed and time left, on a terminal alone") {
        using deixis::app::progressLine;
        CHECK(progressLine("clips", 0, 8, 0.0) ==
              "clips   0 % [........................] 0 of 8, 0:00 elapsed, -- left");
        CHECK(progressLine("clips", 250, 1000, 61.0) ==
              "clips  25 % [######..................] 250 of 1000, 1:01 elapsed, 3:03 left");
        CHECK(progressLine("clips", 1, 1000, 30.0) ==
              "clips   0 % [........................] 1 of 1000, 0:30 elapsed, 8:19:30 left");
        CHECK(progressLine("clips", 8, 8, 0.2) ==
              "clips 100 % [########################] 8 of 8, 0:00 elapsed, 0:00 left");

        const Scratch scratch;
        const std::string command = "evaluate " + manifests() + " -o " + (scratch / "e.html");
        CHECK(program(command).err.empty());
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
        REQUIRE(terminal >= 0);
        REQUIRE(grantpt(terminal) == 0);
        REQUIRE(unlockpt(terminal) == 0);
        const std::string name = ptsname(terminal);
        const int other_end =
            open(name.c_str(), O_RDWR | O_NOCTTY);  // until it is closed there is more to read
        REQUIRE(other_end >= 0);
        std::string shown;
        std::thread reader([&] {
            std::array<char, 4096> bytes{};
            for (ssize_t got = 0; (got = read(terminal, bytes.data(), bytes.size())) > 0;)
                shown.append(bytes.data(), static_cast<std::size_t>(got));
        });
        const int status = program(command + " 2>" + name).status;
        close(other_end);
        reader.join();
        close(terminal);
        CHECK(status == 0);
        CHECK_MESSAGE(contains(shown, "clips 100 % [########################] 16 of 16, "), shown);
        CHECK(contains(shown, " elapsed, 0:00 left"));
    }

    TEST_CASE("Bad input is rejected with the place and a hint") {
        const Scratch scratch;
        const std::string out = " -o " + (scratch / "e.html");
        CHECK_FAILS_SAYING(program("evaluate " + (scratch / "none.csv") + out), "none.csv",
                           "cannot be opened");
        CHECK_FAILS_SAYING(program("evaluate " + manifestWith(scratch, "mine,G0001,,,,,,,,,30,0") + out),
                           "manifest.csv", "no clip with a target", "target_x");
        CHECK_FAILS_SAYING(program("evaluate " + manifests() + " " + (corpus() / "direct").string() + out),
                           "is given twice");
        CHECK_FAILS_SAYING(program("evaluate " + manifests() + " --bandwidth 0.8,0.3" + out), "--bandwidth",
                           "found 2 lengths");
        CHECK_FAILS_SAYING(program("evaluate " + manifests() + " --bandwidth 0.8,x,1" + out),
                           "0.80,0.36,0.35");
        CHECK_FAILS_SAYING(program("evaluate " + manifests() + " --bandwidth silverman" + out),
                           "normal-reference, scott or scott-covariance");
        CHECK_FAILS_SAYING(program("evaluate " + manifests() + " --meanshift-bandwidth 0" + out), "auto");
        CHECK_FAILS_SAYING(
            program("evaluate " + manifests() + " -o " + (scratch / "x") + " --json " + (scratch / "x")),
            "both the page and the JSON");
        CHECK_FAILS_SAYING(
            program("evaluate " + manifests() + " -o " + (corpus() / "direct/manifest.csv").string()),
            "is one of the inputs");
        for (const auto& [row, words] : std::vector<std::pair<std::string, std::string>>{
                 {"mine,G1,1,1,1,right,3,6,9,4000,30,0",
                  "frames, but its manifest lets the gesture end in frame 4000"},
                 {"mine,G1,1,1,1,right,3,6,9,12,60,0", "but its manifest says 60"}}) {
            const auto told = program("evaluate " + manifestWith(scratch, row) + out);
            CHECK(told.status == 1);
            CHECK_MESSAGE(contains(told.err, words), told.err);
            CHECK(contains(told.err, "deixis: error: 1 clip cannot be measured; nothing was written"));
        }
        spill(scratch / "empty.csv", "target_id,x,y,z\n");
        CHECK_FAILS_SAYING(
            program("evaluate " + manifests() + " --training " + (scratch / "empty.csv") + out), "empty.csv",
            "has no targets");
        CHECK_FALSE(fs::exists(scratch / "e.html"));
    }

    TEST_CASE("A grid is printed as targets are, within the limits of the training targets") {
        const Scratch scratch;
        spill(scratch / "training.csv", "target_id,x,y,z\nA,-1,0.5,2\nB,2,1.5,0.5\n");
        const auto grid = program("targets --grid 8 --training " + (scratch / "training.csv"));
        CHECK(grid.status == 0);
        const auto stands = [](const std::string& csv, const char* id, const char* x, const char* y,
                               const char* z) {
            return CsvTable(csv).has({{"target_id", id}, {"x", x}, {"y", y}, {"z", z}});
        };
        CHECK(stands(grid.out, "G0001", "-1.0000", "0.5000", "0.5000"));
        CHECK(stands(grid.out, "G0008", "2.0000", "1.5000", "2.0000"));
        // The paper's evaluation (section 3.2) has 1,000 points: ten along each axis.
        const auto paper = program("targets --grid --training " + (scratch / "training.csv"));
        CHECK(paper.status == 0);
        CHECK(std::count(paper.out.begin(), paper.out.end(), '\n') == 1001);
        CHECK(stands(paper.out, "G0002", "-0.6667", "0.5000", "0.5000"));  // a ninth of 3 m on
        CHECK(stands(paper.out, "G1000", "2.0000", "1.5000", "2.0000"));
        CHECK(program("targets --training " + (scratch / "training.csv") + " --grid").out == paper.out);
        const auto round = program("targets --grid 8 --spherical --training " + (scratch / "training.csv"));
        CHECK(round.status == 0);
        CHECK(round.out != grid.out);
        CHECK(program("targets pointing2023 --spherical").status == 2);
        CHECK_FAILS_SAYING(program("targets --grid 10"), "--grid", "8 or 27");
        CHECK(program("targets").status == 2);
        CHECK(program("targets pointing2023 --grid 8").status == 2);
        CHECK(program("targets pointing2023 --training x.csv").status == 2);
    }
}
