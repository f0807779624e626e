#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

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

}  // namespace

TEST_SUITE("app/clips-motion") {
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
        CHECK(plain.out.find("peak_speed_mps") != std::string::npos);
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

    TEST_CASE("statistics of a set of clips, and its distance to itself and to another") {
        const Scratch scratch;
        makeClips(scratch, "direct");
        makeClips(scratch, "stiff");
        const std::string direct = scratch / "direct/manifest.csv";
        const auto same = program("clips statistics " + direct + " --against " + direct);
        INFO(same.err);
        REQUIRE(same.status == 0);
        CHECK(same.out.find("2 clips at 30 frames a second, 8 joints") != std::string::npos);
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
