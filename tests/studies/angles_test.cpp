// How far distractors look from their target: measured, kept in plans, and limited where a study says so.
#include "studies/design/angles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "paths.hpp"
#include "studies/design/plan.hpp"
#include "studies/design/targets.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

const std::filesystem::path data = deixis::tests::sourceDir() / "assets/data";

Study shippedPointing() {
    const auto study =
        loadStudy(data / "studies/pointing2023.toml", {data / "languages", data / "questionnaires"});
    REQUIRE(study.has_value());
    return *study;
}

double length(double x, double y, double z) {
    return std::sqrt(x * x + y * y + z * z);
}

/// By the law of cosines, which the program does not use.
double byCosines_deg(const Vec3& eye, const Vec3& a, const Vec3& b) {
    const double to_a = length(a.x - eye.x, a.y - eye.y, a.z - eye.z);
    const double to_b = length(b.x - eye.x, b.y - eye.y, b.z - eye.z);
    const double apart = length(a.x - b.x, a.y - b.y, a.z - b.z);
    return std::acos((to_a * to_a + to_b * to_b - apart * apart) / (2 * to_a * to_b)) * 180.0 /
           3.14159265358979;
}

double smallestAngle(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

}  // namespace

TEST_SUITE("studies/angles") {
    TEST_CASE("Angles worked by hand.") {
        CHECK(angleSeen_deg({0, 0, 0}, {1, 0, 0}, {2, 2, 0}) == 45.0);
        CHECK(angleSeen_deg({0, 1.65, 3.4}, {0, 1.65, 1.4}, {0, 1.65, 1.1}) == 0.0);  // one behind the other
        CHECK(angleSeen_deg({0, 0, 0}, {0, 0, 1}, {0, 0, -3}) == 180.0);
        CHECK(angleSeen_deg({0, 0, 0}, {0, 0, 10}, {0, 0.01, 10}) == 0.06);  // 0.0573 degrees
        CHECK(angleSeen_deg({1, 1, 1}, {1, 1, 2}, {1, std::sqrt(3.0) + 1, 2}) == 60.0);
    }

    TEST_CASE("The plan keeps the angles of each game trial, and they come back from the disk.") {
        const Study study = shippedPointing();
        const auto targets = sampleTargets(study);
        REQUIRE(targets.has_value());
        auto plan = buildPlan(study, *targets, "P07", 7, {});
        REQUIRE(plan.has_value());
        int games = 0;
        const Vec3 avatar = StandingAvatar::reference().eyes();
        CHECK(avatar.y > 1.5);  // of a figure of 1.75 m
        CHECK(avatar.y < 1.75);
        for (const Trial& trial : plan->trials) {
            REQUIRE(trial.angles.has_value() == (trial.kind == StageKind::game));
            if (!trial.angles) continue;
            ++games;
            const bool across = trial.layout == "across";
            // The places as the study file has them; eyes at 1.65 m.
            const Vec3 headset = across ? Vec3(0.0, 1.65, 3.4) : Vec3(-1.2, 1.65, 0.0);
            const Vec3 desktop = across ? headset : Vec3(-1.2, 1.65, -1.0);
            REQUIRE(trial.angles->avatar_deg.size() == 2);
            for (std::size_t i = 0; i < 2; ++i) {
                const Vec3& one = trial.distractors[i];
                CHECK(std::abs(trial.angles->avatar_deg[i] - byCosines_deg(avatar, trial.target, one)) <
                      0.0051);
                CHECK(std::abs(trial.angles->headset_deg[i] - byCosines_deg(headset, trial.target, one)) <
                      0.0051);
                CHECK(std::abs(trial.angles->desktop_deg[i] - byCosines_deg(desktop, trial.target, one)) <
                      0.0051);
            }
        }
        CHECK(games == 42);
        const std::string json = planJson(*plan);
        auto back = planFromJson(json);
        REQUIRE_MESSAGE(back.has_value(), (back ? "" : back.error().text()));
        CHECK(planJson(*back) == json);
        // A plan from before they were kept.
        for (Trial& trial : plan->trials) trial.angles.reset();
        const std::string older = planJson(*plan);
        const auto without = nlohmann::json::parse(older);
        for (const auto& trial : without["trials"]) CHECK_FALSE(trial.contains("angles"));
        back = planFromJson(older);
        REQUIRE(back.has_value());
        CHECK(planJson(*back) == older);
        auto broken = nlohmann::json::parse(json);
        for (auto& trial : broken["trials"])
            if (trial.contains("angles")) trial["angles"]["avatar"][0] = 181.0;
        back = planFromJson(broken.dump());
        REQUIRE_FALSE(back.has_value());
        CHECK(back.error().text().find("angles.avatar: ") != std::string::npos);
    }

    TEST_CASE(
        "By the paper's bare rule some distractors stand behind their target, for the one or the other.") {
        Study study = shippedPointing();
        study.targets.clear_view = false;
        const auto targets = sampleTargets(study);
        REQUIRE(targets.has_value());
        int near_avatar = 0;
        int near_across = 0;
        double nearest = 180.0;
        for (const TargetItem& item : *targets) {
            const BallAngles angles =
                ballAngles(study, *study.findLayout("across"), item.target, item.distractors.front());
            near_avatar += smallestAngle(angles.avatar_deg) < 3.0;
            near_across += smallestAngle(angles.headset_deg) < 3.0;
            nearest = std::min(nearest, smallestAngle(angles.avatar_deg));
        }
        CHECK(near_avatar >= 3);
        CHECK(near_across >= 20);
        CHECK(nearest < 2.0);
    }

    TEST_CASE(
        "A band keeps distractors within the angles that it says, from every place, and no other moves.") {
        Study study = shippedPointing();
        study.targets.count = 30;
        const auto before = sampleTargets(study);
        REQUIRE(before.has_value());
        study.distances[0].avatar_angle_deg = Range{4.0, 9.0};
        study.distances[0].participant_angle_deg = Range{3.0, 25.0};
        const auto limited = sampleTargets(study);
        REQUIRE_MESSAGE(limited.has_value(), (limited ? "" : limited.error().text()));
        int same = 0;
        for (std::size_t i = 0; i < limited->size(); ++i) {
            const TargetItem& item = (*limited)[i];
            CHECK(item.target == (*before)[i].target);
            same += item.distractors == (*before)[i].distractors;
            for (const Vec3& one : item.distractors.front()) {
                const double avatar_deg = byCosines_deg(StandingAvatar::reference().eyes(), item.target, one);
                CHECK(avatar_deg > 3.994);
                CHECK(avatar_deg < 9.006);
                for (const Vec3& eyes :
                     {Vec3(0.0, 1.65, 3.4), Vec3(-1.2, 1.65, 0.0), Vec3(-1.2, 1.65, -1.0)}) {
                    CHECK(byCosines_deg(eyes, item.target, one) > 2.994);
                    CHECK(byCosines_deg(eyes, item.target, one) < 25.006);
                }
            }
        }
        CHECK(same < 30);
        study.distances[0].avatar_angle_deg = Range{60.0, 90.0};
        const auto none = sampleTargets(study);
        REQUIRE_FALSE(none.has_value());
        CHECK(none.error().message.find("60 to 90 degrees as seen by the avatar") != std::string::npos);
        CHECK(none.error().hint.find("its angles") != std::string::npos);
    }

    TEST_CASE("What visibility has drawn again is marked, and nothing is by the bare rule.") {
        Study study = shippedPointing();
        const auto targets = sampleTargets(study);
        REQUIRE(targets.has_value());
        const auto marked = redrawn(study, *targets);
        REQUIRE(marked.has_value());
        CHECK(std::count(marked->begin(), marked->end(), Redrawn::target) == 19);  // docs/design.md
        // A target that keeps its place has other distractors exactly where one of them, or it, was hidden.
        study.targets.clear_view = false;
        const auto bare = sampleTargets(study);
        REQUIRE(bare.has_value());
        for (std::size_t i = 0; i < bare->size(); ++i) {
            const bool target = (*bare)[i].target != (*targets)[i].target;
            const bool distractors = (*bare)[i].distractors != (*targets)[i].distractors;
            CHECK((*marked)[i] == (target        ? Redrawn::target
                                   : distractors ? Redrawn::distractors
                                                 : Redrawn::nothing));
        }
        const auto unmarked = redrawn(study, *bare);
        REQUIRE(unmarked.has_value());
        CHECK(std::count(unmarked->begin(), unmarked->end(), Redrawn::nothing) == 100);
    }
}
