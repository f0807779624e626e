#include "studies/design/target_grid.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "csv_table.hpp"

using namespace deixis;
using namespace deixis::studies;

TEST_SUITE("studies/target_grid") {
    TEST_CASE("A grid spans the limits of the training targets, ends included, evenly on each axis") {
        const auto grid = targetGrid({{-1.0, 0.5, 2.0}, {2.0, 0.2, 0.5}, {0.3, 1.4, 1.0}}, 27);
        REQUIRE(grid);
        REQUIRE(grid->size() == 27);
        CHECK(grid->front().id == "G0001");
        CHECK(grid->back().id == "G0027");
        CHECK(grid->front().target == Vec3(-1.0, 0.2, 0.5));
        CHECK((*grid)[1].target == Vec3(0.5, 0.2, 0.5));
        CHECK((*grid)[3].target == Vec3(-1.0, 0.8, 0.5));
        CHECK((*grid)[9].target == Vec3(-1.0, 0.2, 1.25));
        CHECK(grid->back().target == Vec3(2.0, 1.4, 2.0));
    }

    TEST_CASE("The paper's thousand points are ten along each axis") {
        const auto grid = targetGrid({{-2.0, 0.0, 0.1}, {2.0, 2.2, 2.2}}, 1000);
        REQUIRE(grid);
        for (int axis = 0; axis < 3; ++axis) {
            std::set<double> places;
            for (const auto& item : *grid) places.insert(item.target[axis]);
            CHECK(places.size() == 10);
        }
        const deixis::tests::CsvTable table(targetsCsv(*grid, {}));
        REQUIRE(table.rows.size() == 1000);
        CHECK(table.has({{"target_id", "G1000"}, {"x", "2.0000"}, {"y", "2.2000"}, {"z", "2.2000"}}));
    }

    // Seen from (0, 1, 0), their mean height: straight ahead at 2 m; to the left (+x) at 1 m, both level.
    TEST_CASE("A spherical grid spans the limits of azimuth, elevation and distance") {
        const auto grid = targetGrid({{0.0, 1.0, 2.0}, {1.0, 1.0, 0.0}}, 27, GridShape::spherical);
        REQUIRE(grid);
        REQUIRE(grid->size() == 27);
        const double half = 0.7071;  // of 1 m, at 45 degrees
        CHECK(grid->front().target == Vec3(0.0, 1.0, 1.0));
        CHECK((*grid)[1].target == Vec3(half, 1.0, half));
        CHECK((*grid)[2].target == Vec3(1.0, 1.0, 0.0));
        CHECK((*grid)[3].target == Vec3(0.0, 1.0, 1.0));  // elevations are all the same
        CHECK((*grid)[9].target == Vec3(0.0, 1.0, 1.5));
        CHECK(grid->back().target == Vec3(2.0, 1.0, 0.0));
        // 30 degrees up at 2 m, and down by a quarter of 4 m.
        const double level = std::sqrt(3.0);
        const auto heights =
            targetGrid({{level, 2.0, 0.0}, {0.0, 0.0, 2.0 * std::sqrt(3.75)}}, 8, GridShape::spherical);
        REQUIRE(heights);
        CHECK(heights->front().target.y == doctest::Approx(1.0 - 2.0 * 0.25).epsilon(1e-3));
        CHECK((*heights)[2].target.y == doctest::Approx(2.0).epsilon(1e-3));
        CHECK(heights->back().target.y == doctest::Approx(3.0).epsilon(1e-3));
    }

    TEST_CASE("A number that is no third power is rejected with the nearest that are") {
        const auto grid = targetGrid({{0, 0, 0}, {1, 1, 1}}, 900);
        REQUIRE_FALSE(grid);
        CHECK(grid.error().text().find("729 or 1000") != std::string::npos);
        CHECK(targetGrid({{0, 0, 0}}, 1100).error().text().find("1000 or 1331") != std::string::npos);
        CHECK(targetGrid({{0, 0, 0}}, 1).error().text().find("8 or 27") != std::string::npos);
        CHECK_FALSE(targetGrid({{0, 0, 0}}, -8));
        CHECK_FALSE(targetGrid({}, 8));
    }
}
