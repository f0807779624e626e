// Attention checks in plans: numbers, catch trials, repeats.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "plan_fixture.hpp"
#include "studies/design/plan.hpp"

using namespace deixis;
using namespace deixis::studies;
using namespace deixis::studies::plan_fixture;

namespace {

const Groups likeness{{"measure", "human-likeness"}};

/// Chi-squared of counts against equal ones.
double unevenness(const std::vector<int>& counts) {
    double sum = 0.0;
    double total = 0.0;
    for (const int count : counts) total += count;
    const double expected = total / static_cast<double>(counts.size());
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

}  // namespace

TEST_SUITE("studies/plan_checks") {
    TEST_CASE("Two numbers a person stand on two random pages, and the other stimuli there count.") {
        const Study study = rating();
        const std::vector<TargetItem> targets = targetsFor(study, 40);
        std::vector<int> pages(12), stimuli(4), asked(101);
        int wrong = 0;
        for (int number = 1; number <= 1000; ++number) {
            const std::vector<Trial> trials =
                trialsOf(planOf(study, targets, number, likeness), "human-likeness");
            wrong += countChecks(trials, CheckKind::number) != 2;  // so never two on a page
            int scored = 0;
            for (std::size_t i = 0; i < trials.size(); ++i) {
                for (int s = 0; s < 4; ++s) scored += trials[i].scored(s);
                if (!trials[i].check) continue;
                const TrialCheck& check = *trials[i].check;
                ++pages[i];
                ++stimuli[static_cast<std::size_t>(check.stimulus)];
                wrong +=
                    check.expected != std::floor(check.expected) || check.expected < 5 || check.expected > 95;
                ++asked[static_cast<std::size_t>(check.expected)];
                wrong += trials[i].scored(check.stimulus) || check.of_trial != -1;
            }
            wrong += scored != 12 * 4 - 2;  // 4,800 - 240 = 4,560 ratings in the paper (7.2.3)
        }
        CHECK(wrong == 0);
        CHECK(unevenness(pages) < 31.26);    // 11 degrees of freedom, p = 0.001
        CHECK(unevenness(stimuli) < 16.27);  // 3
        CHECK(std::count(asked.begin(), asked.end(), 0) == 10);
    }

    TEST_CASE("On a scale of steps a number may be any step, and each check has a trial of its own.") {
        Study study = studyOf({"a", "b"});
        study.stages = {trials(study, "rating", StageKind::rating, 5)};
        study.stages[0].scale.high = 7;
        study.stages[0].checks = {check(CheckKind::number, 4), check(CheckKind::number, 6)};
        std::set<double> numbers;
        for (int number = 1; number <= 50; ++number) {
            const StudyPlan plan = planOf(study, targetsFor(study, 5), number);
            CHECK(plan.trials.size() == 10);
            CHECK(countChecks(plan.trials, CheckKind::number) == 10);
            for (const Trial& trial : plan.trials) numbers.insert(trial.check->expected);
        }
        CHECK(numbers == std::set<double>{1, 2, 3, 4, 5, 6, 7});
        study.stages[0].checks.push_back(check(CheckKind::number, 1));
        const Result<StudyPlan> plan = buildPlan(study, targetsFor(study, 5), "P1", 1, {});
        REQUIRE_FALSE(plan.has_value());
        CHECK(plan.error().where == "stages.rating.checks.count");
    }

    TEST_CASE("Catch trials are added, with the far band and items of their own.") {
        Study study = pointing();
        study.distances = studyOf({}).distances;
        study.stages[5].checks = {check(CheckKind::catch_trial, 4)};
        const std::vector<TargetItem> targets = targetsFor(study, 100);
        std::vector<int> places(44);
        for (int number = 1; number <= 1000; ++number) {
            const std::vector<Trial> trials = trialsOf(planOf(study, targets, number), "game");
            REQUIRE(trials.size() == 44);
            std::set<std::string> items, caught, systems;
            std::map<std::string, int> layouts;
            for (std::size_t i = 0; i < trials.size(); ++i) {
                const Trial& trial = trials[i];
                if (!trial.check) {
                    items.insert(trial.stimuli[0].item);
                    continue;
                }
                REQUIRE(trial.check->kind == CheckKind::catch_trial);
                ++places[i];
                caught.insert(trial.stimuli[0].item);
                systems.insert(trial.stimuli[0].system);
                ++layouts[trial.layout];
                CHECK(trial.distance == "far");
                CHECK(trial.distractors[0] == trial.target + Vec3(0.0, 0.8, 0.0));
                CHECK_FALSE(trial.scored());
            }
            CHECK(items.size() == 10);
            CHECK(caught.size() == 4);
            CHECK(systems.size() == 4);
            CHECK(layouts == std::map<std::string, int>{{"across", 2}, {"side-by-side", 2}});
            for (const std::string& item : caught) CHECK(items.count(item) == 0);
        }
        CHECK(unevenness(places) < 77.42);  // 43 degrees of freedom, p = 0.001
    }

    TEST_CASE("A repeat is the same once more, in the same block, a quarter of it later or more.") {
        Study study = studyOf({"a", "b", "c"});
        for (const StageKind kind :
             {StageKind::rating, StageKind::pairwise, StageKind::parallel_rating, StageKind::game}) {
            study.stages = {trials(study, "stage", kind, 8)};
            Stage& stage = study.stages[0];
            stage.design.layouts = {"across", "side-by-side"};
            stage.design.block_by = "layout";
            stage.design.no_target_twice_running = true;
            stage.checks = {check(CheckKind::repeat, 2)};
            const int plain = kind == StageKind::parallel_rating ? 8 : 24;
            int wrong = 0;
            int shown_otherwise = 0;
            std::set<int> places;
            for (int number = 1; number <= 300; ++number) {
                const StudyPlan plan = planOf(study, targetsFor(study, 20), number);
                REQUIRE(static_cast<int>(plan.trials.size()) == plain + 2);
                std::set<int> first_times;
                int changes = 0;
                for (std::size_t i = 0; i < plan.trials.size(); ++i) {
                    const Trial& trial = plan.trials[i];
                    if (i > 0) {
                        const Trial& last = plan.trials[i - 1];
                        changes += trial.layout != last.layout;
                        wrong += trial.stimuli[0].item == last.stimuli[0].item;
                    }
                    if (!trial.check) continue;
                    wrong += trial.check->kind != CheckKind::repeat || trial.scored();
                    const Trial& first = plan.trials.at(static_cast<std::size_t>(trial.check->of_trial));
                    first_times.insert(first.index);
                    places.insert(trial.index);
                    wrong += first.check.has_value() || !first.scored();
                    wrong += first.layout != trial.layout || first.distractors != trial.distractors ||
                             first.target != trial.target ||
                             !std::is_permutation(first.stimuli.begin(), first.stimuli.end(),
                                                  trial.stimuli.begin(), trial.stimuli.end());
                    shown_otherwise += first.stimuli != trial.stimuli || first.ball_order != trial.ball_order;
                    wrong += trial.index - first.index - 1 < plain / 2 / 4;
                }
                wrong += first_times.size() != 2 || changes != 1;
            }
            CHECK(wrong == 0);
            CHECK(static_cast<int>(places.size()) > plain / 2);
            // Of 600: the stimuli of a pair or page and the balls are shuffled again.
            if (kind == StageKind::rating) CHECK(shown_otherwise == 0);
            if (kind == StageKind::pairwise) CHECK(std::abs(shown_otherwise - 300) < 49);
            if (kind == StageKind::parallel_rating || kind == StageKind::game)
                CHECK(std::abs(shown_otherwise - 500) < 4 * 9.2);  // 5 of 6 orders of three
        }
    }

    TEST_CASE("Numbers and repeats keep out of each other's way.") {
        Study study = studyOf({"a", "b"});
        study.stages = {trials(study, "rating", StageKind::rating, 5)};
        study.stages[0].checks = {check(CheckKind::number, 4), check(CheckKind::repeat, 3)};
        for (int number = 1; number <= 300; ++number) {
            const StudyPlan plan = planOf(study, targetsFor(study, 5), number);
            REQUIRE(plan.trials.size() == 13);
            CHECK(countChecks(plan.trials, CheckKind::number) == 4);
            CHECK(countChecks(plan.trials, CheckKind::repeat) == 3);
            int scored = 0;
            for (const Trial& trial : plan.trials) {
                scored += trial.scored();
                if (trial.check && trial.check->kind == CheckKind::repeat)
                    CHECK(plan.trials[static_cast<std::size_t>(trial.check->of_trial)].scored());
            }
            CHECK(scored == 6);
        }
    }

    TEST_CASE("Checks that a stage has no room or no use for are rejected.") {
        Study study = studyOf({"a"});
        study.stages = {trials(study, "rating", StageKind::rating, 1)};
        const auto rejected = [&](CheckKind kind) {
            study.stages[0].checks = {check(kind, 1)};
            const Result<StudyPlan> plan = buildPlan(study, targetsFor(study, 5), "P1", 1, {});
            return plan ? std::string() : plan.error().text();
        };
        CHECK(rejected(CheckKind::number).empty());
        CHECK(rejected(CheckKind::repeat).find("stages.rating.checks.count: found no room for 1 repeats") ==
              0);
        CHECK(rejected(CheckKind::catch_trial).find("stages.rating.checks.kind: found \"catch\"") == 0);
        study.stages = {trials(study, "game", StageKind::game, 2)};
        CHECK(rejected(CheckKind::catch_trial).empty());
        CHECK(rejected(CheckKind::number).find("stages.game.checks.kind: found \"number\"") == 0);
        study.distances.pop_back();
        CHECK(rejected(CheckKind::catch_trial).find("stages.game.checks.distance: found \"far\"") == 0);
    }
}
