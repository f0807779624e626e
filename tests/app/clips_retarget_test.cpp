// deixis clips retarget: pointing clips on the program's avatar and on others.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "program.hpp"

using namespace deixis::tests;

namespace {

const char* const retarget_targets =
    "target_id,x,y,z\n"
    "T001,-1.2,1.3,1.6\nT002,0.9,0.6,1.8\nT003,0.1,1.9,2.2\nT004,-0.4,0.9,0.9\nT005,2.4,1.2,-0.3\n"
    "T006,-0.69,0.9,0.12\n";  // within arms' reach

/// A manifest of pointing clips by a built-in system.
std::string pointingClips(const Scratch& scratch, const std::string& system) {
    spill(scratch / "targets.csv", retarget_targets);
    const auto made = program("generate " + system + " --targets " + (scratch / "targets.csv") + " --out " +
                              (scratch / system));
    INFO(made.err);
    REQUIRE(made.status == 0);
    return scratch / (system + "/manifest.csv");
}

/// Cells of a manifest's column, from the first clip on.
std::vector<std::string> column(const std::string& csv, const std::string& name) {
    std::istringstream lines(csv);
    std::vector<std::string> cells;
    std::size_t at = 0;
    bool header = true;
    for (std::string line; std::getline(lines, line); header = false) {
        std::istringstream in(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(in, cell, ',');) row.push_back(cell);
        if (header)
            at = static_cast<std::size_t>(std::find(row.begin(), row.end(), name) - row.begin());
        else
            cells.push_back(at < row.size() ? row[at] : "");
    }
    return cells;
}

}  // namespace

TEST_SUITE("app/clips-retarget") {
    TEST_CASE("with the pointing ray kept, other figures miss the targets by as much as the clips do") {
        const std::filesystem::path figures = sharedData("avatars");
        for (const std::string system : {"direct", "demonstration-nn"}) {
            const Scratch scratch;
            const std::string manifest = pointingClips(scratch, system);
            std::vector<std::string> recorded;  // the source's errors, from the first figure on
            for (const char* figure :
                 {"", "quaternius/modular_men_Casual.glb", "quaternius/modular_women_Formal.glb",
                  "kaykit_mannequin/manny_med_mod.gltf",
                  "vrm/VRMC_vrm_expressions_isBinary_Overridden.vrm"}) {
                auto file = figures / figure;
                CAPTURE(file.string());
                const bool own = std::string(figure).empty();
                if (!own && !std::filesystem::exists(file)) {
                    tellSkipped(file.string() + " is not here");
                    continue;
                }
                if (std::string(figure).starts_with("kaykit")) {  // 2.21 m tall
                    std::filesystem::copy(file.parent_path(), scratch / "kaykit");
                    file = std::filesystem::path(scratch / "kaykit") / file.filename();
                    spill(std::filesystem::path(file).replace_extension(".humanoid.toml"),
                          "height_m = 1.8\n");
                }
                const std::string folder = scratch / (own ? "own" : file.stem().string());
                const auto done = program("clips retarget " + manifest + " --out " + folder +
                                          " --keep pointing-ray" + (own ? "" : " --avatar " + file.string()));
                INFO(done.err);
                REQUIRE(done.status == 0);
                const std::string csv = slurp(folder + "/manifest.csv");
                const auto source = column(csv, "source_error_deg");
                const auto avatar = column(csv, "avatar_error_deg");
                REQUIRE(source.size() == 6);
                REQUIRE(avatar.size() == 6);
                double apart = 0.0;
                for (std::size_t i = 0; i < source.size(); ++i)
                    apart = std::max(apart, std::abs(std::stod(source[i]) - std::stod(avatar[i])));
                CHECK(apart < 2.0);
                // What the clip itself misses by does not hang on the figure.
                if (recorded.empty()) recorded = source;
                for (std::size_t i = 0; i < source.size(); ++i)
                    CHECK(std::abs(std::stod(source[i]) - std::stod(recorded[i])) < 0.01);
                CHECK(done.out.find("deg apart") != std::string::npos);
            }
        }
    }

    TEST_CASE("a gesture that ends after its clip is rejected, on the program's own avatar too") {
        const Scratch scratch;
        const std::string manifest = pointingClips(scratch, "direct");
        const std::string csv = slurp(manifest);
        const std::string end = column(csv, "end").front();
        spill(manifest, replaced(csv, "," + end + ",", ",9999,"));
        const auto rejected = program("clips retarget " + manifest + " --out " + (scratch / "out"));
        CHECK_FAILS_SAYING(rejected, "direct_T001.bvh", "end 9999", "in a clip of 104 frames");
        CHECK(!std::filesystem::exists(scratch / "out"));  // not half a folder
    }
}
