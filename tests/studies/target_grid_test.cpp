#include "studies/design/target_grid.hpp"

#include <doctest/doctest.h>

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
