// The table "How accurate they are" of docs/systems.md, so that what is published stays true.
#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "core/files.hpp"
#include "paths.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
}

struct Row {
    std::string system;
    double eye = 0.0, eye_90 = 0.0, index = 0.0, arm = 0.0, forearm = 0.0;
};

/// As the page has them, of every system.
std::vector<Row> documented() {
    std::istringstream page(readFile(sourceDir() / "docs/systems.md").value());
    std::vector<Row> out;
    bool here = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) here = line == "## How accurate they are";
        std::array<char, 64> system{};
        Row row;
        if (here &&
            std::sscanf(line.c_str(),
                        "| `%63[^`]` | %lf\u00b0 | %lf\u00b0 | %lf\u00b0 | %lf\u00b0 | %lf\u00b0 |",
                        system.data(), &row.eye, &row.eye_90, &row.index, &row.arm, &row.forearm) == 6) {
            row.system = system.data();
            out.push_back(row);
        }
    }
    REQUIRE(out.size() == generatorNames().size());
    return out;
}

}  // namespace

TEST_SUITE("motion/system_accuracy") {
    TEST_CASE("the systems are as accurate as their page says") {
        for (const Row& row : documented()) {
            CAPTURE(row.system);
            const auto generator = makeGenerator(row.system, referenceHumanoid(), {});
            REQUIRE(generator.has_value());
            std::vector<double> eye, index, arm, forearm;
            std::uint64_t seed = 1;
            for (const Vec3& target : drawTargets(400, 2024)) {
                const GeneratedClip made = (*generator)->generate({"T", target, seed++});
                eye.push_back(errorDeg(made, target));
                index.push_back(errorDeg(made, target, PointingRay::index_finger));
                forearm.push_back(errorDeg(made, target, PointingRay::forearm));
                arm.push_back(errorDeg(made, target, PointingRay::elbow_fingertip));
            }
            CHECK(std::abs(quantile(eye, 0.5) - row.eye) < 0.1);
            CHECK(std::abs(quantile(eye, 0.9) - row.eye_90) < 0.1);
            CHECK(std::abs(quantile(index, 0.5) - row.index) < 0.1);
            CHECK(std::abs(quantile(forearm, 0.5) - row.forearm) < 0.1);
            CHECK(std::abs(quantile(arm, 0.5) - row.arm) < 0.1);
        }
    }
}
