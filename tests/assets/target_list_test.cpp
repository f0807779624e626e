#include "assets/tables/target_list.hpp"

#include <doctest/doctest.h>

using deixis::assets::parseTargetList;

TEST_SUITE("assets/target_list") {
    TEST_CASE("what is wrong with a list of targets is named with file, line and column") {
        const auto message = [](const char* text) {
            const auto list = parseTargetList(text, "t.csv");
            return list ? std::string("accepted") : list.error().text();
        };
        CHECK(message("").find("t.csv: has no targets") == 0);
        CHECK(message("target_id,x,y,z\n").find("t.csv: has no targets") == 0);
        CHECK(message("target_id,x,y\nA,1,2\n").find("t.csv:1: the column 'z' is missing") == 0);
        CHECK(message("target_id,x,y,z\nA,1,2\n").find("t.csv:2: found 3 fields, expected 4") == 0);
        CHECK(message("target_id,x,y,z\nA,1,two,3\n").find("t.csv:2: y: found 'two'") == 0);
        CHECK(message("target_id,x,y,z\nA,1,2,nan\n").find("t.csv:2: z: found 'nan'") == 0);
        CHECK(message("target_id,x,y,z\nA,1,2,-1e155\n").find("t.csv:2: z: found '-1e155'") == 0);
        CHECK(message("target_id,x,y,z\n../A,1,2,3\n").find("t.csv:2: target_id: found '../A'") == 0);
        CHECK(message("target_id,x,y,z\nA,1,2,3\nA,1,2,3\n")
                  .find("t.csv:3: target_id: 'A' was already given") == 0);
    }

    TEST_CASE("columns are found by name and others are passed over") {
        const auto list = parseTargetList("note,z,target_id,y,x\r\nhigh,3,A-1,2.5,-1\r\n", "t.csv");
        REQUIRE(list);
        REQUIRE(list->size() == 1);
        CHECK(list->front().id == "A-1");
        CHECK(list->front().position == deixis::Vec3(-1, 2.5, 3));
    }
}
