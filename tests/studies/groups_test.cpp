#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plan_fixture.hpp"
#include "studies/design/plan.hpp"

using namespace deixis::studies;

namespace {

Study twoFactors() {
    Study study;
    study.seed = 7;
    study.between = {{"measure", {"likeness", "fit"}}, {"speed", {"slow", "normal", "fast"}}};
    return study;
}

}  // namespace

TEST_SUITE("studies/groups") {
    TEST_CASE("The number is the digits at the end of an id.") {
        CHECK(numberOfParticipant("P07") == 7);
        CHECK(numberOfParticipant("P10") == 10);
        CHECK(numberOfParticipant("a1b-000123") == 123);
        CHECK(numberOfParticipant("42") == 42);
        CHECK(numberOfParticipant("x999999") == 999999);
        for (const char* id : {"", "P", "7P", "P0", "P000000", "P1000000", "P0000001", "P1_"})
            CHECK_MESSAGE(!numberOfParticipant(id), id);
    }

    TEST_CASE("Ids are 1 to 32 letters, digits, underscores and hyphens.") {
        for (const std::string& good : {std::string("P01"), std::string("a_b-C9"), std::string(32, 'a')})
            CHECK(validParticipant(good));
        for (const std::string& bad :
             {std::string(), std::string("P 01"), std::string("../P01"), std::string(33, 'a'),
              std::string("P\0", 2), std::string("Zo\xc3\xab")})
            CHECK_FALSE(validParticipant(bad));
    }

    TEST_CASE("Participants who come one after another fill the cells evenly.") {
        const Study study = twoFactors();
        GroupSizes filled;
        for (int number = 1; number <= 600; ++number) {
            const Groups groups = assignGroups(study, filled, number);
            REQUIRE(groups.size() == 2);
            ++filled[groups];
            int max = 0;
            int min = number;
            for (const auto& cell : filled) {
                max = std::max(max, cell.second);
                min = std::min(min, cell.second);
            }
            if (filled.size() < 6) min = 0;
            CHECK(max - min <= 1);
        }
        CHECK(filled.size() == 6);
        for (const auto& cell : filled) CHECK(cell.second == 100);
    }

    TEST_CASE("Where somebody drops out, the next participant gets that cell.") {
        const Study study = twoFactors();
        std::vector<Groups> counted;
        GroupSizes all;
        for (int number = 1; number <= 30; ++number) {
            counted.push_back(assignGroups(study, all, number));
            ++all[counted.back()];
        }
        for (const Groups& dropped : counted) {
            GroupSizes left = all;
            --left[dropped];
            CHECK(assignGroups(study, left, 31) == dropped);
        }
    }

    TEST_CASE("Among equals chance decides, by seed and number alone.") {
        Study study = twoFactors();
        study.between.pop_back();
        int likeness = 0;
        int same_with_another_seed = 0;
        for (int number = 1; number <= 1000; ++number) {
            const Groups groups = assignGroups(study, {}, number);
            CHECK(groups == assignGroups(study, {}, number));
            likeness += groups.at("measure") == "likeness";
            Study other = study;
            other.seed = 8;
            same_with_another_seed += assignGroups(other, {}, number) == groups;
        }
        CHECK(std::abs(likeness - 500) < 64);  // four standard deviations of a fair coin
        CHECK(std::abs(same_with_another_seed - 500) < 64);
    }

    TEST_CASE("A study without factors between participants has no groups.") {
        CHECK(assignGroups(Study{}, {{{}, 2}}, 3).empty());
    }
}
