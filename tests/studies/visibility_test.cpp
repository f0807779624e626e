#include "studies/design/visibility.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "simulated_run.hpp"
#include "studies/design/plan.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

const Vec3 eye{0.0, 1.65, 3.0};

Sphere ballAt(double x, double y, double z) {
    return {{x, y, z}, 0.05};
}

/// The share of the smaller of two circles' overlap, in area: two discs of radius r whose centres lie d
/// apart.
double lens(double r, double d) {
    if (d >= 2.0 * r) return 0.0;
    const double half = d / (2.0 * r);
    return (2.0 * std::acos(half) - 2.0 * half * std::sqrt(1.0 - half * half)) / pi;
}

/// The bare rule's targets of a study, and those that are asked to be seen.
std::vector<TargetItem> bare(const Study& study) {
    auto items = sampleTargets(study.targets, study.distances, study.seed);
    REQUIRE(items.has_value());
    return *items;
}

/// By a way of its own: rays that are spread like a sunflower's seeds, and spheres threaded on the bones.
bool hiddenByEye(const Vec3& from, const Sphere& ball, const std::vector<motion::Capsule>& body,
                 const std::vector<Sphere>& others) {
    std::vector<Sphere> things;
    const Ray middle{from, glm::normalize(ball.centre - from)};
    const auto add = [&](const Sphere& thing) {
        if (distanceToSphere(middle, thing.centre, thing.radius_m + ball.radius_m) >= 0.0)
            things.push_back(thing);
    };
    for (const Sphere& other : others) add(other);
    for (const motion::Capsule& part : body)
        for (int i = 0; i <= 40; ++i) add({part.from + i / 40.0 * (part.to - part.from), part.radius_m});
    if (things.empty()) return false;
    const Vec3 ahead = glm::normalize(ball.centre - from);
    const Vec3 right = glm::normalize(glm::cross(ahead, up));
    const Vec3 above = glm::cross(right, ahead);
    int hidden = 0;
    constexpr int rays = 150;
    for (int i = 0; i < rays; ++i) {
        const double r = ball.radius_m * std::sqrt((i + 0.5) / rays);
        const double angle = 2.399963229728653 * i;
        const Vec3 point = ball.centre + r * std::cos(angle) * right + r * std::sin(angle) * above;
        const double length = glm::length(point - from);
        const Ray ray{from, (point - from) / length};
        hidden += std::any_of(things.begin(), things.end(), [&](const Sphere& thing) {
            const double met = distanceToSphere(ray, thing.centre, thing.radius_m);
            return met >= 0.0 && met < length;
        });
    }
    return hidden > rays * 0.14;  // some slack around 0.10, for either way's grain
}

}  // namespace

TEST_SUITE("studies/visibility") {
    TEST_CASE("A ball before which nothing stands is seen whole, and behind a larger one not at all.") {
        const Sphere ball = ballAt(0.0, 1.65, 1.0);
        CHECK(visibleShare(eye, ball, {}, {}) == 1.0);
        CHECK(visibleShare(eye, ball, {}, {{{0.0, 1.65, 2.0}, 0.05}}) == 0.0);
        // Behind it, beside it and behind the eye there may be what will.
        CHECK(visibleShare(eye, ball, {}, {{{0.0, 1.65, 0.5}, 0.3}}) == 1.0);
        CHECK(visibleShare(eye, ball, {}, {{{0.5, 1.65, 1.5}, 0.05}}) == 1.0);
        CHECK(visibleShare(eye, ball, {}, {{{0.0, 1.65, 4.0}, 0.3}}) == 1.0);
    }

    TEST_CASE("What a nearer ball covers is the lens of two circles.") {
        // The other ball half way to the first, half as large: as large in the view.
        for (const double apart : {0.02, 0.035, 0.05, 0.07, 0.085}) {
            const Sphere ball{{0.0, 1.65, 1.0}, 0.05};
            const Sphere nearer{{apart / 2.0, 1.65, 2.0}, 0.025};
            CAPTURE(apart);
            CHECK(visibleShare(eye, ball, {}, {nearer}) ==
                  doctest::Approx(1.0 - lens(0.05, apart)).epsilon(0.05));
        }
    }

    TEST_CASE("A limb hides a band of the disc.") {
        const Sphere ball = ballAt(0.0, 1.65, 1.0);
        // Upright, 2 cm thick at half the way: 4 cm in the middle of the ball's 10.
        const motion::Capsule limb{{0.0, 0.5, 2.0}, {0.0, 2.5, 2.0}, 0.01};
        const double x = 0.4;  // of the radius
        const double band = (2.0 * std::asin(x) + 2.0 * x * std::sqrt(1.0 - x * x)) / pi;
        CHECK(visibleShare(eye, ball, {limb}, {}) == doctest::Approx(1.0 - band).epsilon(0.06));
        CHECK(visibleShare(eye, ball, {{{0.2, 0.5, 2.0}, {0.2, 2.5, 2.0}, 0.01}}, {}) == 1.0);
        CHECK(visibleShare(eye, ball, {{{0.0, 1.8, 2.0}, {0.0, 2.5, 2.0}, 0.01}}, {}) == 1.0);
    }

    TEST_CASE("The avatar hides what stands behind it, and its arm what it points across.") {
        const StandingAvatar& avatar = StandingAvatar::reference();
        const Vec3 before{0.0, 1.65, 2.0};
        CHECK(visibleShare(before, ballAt(0.0, 1.2, -1.0), avatar.atRest(), {}) == 0.0);
        CHECK(visibleShare(before, ballAt(0.0, 1.2, 1.0), avatar.atRest(), {}) == 1.0);
        // From its right, level with the shoulders: the left arm stretched ahead covers what is beyond it.
        const Vec3 beside{-1.2, 1.5, 0.45};
        const Sphere beyond = ballAt(1.8, 1.5, 0.45);
        CHECK(visibleShare(beside, beyond, avatar.atRest(), {}) == 1.0);
        CHECK(visibleShare(beside, beyond, avatar.pointing({0.2, 1.4, 2.0}), {}) < 0.5);
    }

    TEST_CASE("A study's places: one for each station, three heights of the eyes.") {
        Study study = loadedStudy(source_tree / "assets/data/studies/pointing2023.toml");
        const std::vector<Viewpoint> from = viewpoints(study);
        REQUIRE(from.size() == 4);
        CHECK(from[2].layout == "side-by-side");
        CHECK(from[2].standing == Standing::headset);
        CHECK(from[2].eyes == std::vector<Vec3>{{-1.2, 1.5, 0.0}, {-1.2, 1.65, 0.0}, {-1.2, 1.8, 0.0}});
        CHECK(from[3].standing == Standing::desktop);
        CHECK(from[3].eyes.front() == Vec3(-1.2, 1.5, -1.0));
        CHECK(askedViewpoints(study).size() == 4);
        study.targets.clear_view = false;
        CHECK(askedViewpoints(study).empty());
        study.stages.clear();
        CHECK(viewpoints(study).empty());
    }

    TEST_CASE(
        "The shipped studies: by the bare rule balls are hidden, now none is, by another count of rays.") {
        for (const char* name : {"pointing2023", "distractor-distance", "pointing-style"}) {
            CAPTURE(name);
            const Study study =
                loadedStudy(source_tree / "assets/data/studies" / (std::string(name) + ".toml"));
            const auto asked = sampleTargets(study);
            REQUIRE_MESSAGE(asked.has_value(), (asked ? "" : asked.error().text()));
            const StandingAvatar& avatar = StandingAvatar::reference();
            const double radius_m = study.targets.ball_diameter_m / 2;
            const auto hiddenSets = [&](const std::vector<TargetItem>& items) {
                int hidden = 0;
                for (const TargetItem& item : items) {
                    const std::vector<motion::Capsule> pointing = avatar.pointing(item.target);
                    bool any = false;
                    for (const std::vector<Vec3>& distractors : item.distractors) {
                        std::vector<Sphere> balls{{item.target, radius_m}};
                        for (const Vec3& ball : distractors) balls.push_back({ball, radius_m});
                        for (const Viewpoint& viewpoint : viewpoints(study))
                            for (std::size_t i = 0; i < balls.size() && !any; ++i) {
                                std::vector<Sphere> others = balls;
                                others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
                                for (const auto* body : {&avatar.atRest(), &pointing})
                                    any = any || hiddenByEye(viewpoint.eyes[1], balls[i], *body, others);
                            }
                    }
                    hidden += any;
                }
                return hidden;
            };
            CHECK(hiddenSets(bare(study)) >= 5);
            CHECK(hiddenSets(*asked) == 0);
        }
    }

    TEST_CASE("What is seen stays where the bare rule puts it.") {
        const Study study = loadedStudy(source_tree / "assets/data/studies/pointing2023.toml");
        const std::vector<TargetItem> by_rule = bare(study);
        const auto asked = sampleTargets(study);
        REQUIRE(asked.has_value());
        int moved = 0;
        int same_distractors = 0;
        for (std::size_t i = 0; i < by_rule.size(); ++i) {
            const bool seen = ClearView(viewpoints(study), by_rule[i].target, 0.05).seesTarget();
            CHECK(((*asked)[i].target == by_rule[i].target) == seen);
            moved += !seen;
            same_distractors += (*asked)[i].distractors == by_rule[i].distractors;
        }
        CHECK(moved > 5);
        CHECK(moved < 25);
        CHECK(same_distractors > 30);
        // Neither the number of targets nor other distractors move a target.
        Study fewer = study;
        fewer.targets.count = 20;
        fewer.distances = {{"far", {0.6, 0.8}, 3}};
        const auto some = sampleTargets(fewer);
        REQUIRE(some.has_value());
        for (std::size_t i = 0; i < 20; ++i) CHECK((*some)[i].target == (*asked)[i].target);
    }

    TEST_CASE("A place from which nothing can be seen is named.") {
        Study study = loadedStudy(source_tree / "assets/data/studies/pointing2023.toml");
        study.targets.arc_deg = {-2.0, 2.0};
        study.targets.height_m = {0.9, 1.3};
        study.layouts[1].desktop = ViewerPlace{0.0, -1.0, 0.0};  // behind its back
        const auto asked = sampleTargets(study);
        REQUIRE_FALSE(asked.has_value());
        CHECK(asked.error().where == "targets.visibility");
        CHECK(asked.error().message.find("side-by-side (desktop)") != std::string::npos);
        study.targets.clear_view = false;
        CHECK(sampleTargets(study).has_value());
    }

    TEST_CASE("The plan keeps what is seen of each ball, in the order in which they are shown.") {
        const Prepared prepared(loadedStudy(source_tree / "assets/data/studies/pointing2023.toml"));
        int games = 0;
        for (const Trial& trial : prepared.plan.trials) {
            if (trial.kind != StageKind::game) {
                CHECK(trial.seen.empty());
                continue;
            }
            ++games;
            REQUIRE(trial.seen.size() == 2);
            std::vector<Sphere> balls{{trial.target, 0.05}};
            for (const Vec3& ball : trial.distractors) balls.push_back({ball, 0.05});
            for (const Viewpoint& viewpoint : viewpoints(prepared.study)) {
                if (viewpoint.layout != trial.layout) continue;
                const SeenBalls expected = seenFrom(viewpoint, StandingAvatar::reference(), balls);
                const SeenBalls& kept = trial.seen[viewpoint.standing == Standing::headset ? 0 : 1];
                CHECK(kept.clear());
                for (std::size_t place = 0; place < 3; ++place) {
                    const auto ball = static_cast<std::size_t>(trial.ball_order[place]);
                    CHECK(kept.at_rest[place] == expected.at_rest[ball]);
                    CHECK(kept.pointing[place] == expected.pointing[ball]);
                }
            }
        }
        CHECK(games > 40);
        // To the disk and back, and without it as before.
        StudyPlan plan = prepared.plan;
        const std::string json = planJson(plan);
        auto back = planFromJson(json);
        REQUIRE(back.has_value());
        CHECK(planJson(*back) == json);
        for (Trial& trial : plan.trials) trial.seen.clear();
        const std::string older = planJson(plan);
        const auto without = nlohmann::json::parse(older);
        for (const auto& trial : without["trials"]) CHECK_FALSE(trial.contains("visibility"));
        back = planFromJson(older);
        REQUIRE(back.has_value());
        CHECK(planJson(*back) == older);
    }
}
