// Balls far away are chosen, balls behind the walls are told by check, and a simulation that gets nowhere
// ends.
#include "program.hpp"

using namespace deixis::tests;

namespace {

/// Balls all around the avatar, seen from the far end of the room: up to 7.5 m away. `stage` is added.
std::string study(const std::string& radius_m, const std::string& stage, const std::string& inter_trial_s) {
    return R"([study]
name = "reach"
title = "Reach"
seed = 3
inter_trial_s = )" +
           inter_trial_s + R"(
[targets]
count = 12
height_m = [0.4, 1.9]
arc_deg = [-175.0, 175.0]
radius_m = )" +
           radius_m + R"(
[[distances]]
name = "near"
distance_m = [0.2, 0.4]
distractors = 2
[[layouts]]
name = "across"
viewer_m = [0.0, 5.2]
heading_deg = 180.0
[[systems]]
name = "direct"
generator = "direct"
[[systems]]
name = "stiff"
generator = "stiff"
[[systems]]
name = "drifting"
generator = "drifting"
)" + stage;
}

constexpr const char* game = R"([[stages]]
name = "choices"
kind = "referential-game"
layouts = ["across"]
distances = ["near"]
items = 12
question = "Which ball?"
)";

constexpr const char* page = R"([[stages]]
name = "pages"
kind = "parallel-rating"
layouts = ["across"]
measure = "naturalness"
items = 1
plays = 10
question = "How natural?"
scale = {kind = "slider", low = 0, high = 100}
)";

}  // namespace

TEST_SUITE("app/reach") {
    TEST_CASE("balls more than five metres away are chosen as those near by") {
        const Scratch scratch;
        spill(scratch / "reach.toml", study("[1.9, 2.2]", game, "0.5"));
        const auto checked = program("check " + (scratch / "reach.toml"));
        REQUIRE_MESSAGE(checked.status == 0, checked.err);
        const auto ran = program("simulate " + (scratch / "reach.toml") + " --participants 2 --db " +
                                 (scratch / "s.sqlite"));
        INFO(ran.err);
        REQUIRE(ran.status == 0);
        CHECK(ran.out.find("72 trials and pages answered") != std::string::npos);
        const auto far = shell("sqlite3 -readonly " + (scratch / "s.sqlite") +
                               " 'select count(*) from trials where target_z_m < 0.2'");
        CHECK_MESSAGE(std::stoi(far.out) > 4, far.out);
    }

    TEST_CASE("balls that the room's walls hide are told by check, and no session begins") {
        const Scratch scratch;
        spill(scratch / "far.toml", study("[3.0, 6.0]", game, "0.5"));
        CHECK_FAILS_SAYING(program("simulate " + (scratch / "far.toml") + " --participants 1 --db " +
                                   (scratch / "s.sqlite")),
                           "far.toml: targets", "outside the room", "radius_m");
        const auto checked = program("check " + (scratch / "far.toml"));
        CHECK(checked.status == 1);
        CHECK(checked.err.find("outside the room") != std::string::npos);
        CHECK_FALSE(fs::exists(scratch / "s.sqlite"));
    }

    TEST_CASE(
        "a simulated trial that stays open for half an hour ends with one message, and leaves nothing") {
        const Scratch scratch;
        spill(scratch / "slow.toml", study("[1.9, 2.2]", page, "60.0"));
        CHECK_FAILS_SAYING(program("simulate " + (scratch / "slow.toml") + " --participants 2 --db " +
                                   (scratch / "s.sqlite")),
                           ": S001", "stage \"pages\"", "30 minutes of virtual time", "waiting for");
        CHECK_FALSE(fs::exists(scratch / "s.sqlite"));
        CHECK_FALSE(fs::exists(scratch / "s.sqlite.partial"));
    }
}
