// Who gets which number, groups and plan, also where several stations enrol at once.
#include "app/study/enrolment.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

app::StudySetup setupOf(const char* study) {
    auto setup = app::loadStudySetup(study);
    REQUIRE(setup);
    return std::move(*setup);
}

results::Store openStore(const std::string& path) {
    auto store = results::Store::open(path, results::Durability::each_answer);
    REQUIRE(store);
    return std::move(*store);
}

app::Enrolment enrolled(const app::StudySetup& setup, const results::Store& store, const std::string& who,
                        std::optional<int> number = {}) {
    auto enrolment = app::enrol(setup, store, who, number, 0.0);
    REQUIRE(enrolment);
    return std::move(*enrolment);
}

}  // namespace

TEST_SUITE("app/enrolment") {
    TEST_CASE("Participants who enrol one after another have the plans that `deixis plan` prints") {
        const Scratch scratch;
        const app::StudySetup setup = setupOf("distractor-distance");
        results::Store store = openStore(scratch / "a.sqlite");
        for (int number = 1; number <= 6; ++number) {
            const std::string who = fmt::format("S{:03}", number);
            const auto enrolment = enrolled(setup, store, who);
            REQUIRE(store.storePlan(setup.study, enrolment.registration, enrolment.plan));
            const studies::Assignment turn = studies::assignmentOf(setup.study, number);
            const auto plan =
                studies::buildPlan(setup.study, setup.targets, who, number, turn.groups, turn.number_in_cell);
            REQUIRE(plan);
            CHECK(studies::planJson(*plan) == studies::planJson(enrolment.plan));
            CHECK(studies::planJson(*store.plan(who)) == studies::planJson(enrolment.plan));
        }
    }

    TEST_CASE("Two stations that enrol at once get numbers and places in the cell of their own") {
        const Scratch scratch;
        const app::StudySetup setup = setupOf("distractor-distance");
        results::Store one = openStore(scratch / "a.sqlite");
        results::Store other = openStore(scratch / "a.sqlite");
        auto anna = enrolled(setup, one, "anna");
        auto bob = enrolled(setup, other, "bob");
        CHECK(anna.registration.number == bob.registration.number);
        const auto first = app::storeEnrolment(setup, "", one, anna, {}, 0.0);
        REQUIRE(first);
        CHECK_FALSE(*first);
        const auto second = app::storeEnrolment(setup, "", other, bob, {}, 0.0);
        REQUIRE_MESSAGE(second, second.error().text());
        CHECK(*second);
        CHECK(anna.registration.number == 1);
        CHECK(bob.registration.number == 2);
        CHECK(bob.registration.groups != anna.registration.groups);
        CHECK(bob.plan.number_in_cell == 1);
        CHECK(one.registration("bob")->number == 2);
        CHECK(studies::planJson(*one.plan("bob")) == studies::planJson(bob.plan));
    }

    TEST_CASE("A number that is asked for is given, unless it is somebody else's") {
        const Scratch scratch;
        const app::StudySetup setup = setupOf("pointing2023");
        results::Store store = openStore(scratch / "a.sqlite");
        auto anna = enrolled(setup, store, "anna", 101);
        CHECK(anna.registration.number == 101);
        CHECK_FALSE(anna.plan.number_in_cell.has_value());
        REQUIRE(app::storeEnrolment(setup, "", store, anna, 101, 0.0));
        CHECK(enrolled(setup, store, "anna", 101).registration.number == 101);
        const auto taken = app::enrol(setup, store, "bob", 101, 0.0);
        REQUIRE_FALSE(taken);
        CHECK(contains(taken.error().text(), "--number: 101 is the number of another participant"));
        const auto other = app::enrol(setup, store, "anna", 7, 0.0);
        REQUIRE_FALSE(other);
        CHECK(contains(other.error().text(), "anna takes part with the number 101"));
        // Asked for while free, taken in the meantime by another station.
        auto carla = enrolled(setup, store, "carla", 102);
        results::Store station = openStore(scratch / "a.sqlite");
        auto dora = enrolled(setup, station, "dora", 102);
        REQUIRE(app::storeEnrolment(setup, "", station, dora, 102, 0.0));
        const auto late = app::storeEnrolment(setup, "", store, carla, 102, 0.0);
        REQUIRE_FALSE(late);
        CHECK(contains(late.error().text(), "102"));
        CHECK_FALSE(store.registration("carla").has_value());
    }
}
