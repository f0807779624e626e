#include "assets/data/demonstrations.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/files.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::assets;

namespace {

const std::filesystem::path shipped = deixis::tests::sourceDir() / "assets" / "data" / "demonstrations.toml";

std::string shippedText() {
    const auto text = readFile(shipped);
    REQUIRE(text.has_value());
    return *text;
}

/// The shipped file with the first `from` replaced.
std::string edited(const std::string& from, const std::string& to) {
    std::string text = shippedText();
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

int lineOf(const std::string& text, const std::string& part) {
    const auto begin = text.begin();
    return 1 +
           static_cast<int>(std::count(begin, begin + static_cast<std::ptrdiff_t>(text.find(part)), '\n'));
}

std::string demonstrationsError(const std::string& text) {
    const auto read = parseDemonstrationParameters(text, "d.toml");
    REQUIRE_FALSE(read.has_value());
    return read.error().text();
}

bool says(const std::string& text, const std::string& part) {
    CAPTURE(text);
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("assets/demonstrations") {
    TEST_CASE("an unknown key or section is rejected with file, line and key") {
        const std::string key = edited("raise_s = [0.65, 0.95]", "raise = [0.65, 0.95]");
        CHECK(says(demonstrationsError(key), "timing.raise_s: this key is missing"));
        const auto former =
            parseDemonstrationParameters(edited("min_reach = 0.72", "least_reach = 0.71"), "d.toml");
        REQUIRE_MESSAGE(former.has_value(), "its name in studies that were locked before");
        CHECK(former->timing.min_reach == 0.71);
        const std::string more = edited("[stiff]", "[stiff]\nspeed = 3");
        CHECK(says(demonstrationsError(more),
                   "d.toml:" + std::to_string(lineOf(more, "speed = 3")) + ": stiff.speed: unknown key"));
        const std::string section = shippedText() + "\n[moglow]\n";
        CHECK(says(demonstrationsError(section),
                   "d.toml:" + std::to_string(lineOf(section, "[moglow]")) + ": moglow: unknown key"));
    }

    TEST_CASE("values of a wrong kind or size are rejected with file, line and key") {
        const auto rejected = [](const std::string& from, const std::string& to, const std::string& key,
                                 const std::string& reason) {
            const std::string text = edited(from, to);
            const std::string where = "d.toml:" + std::to_string(lineOf(text, to)) + ": " + key + ": ";
            CHECK(says(demonstrationsError(text), where + reason));
        };
        rejected("warp = 0.9", "warp = 0.0", "timing.warp", "found 0, expected 0.2 to 5");
        rejected("warp = 0.9", "warp = nan", "timing.warp", "expected a finite number");
        rejected("warp = 0.9", "warp = \"fast\"", "timing.warp", "expected a finite number");
        rejected("hold_s = [0.7, 1.3]", "hold_s = [1.3, 0.7]", "timing.hold_s", "the first number is larger");
        rejected("hold_s = [0.7, 1.3]", "hold_s = [0.7]", "timing.hold_s", "expected a list of 2 numbers");
        rejected("hold_s = [0.7, 1.3]", "hold_s = 0.7", "timing.hold_s", "expected a list of 2 numbers");
        rejected("extension = [0.996, 0.002]", "extension = [0.996, -1.0]", "line.extension", "found -1");
        rejected("left_count = 25", "left_count = 0", "library.left_count", "found 0, expected 1 to 10000");
        rejected("left_count = 25", "left_count = 2.5", "library.left_count", "expected a whole number");
        rejected("seed = 1 ", "seed = -1 ", "library.seed", "expected a whole number, 0 or more");
    }

    TEST_CASE("a missing section or file, and broken TOML, are errors that say where") {
        CHECK(says(demonstrationsError(""), "d.toml: the section [library] is missing"));
        CHECK(says(demonstrationsError("[library\n"), "d.toml:1: this is not valid TOML"));
        CHECK(says(demonstrationsError("library = 3\n"), "library"));
        const auto read = loadDemonstrationParameters("no/such.toml");
        REQUIRE_FALSE(read.has_value());
        CHECK(says(read.error().text(), "no/such.toml"));
    }

    TEST_CASE("the shipped file reads, and every value in it is marked with where it comes from") {
        const auto read = loadDemonstrationParameters(shipped);
        REQUIRE(read.has_value());
        std::istringstream lines(shippedText());
        int values = 0;
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line[0] == '#' || line[0] == '[' || line.find(" = ") == std::string::npos)
                continue;
            if (line.find_first_not_of(' ') != 0) continue;
            ++values;
            CAPTURE(line);
            const std::size_t mark = line.find("# [");
            REQUIRE(mark != std::string::npos);
            CHECK(std::string("MSDKA").find(line[mark + 3]) != std::string::npos);
        }
        CHECK(values > 60);
    }

    TEST_CASE("the shipped values are those that the code has without a file") {
        const auto read = loadDemonstrationParameters(shipped);
        REQUIRE(read.has_value());
        const motion::DemonstrationParameters own;
        CHECK(read->library_seed == own.library_seed);
        CHECK(read->left_count == 25);
        CHECK(read->right_count == 27);
        CHECK(read->targets.azimuth_deg.high == own.targets.azimuth_deg.high);
        CHECK(read->targets.height_m.high == own.targets.height_m.high);
        CHECK(read->line.origin_k == own.line.origin_k);
        CHECK(read->line.extension.sd == own.line.extension.sd);
        CHECK(read->line.index_alignment == own.line.index_alignment);
        CHECK(read->line.palm_inward_deg.mean == own.line.palm_inward_deg.mean);
        CHECK(read->arm.upper_arm_elevation == own.arm.upper_arm_elevation);
        CHECK(read->arm.forearm_elevation == own.arm.forearm_elevation);
        CHECK(read->arm.upper_arm_yaw == own.arm.upper_arm_yaw);
        CHECK(read->arm.forearm_yaw == own.arm.forearm_yaw);
        CHECK(read->body.torso_yaw_share == own.body.torso_yaw_share);
        CHECK(read->body.eye_limit_deg == own.body.eye_limit_deg);
        CHECK(read->body.gaze_shift_s == own.body.gaze_shift_s);
        CHECK(read->timing.raise_s.low == own.timing.raise_s.low);
        CHECK(read->timing.min_reach == own.timing.min_reach);
        CHECK(read->noise.ou_step_rad == own.noise.ou_step_rad);
        CHECK(read->noise.breathing_hz.high == own.noise.breathing_hz.high);
        CHECK(read->direct.extension == own.direct.extension);
        CHECK(read->stiff.raise_s == own.stiff.raise_s);
        CHECK(read->drifting.pull.low == own.drifting.pull.low);
        CHECK(read->drifting.jitter_rad == own.drifting.jitter_rad);
        CHECK(read->drifting.noise_share == own.drifting.noise_share);
    }
}
