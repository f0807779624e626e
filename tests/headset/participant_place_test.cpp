#include "participant_place.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace deixis;
using namespace deixis::app;

namespace {

// A head at this place, looking `yaw_deg` to the left of -z, and down a little.
Pose headAt(double x_m, double z_m, double yaw_deg) {
    return {{x_m, 1.6, z_m},
            yawRotation(radiansFromDegrees(yaw_deg)) *
                glm::angleAxis(radiansFromDegrees(-10.0), Vec3(1.0, 0.0, 0.0))};
}

const Pose across{{0.0, 0.0, 3.4}, no_rotation};  // looks along -z, at the avatar
const Pose beside{{-0.6, 0.0, -0.95}, yawRotation(pi)};

// The head stays there for as long as it takes to be taken for the place.
void settle(ParticipantPlace& place, const Pose& head, double from_s) {
    for (int i = 0; i <= 11; ++i) place.update(head, from_s + 0.1 * i);
}

void checkNear(const Vec3& found, const Vec3& wanted) {
    CHECK(glm::length(found - wanted) < 1e-9);
}

}  // namespace

TEST_SUITE("headset/participant_place") {
    TEST_CASE("the first head that is known takes the layout's place, whichever way it looks in the room") {
        ParticipantPlace place(studies::EyeLevel::measured, 1.65);
        place.stand(across, 1.0);
        CHECK_FALSE(place.known());
        place.update(std::nullopt, 1.1);
        CHECK_FALSE(place.known());
        const Pose head = headAt(5.0, -2.0, 70.0);
        place.update(head, 1.2);
        place.update(head, 2.1);
        CHECK_FALSE(place.known());
        place.update(head, 2.3);
        REQUIRE(place.known());
        const Pose stage_from_head = place.placement().toStage(head);
        checkNear(stage_from_head.position, {0.0, 1.6, 3.4});
        const Vec3 looking = stage_from_head.orientation * Vec3(0.0, 0.0, -1.0);
        CHECK(looking.x == doctest::Approx(0.0).epsilon(1e-9));
        CHECK(looking.z < -0.9);
        CHECK(place.offPlace_m(head) == doctest::Approx(0.0));
    }

    TEST_CASE("a change of layout turns the stage under the same physical place") {
        ParticipantPlace place(studies::EyeLevel::measured, 1.65);
        place.stand(across, 0.0);
        settle(place, headAt(1.0, 1.0, 30.0), 0.1);
        place.stand(beside, 5.0);
        // The person has taken a step of 20 cm to the right in the room meanwhile: no new anchor is taken.
        const Vec3 right = yawRotation(radiansFromDegrees(30.0)) * Vec3(0.2, 0.0, 0.0);
        Pose stepped = headAt(1.0, 1.0, 30.0);
        stepped.position += right;
        place.update(stepped, 5.1);
        CHECK(place.offPlace_m(stepped) == doctest::Approx(0.2));
        // Facing +z, to the right is -x.
        checkNear(place.placement().toStage(stepped).position, {-0.8, 1.6, -0.95});
    }

    TEST_CASE("recentring takes the present place and says who asked for it") {
        ParticipantPlace place(studies::EyeLevel::measured, 1.65);
        place.stand(across, 0.0);
        settle(place, headAt(0.0, 0.0, 0.0), 0.1);
        (void)place.takeNotes();
        const Pose moved = headAt(0.5, 0.5, 90.0);
        place.recentre("button");
        place.update(std::nullopt, 1.0);  // not while the head is unknown
        CHECK(place.takeNotes().empty());
        place.update(moved, 1.5);
        CHECK(place.offPlace_m(moved) == doctest::Approx(0.0));
        checkNear(place.placement().toStage(moved).position, {0.0, 1.6, 3.4});
        const auto notes = place.takeNotes();
        REQUIRE(notes.size() == 2);
        CHECK(notes[0].kind == studies::NoteKind::recentre);
        CHECK(notes[0].detail == "button");
        CHECK(notes[0].time_s == 1.5);
        CHECK(notes[1].kind == studies::NoteKind::placement);
        CHECK(place.takeNotes().empty());
        place.update(headAt(0.7, 0.5, 90.0), 2.0);
        CHECK(place.offPlace_m(headAt(0.7, 0.5, 90.0)) == doctest::Approx(0.2));
    }

    TEST_CASE("a headset that is being put on, or lies on a table, is no place") {
        ParticipantPlace place(studies::EyeLevel::measured, 1.65);
        place.stand(across, 0.0);
        double now_s = 0.0;
        for (int i = 0; i < 40; ++i) place.update(headAt(0.05 * i, 0.0, 0.0), now_s += 0.1);
        for (int i = 0; i < 40; ++i) place.update(headAt(2.0, 0.0, 25.0 * i), now_s += 0.1);
        CHECK_FALSE(place.known());
        place.update(std::nullopt, now_s);
        Pose table = headAt(1.0, 1.0, 0.0);
        table.position.y = 0.75;
        for (int i = 0; i < 300; ++i) place.update(table, now_s += 0.1);
        CHECK_FALSE(place.known());
        settle(place, headAt(0.3, 0.4, 10.0), now_s);
        REQUIRE(place.known());
        CHECK(place.offPlace_m(headAt(0.3, 0.4, 0.0)) == doctest::Approx(0.0));
    }

    TEST_CASE("who never stands still is placed after 10 s; the operator may do it at once, at any height") {
        ParticipantPlace restless(studies::EyeLevel::measured, 1.65);
        for (int i = 0; i <= 99; ++i) restless.update(headAt(0.1 * (i % 2), 0.0, 0.0), 0.1 * i);
        CHECK_FALSE(restless.known());
        restless.update(headAt(0.0, 0.0, 0.0), 10.05);
        CHECK(restless.known());

        ParticipantPlace low(studies::EyeLevel::measured, 1.65);
        Pose on_the_floor = headAt(0.0, 0.0, 0.0);
        on_the_floor.position.y = 0.7;
        low.recentre("operator");
        low.update(on_the_floor, 0.1);
        CHECK(low.known());
        CHECK(low.takeNotes().size() == 1);
    }

    TEST_CASE("the placement is noted once for each change, not each frame") {
        ParticipantPlace place(studies::EyeLevel::measured, 1.65);
        for (int i = 0; i < 5; ++i) {
            place.stand(across, i);
            place.update(headAt(0.0, 0.0, 0.0), 0.5 * i);
        }
        CHECK(place.takeNotes().size() == 1);
        place.stand(beside, 9.0);
        place.stand(beside, 10.0);
        CHECK(place.takeNotes().size() == 1);
    }
}
