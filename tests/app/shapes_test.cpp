// The shapes of what commands print, on which scripts rely.
#include <cmath>
#include <sstream>

#include "program.hpp"
#include "shared_data.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

std::vector<std::string> splitRow(const std::string& row) {
    std::vector<std::string> cells;
    std::stringstream stream(row);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

std::vector<std::vector<std::string>> table(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::stringstream stream(csv);
    for (std::string line; std::getline(stream, line);) rows.push_back(splitRow(line));
    return rows;
}

}  // namespace

TEST_SUITE("app/shapes") {
    TEST_CASE("targets prints 100 targets with two distractors 20 to 40 cm away, and draws them") {
        const Scratch scratch;
        const auto finished = program("targets pointing2023 --picture " + (scratch / "fig1.svg"));
        REQUIRE(finished.status == 0);
        CHECK(finished.out.rfind("target_id,x,y,z,d1_x,d1_y,d1_z,d2_x,d2_y,d2_z,seen_", 0) == 0);
        const auto rows = table(finished.out);
        REQUIRE(rows.size() == 101);
        for (std::size_t i = 1; i < rows.size(); ++i) {
            REQUIRE(rows[i].size() >= 19);  // what four places see, the angles of five, what was drawn again
            const auto at = [&](std::size_t column, std::size_t k) { return std::stod(rows[i][column + k]); };
            for (const std::size_t distractor : {4U, 7U}) {
                double d2 = 0.0;
                for (std::size_t k = 0; k < 3; ++k) d2 += std::pow(at(1, k) - at(distractor, k), 2);
                CHECK(std::sqrt(d2) >= 0.2 - 1e-9);
                CHECK(std::sqrt(d2) <= 0.4 + 1e-9);
            }
            const double radius = std::hypot(at(1, 0), at(1, 2));
            CHECK(radius >= 1.9 - 1e-4);
            CHECK(radius <= 2.2 + 1e-4);
        }
        CHECK(slurp(scratch / "fig1.svg").find("<svg") != std::string::npos);
        CHECK(program("targets pointing2023 --no-picture").out == finished.out);
    }

    TEST_CASE("plan prints every trial in order with stage, system, target and layout") {
        const auto finished = program("plan pointing2023 --participant P07 --json");
        REQUIRE(finished.status == 0);
        const json plan = json::parse(finished.out);
        int ratings = 0;
        int choices = 0;
        int across = 0;
        for (const auto& trial : plan["trials"]) {
            if (trial["kind"] == "questionnaire") continue;
            CHECK(trial["system"].is_string());
            CHECK(trial["target_id"].is_string());
            if (trial["practice"]) continue;
            if (trial["stage"] == "naturalness") {
                CHECK(choices == 0);  // stage 1 comes first
                ++ratings;
            } else {
                CHECK(trial["stage"] == "game");
                ++choices;
                across += trial["layout"] == "across";
            }
        }
        CHECK(ratings == 20);
        CHECK(choices == 40);
        CHECK(across == 20);
        CHECK(program("plan pointing2023 --participant P07 --json").out == finished.out);
        CHECK(program("plan pointing2023 --participant P08 --json").out != finished.out);
        const auto people = program("plan pointing2023 --participant P07");
        CHECK(people.status == 0);
        CHECK(std::count(people.out.begin(), people.out.end(), '\n') >= 60);
    }

    TEST_CASE("clips joints prints the golden walk's positions in metres") {
        const auto walk = sharedData("bvh/bvhtoolbox_walk01/walk01.bvh");
        DEIXIS_SKIP_WITHOUT(walk);
        const auto finished = program("clips joints " + walk.string() + " --csv");
        REQUIRE(finished.status == 0);
        CHECK(finished.out.rfind("frame,time,Hips.x,Hips.y,Hips.z,", 0) == 0);
        const auto ours = table(finished.out);
        const auto golden = table(slurp(sharedData("bvh/bvhtoolbox_walk01/walk01_pos.csv")));
        REQUIRE(ours.size() == golden.size());
        int compared = 0;
        for (std::size_t column = 1; column < golden[0].size(); ++column) {
            std::string name = golden[0][column];
            while (!name.empty() && (name.back() == '\r' || name.back() == ' ')) name.pop_back();
            const auto found = std::find(ours[0].begin(), ours[0].end(), name);
            REQUIRE_MESSAGE(found != ours[0].end(), name);
            const auto index = static_cast<std::size_t>(found - ours[0].begin());
            for (std::size_t row = 1; row < golden.size(); ++row) {
                const double centimetres = std::stod(golden[row][column]);
                REQUIRE(std::abs(100.0 * std::stod(ours[row][index]) - centimetres) <
                        1.5e-4);  // printed to 1e-6 m
                ++compared;
            }
        }
        CHECK(compared > 5000);
    }

    TEST_CASE("generate writes 30 fps BVH files and a manifest row each") {
        const Scratch scratch;
        spill(scratch / "t.csv", "target_id,x,y,z\nA,1.2,1.0,1.6\nB,-1.0,0.4,1.8\n");
        for (const std::string system : {"demonstration-nn", "direct", "stiff", "drifting"}) {
            const std::string command =
                "generate " + system + " --targets " + (scratch / "t.csv") + " --out ";
            REQUIRE(program(command + (scratch / system)).status == 0);
            const auto rows = table(slurp(scratch / (system + "/manifest.csv")));
            REQUIRE(rows.size() == 3);
            CHECK(rows[0] ==
                  splitRow(
                      "clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,fps,seed"));
            for (std::size_t i = 1; i < 3; ++i) {
                CHECK(rows[i][1] == system);
                const auto frames =
                    table(program("clips joints " + (scratch / (system + "/" + rows[i][0])) + " --csv").out);
                CHECK(frames.size() > 60);
                CHECK(std::stod(frames[2][1]) == doctest::Approx(1.0 / 30.0).epsilon(1e-4));
                CHECK(std::stoul(rows[i][10]) < frames.size() - 1);
            }
            // The same seed gives the same bytes; a generator's clip does not depend on the others in the
            // list.
            REQUIRE(program(command + (scratch / (system + "-again"))).status == 0);
            CHECK(slurp(scratch / (system + "/" + rows[1][0])) ==
                  slurp(scratch / (system + "-again/" + rows[1][0])));
            CHECK_FAILS_SAYING(program(command + (scratch / system)), rows[1][0], "is there already",
                               "--force");
            CHECK(program(command + (scratch / system) + " --force").status == 0);
        }
    }
}
