#include "assets/tables/ball_list.hpp"

#include <doctest/doctest.h>

using deixis::Vec3;
using deixis::assets::parseBallList;

TEST_SUITE("assets/ball_list") {
    TEST_CASE("targets come with the distractors of each distance, those that a line lacks left out") {
        const auto list = parseBallList(
            "target_id,near_d1_z,near_d1_y,near_d1_x,x,y,z,far_d1_x,far_d1_y,far_d1_z,far_d2_x,far_d2_y,far_"
            "d2_z,mad_x\n"
            "A,3,2,1,0,0,1,4,5,6,7,8,9,\nB,3,2,1,0,0,2,4,5,6,,,,odd\n",
            "b.csv");
        REQUIRE_MESSAGE(list.has_value(), (list ? std::string() : list.error().text()));
        REQUIRE(list->size() == 2);
        const auto& a = list->at("A");
        REQUIRE(a.size() == 2);
        CHECK(a[0].band == "near");
        CHECK(a[0].balls == std::vector<Vec3>{{0, 0, 1}, {1, 2, 3}});
        CHECK(a[1].band == "far");
        CHECK(a[1].balls == std::vector<Vec3>{{0, 0, 1}, {4, 5, 6}, {7, 8, 9}});
        CHECK(a[1].names == std::vector<std::string>{"target", "d1", "d2"});
        CHECK(list->at("B")[1].names == std::vector<std::string>{"target", "d1"});
        const auto single = parseBallList("target_id,x,y,z,d1_x,d1_y,d1_z\nA,0,0,1,1,2,3\n", "b.csv");
        REQUIRE(single.has_value());
        CHECK(single->at("A")[0].band.empty());
    }

    TEST_CASE("what is wrong with a list of balls is named with file, line and column") {
        const auto message = [](const char* text) {
            const auto list = parseBallList(text, "b.csv");
            return list ? std::string("accepted") : list.error().text();
        };
        CHECK(message("target_id,x,y,z\nA,1,2,3\n").find("b.csv:1: no distractors") == 0);
        CHECK(message("target_id,x,y,z,d1_x,d1_y\nA,1,2,3,4,5\n")
                  .find("b.csv:1: the column 'd1_z' is missing") == 0);
        CHECK(message("target_id,x,y,z,d1_x,d1_y,d1_z\nA,1,2,3,4,,6\n").find("b.csv:2: d1_y: found ''") == 0);
        CHECK(
            message("target_id,x,y,z,d1_x,d1_y,d1_z\nA,1,2,3,4,inf,6\n").find("b.csv:2: d1_y: found 'inf'") ==
            0);
        CHECK(message("target_id,x,y,z,d1_x,d1_y,d1_z\nA,1,2,,4,5,6\n").find("b.csv:2: z: found ''") == 0);
    }
}
