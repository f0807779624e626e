#include "studies/design/plan.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "core/hash.hpp"
#include "plan_fixture.hpp"

using namespace deixis;
using namespace deixis::studies;
using namespace deixis::studies::plan_fixture;

namespace {

const std::vector<TargetItem>& hundred() {
    static const std::vector<TargetItem> targets = targetsFor(pointing(), 100);
    return targets;
}

std::string errorOf(const Study& study, int targets, const Groups& groups = {}) {
    const Result<StudyPlan> plan = buildPlan(study, targetsFor(study, targets), "P01", 1, groups);
    return plan ? "" : plan.error().text();
}

/// A small study with every kind of stage, for the pinned plan.
Study everyKind() {
    Study study = studyOf({"one", "two", "three"});
    study.between = {{"who", {"us", "them"}}};
    Stage rating = trials(study, "rating", StageKind::rating, 4);
    rating.design.no_target_twice_running = true;
    rating.design.max_run_of_system = 2;
    rating.checks = {check(CheckKind::number, 1), check(CheckKind::repeat, 1)};
    Stage game = trials(study, "game", StageKind::game, 4);
    game.design.distances = {"near", "far"};
    game.design.block_by = "system";
    game.design.block_order = BlockOrder::williams;
    game.checks = {check(CheckKind::catch_trial, 2)};
    Stage pages = trials(study, "pages", StageKind::parallel_rating, 3);
    pages.when = {{"who", "us"}};
    Stage pairs = trials(study, "pairs", StageKind::pairwise, 2);
    pairs.session = 2;
    study.stages = {page("consent", StageKind::consent),
                    questionnaire("before", 5, 2),
                    practiceOf(rating, 2),
                    rating,
                    pages,
                    practiceOf(game, 2, 2),
                    game,
                    page("goodbye", StageKind::instructions),
                    pairs};
    return study;
}

}  // namespace

TEST_SUITE("studies/plan") {
    TEST_CASE("The study of Deichler et al. is practice and ratings, then practice and games.") {
        const StudyPlan plan = planOf(pointing(), hundred(), 1);
        REQUIRE(plan.trials.size() == 2 + 20 + 2 + 40);
        for (std::size_t i = 0; i < plan.trials.size(); ++i) {
            const Trial& trial = plan.trials[i];
            CHECK(trial.index == static_cast<int>(i));
            CHECK(trial.kind == (i < 22 ? StageKind::rating : StageKind::game));
            CHECK(trial.practice == (i < 2 || i == 22 || i == 23));
            CHECK(trial.scored() == !trial.practice);
            CHECK_FALSE(trial.scored(1));
        }
        CHECK(plan.participant == "P0001");
        CHECK(plan.number == 1);
        CHECK(plan.study_name == "pointing2023");
        CHECK(plan.study_hash == pointing().hash);
        CHECK(plan.seed == 2023);
        CHECK(plan.stages == std::vector<std::string>{"welcome", "practice-naturalness", "naturalness",
                                                      "pause", "practice-game", "game", "goodbye"});
    }

    TEST_CASE("Practice shows four systems in four trials, and both layouts of the game.") {
        for (int number = 1; number <= 50; ++number) {
            std::set<std::string> systems, layouts;
            for (const Trial& trial : planOf(pointing(), hundred(), number).trials) {
                if (!trial.practice) continue;
                systems.insert(trial.stimuli.front().system);
                if (trial.kind == StageKind::game) layouts.insert(trial.layout);
            }
            CHECK(systems.size() == 4);
            CHECK(layouts.size() == 2);
        }
    }

    TEST_CASE("Every attempt at a practice has items of its own and is numbered.") {
        Study study = pointing();
        study.stages[4] = practiceOf(study.stages[5], 3, 4);
        const std::vector<Trial> practice = trialsOf(planOf(study, hundred(), 3), "practice-game");
        REQUIRE(practice.size() == 12);
        std::set<std::string> items;
        for (std::size_t i = 0; i < practice.size(); ++i) {
            CHECK(practice[i].practice);
            CHECK(practice[i].attempt == static_cast<int>(i) / 3);
            CHECK(practice[i].kind == StageKind::game);
            CHECK(practice[i].ball_order.size() == 3);
            items.insert(practice[i].stimuli.front().item);
        }
        CHECK(items.size() == 12);
        // Attempts after the first are rarely done: the next practice goes on where the first ended.
        std::swap(study.stages[1], study.stages[4]);
        std::set<std::string> systems;
        for (const Trial& trial : planOf(study, hundred(), 3).trials)
            if (trial.practice && trial.attempt == 0) systems.insert(trial.stimuli.front().system);
        CHECK(systems.size() == 4);
    }

    TEST_CASE("A trial carries the positions of its target and distractors; its balls are these, shuffled.") {
        Study study = pointing();
        study.distances = studyOf({}).distances;
        study.stages[5].design.distances = {"far", "near"};
        const std::vector<TargetItem> targets = targetsFor(study, 100);
        std::map<std::string, TargetItem> by_id;
        for (const TargetItem& item : targets) by_id[item.id] = item;
        std::set<std::string> bands;
        for (const Trial& trial : planOf(study, targets, 17).trials) {
            const TargetItem& item = by_id.at(trial.stimuli.front().item);
            CHECK(trial.target == item.target);
            if (trial.kind == StageKind::rating) {
                CHECK(trial.distractors.empty());
                CHECK(trial.ball_order.empty());
                CHECK(trial.distance.empty());
                CHECK(trial.targetPlace() == -1);
                continue;
            }
            CHECK(trial.distractors == item.distractors[trial.distance == "near" ? 0 : 1]);
            bands.insert(trial.distance);
            REQUIRE(trial.ball_order.size() == 3);
            CHECK(trial.ball(trial.targetPlace()) == item.target);
            const std::vector<Vec3> shown{trial.ball(0), trial.ball(1), trial.ball(2)};
            for (const Vec3& distractor : trial.distractors)
                CHECK(std::count(shown.begin(), shown.end(), distractor) == 1);
            CHECK_THROWS(std::ignore = trial.ball(3));
        }
        CHECK(bands.size() == 2);
    }

    TEST_CASE("A page of a parallel rating shows one item under all systems, a pair two of them.") {
        Study study = studyOf({"a", "b", "c", "d"});
        study.stages = {trials(study, "pages", StageKind::parallel_rating, 6),
                        trials(study, "pairs", StageKind::pairwise, 3)};
        const StudyPlan plan = planOf(study, hundred(), 2);
        const std::vector<Trial> pages = trialsOf(plan, "pages");
        REQUIRE(pages.size() == 6);
        std::set<std::string> page_items, orders;
        for (const Trial& trial : pages) {
            REQUIRE(trial.stimuli.size() == 4);
            std::set<std::string> systems;
            std::string order;
            for (const Stimulus& stimulus : trial.stimuli) {
                systems.insert(stimulus.system);
                order += stimulus.system;
                CHECK(stimulus.item == trial.stimuli[0].item);
            }
            CHECK(systems.size() == 4);
            CHECK(trial.scored(3));
            CHECK_FALSE(trial.scored(4));
            page_items.insert(trial.stimuli[0].item);
            orders.insert(order);
        }
        CHECK(page_items.size() == 6);
        CHECK(orders.size() > 1);

        const std::vector<Trial> pairs = trialsOf(plan, "pairs");
        REQUIRE(pairs.size() == 3 * 6);
        std::set<std::tuple<std::string, std::string, std::string>> shown;
        for (const Trial& trial : pairs) {
            REQUIRE(trial.stimuli.size() == 2);
            const auto& [left, right] = std::tie(trial.stimuli[0], trial.stimuli[1]);
            CHECK(left.item == right.item);
            CHECK(page_items.count(left.item) == 0);
            CHECK(left.system != right.system);
            shown.emplace(std::min(left.system, right.system), std::max(left.system, right.system),
                          left.item);
        }
        CHECK(shown.size() == 18);
    }

    TEST_CASE("Consent and each page of a questionnaire are trials without stimuli, in a layout.") {
        Study study = pointing();
        study.stages.insert(study.stages.begin(), questionnaire("before", 9, 4));
        study.stages.insert(study.stages.begin(), page("consent", StageKind::consent));
        study.stages.push_back(questionnaire("after", 4, 4));
        const StudyPlan plan = planOf(study, hundred(), 1);
        const std::vector<Trial> before = trialsOf(plan, "before");
        REQUIRE(before.size() == 3);
        for (int i = 0; i < 3; ++i) {
            CHECK(before[static_cast<std::size_t>(i)].page == i);
            CHECK(before[static_cast<std::size_t>(i)].index == i + 1);
        }
        CHECK(trialsOf(plan, "consent").size() == 1);
        CHECK(trialsOf(plan, "after").size() == 1);
        // Nobody is moved for the sake of a page.
        CHECK(plan.trials.front().layout == "across");
        CHECK(plan.trials.back().layout == plan.trials[plan.trials.size() - 2].layout);
        for (const Trial& trial : plan.trials) {
            if (!trial.stimuli.empty()) continue;
            CHECK_FALSE(trial.scored());
            CHECK_FALSE(trial.practice);
            CHECK(trial.targetPlace() == -1);
        }
        Study pages_only = study;
        pages_only.stages = {page("consent", StageKind::consent)};
        CHECK(planOf(pages_only, {}, 1).trials.front().layout == "across");
        pages_only.layouts.clear();
        CHECK(planOf(pages_only, {}, 1).trials.front().layout.empty());
    }

    TEST_CASE("Stages for other groups are left out, and their items are not needed.") {
        const Study study = rating();
        const std::vector<TargetItem> targets = targetsFor(study, 13);
        for (const std::string level : {"human-likeness", "appropriateness"}) {
            const StudyPlan plan = planOf(study, targets, 4, {{"measure", level}});
            CHECK(plan.groups.at("measure") == level);
            CHECK(plan.stages ==
                  std::vector<std::string>{"consent", "practice-" + level, level, "about-you"});
            CHECK(plan.trials.size() == 1 + 1 + 12 + 2);
        }
        Study both = study;
        for (Stage& stage : both.stages) stage.when.clear();
        CHECK_FALSE(buildPlan(both, targets, "P04", 4, {{"measure", "human-likeness"}}).has_value());
    }

    TEST_CASE("Later sessions go on with the numbers and have items of their own.") {
        Study study = pointing();
        Stage second = study.stages[2];
        second.name = "again";
        second.session = 2;
        study.stages.push_back(second);
        const StudyPlan plan = planOf(study, hundred(), 1);
        const std::vector<Trial> again = trialsOf(plan, "again");
        REQUIRE(again.size() == 20);
        CHECK(again.front().index == 64);
        std::set<std::string> items;
        for (const Trial& trial : plan.trials) items.insert(trial.stimuli.front().item);
        CHECK(items.size() == 2 + 5 + 2 + 10 + 5);
    }

    TEST_CASE("Items without a place can be rated, and games get those that have one.") {
        Study study = pointing();
        std::vector<TargetItem> targets = targetsFor(study, 19);
        for (std::size_t i = 0; i < 7; ++i) {
            targets[2 * i].placed = false;
            targets[2 * i].target = Vec3(0.0);
            targets[2 * i].distractors.clear();
        }
        for (int number = 1; number <= 100; ++number) {
            int wrong = 0;
            for (const Trial& trial : planOf(study, targets, number).trials)
                wrong += (trial.kind == StageKind::game) != (trial.target != Vec3(0.0));
            CHECK(wrong == 0);  // 12 have a place and the games need them all
        }
        targets[1].placed = false;
        const Result<StudyPlan> plan = buildPlan(study, targets, "P01", 1, {});
        REQUIRE_FALSE(plan.has_value());
        CHECK(plan.error().message.find(
                  "found 11 with a position in the room and distractors, expected at least "
                  "12") != std::string::npos);
    }

    TEST_CASE("The order of blocks is as listed, by the number, or chance's.") {
        Study study = studyOf({"a", "b", "c", "d"});
        study.stages = {trials(study, "game", StageKind::game, 4)};
        TrialDesign& design = study.stages[0].design;
        const std::vector<TargetItem> targets = targetsFor(study, 20);
        const auto blocks = [&](int number) {
            std::string out;
            for (const Trial& trial : planOf(study, targets, number).trials) {
                const std::string& level =
                    design.block_by == "layout" ? trial.layout : trial.stimuli.front().system;
                if (out.size() < level.size() || out.substr(out.size() - level.size()) != level) out += level;
            }
            return out;
        };
        design.block_by = "system";
        design.block_order = BlockOrder::listed;
        CHECK(blocks(1) == "abcd");
        CHECK(blocks(2) == "abcd");
        design.block_order = BlockOrder::williams;
        CHECK(blocks(1) == "abdc");
        CHECK(blocks(2) == "bcad");
        CHECK(blocks(4) == "dacb");
        CHECK(blocks(5) == "abdc");
        design.block_order = BlockOrder::shuffled;
        std::set<std::string> orders;
        for (int number = 1; number <= 200; ++number) orders.insert(blocks(number));
        CHECK(orders.size() == 24);
        for (const std::string& order : orders) CHECK(order.size() == 4);
        design.block_by = "layout";
        design.block_order = BlockOrder::williams;
        CHECK(blocks(1) == "acrossside-by-side");
        CHECK(blocks(2) == "side-by-sideacross");
    }

    TEST_CASE("The plan of a small study with every kind of stage is the same on every machine.") {
        const Study study = everyKind();
        StudyPlan plan = planOf(study, targetsFor(study, 40), 7, {{"who", "us"}});
        // Studies under way hang on it: with another plan comes another version.
        CHECK(planner_version == 1);
        CHECK(sha256Hex(planJson(plan)) ==
              "2440a6b1ea4dc6ee1c03ee991424c6979afcf560ddb5eace01dbfc594838b29a");
        StudyPlan other = planOf(pointing(), hundred(), 1);
        CHECK(sha256Hex(planJson(other)) ==
              "fcebb82088178a224c340c23de6961d8d5938ddc2932b2c5d8c3e04d7c278d4e");
        // But for the angles that are noted with it, the plan is what it was before they were.
        for (StudyPlan* each : {&plan, &other})
            for (Trial& trial : each->trials) trial.angles.reset();
        CHECK(sha256Hex(planJson(plan)) ==
              "a8f240cddb47fed5358e9163c81871c68987faa3e96e73854484501d6baa659c");
        CHECK(sha256Hex(planJson(other)) ==
              "8b94ef83f06f0a49a6980bebddb9b6457261b24fde62a7df4e295d1e35cc62a2");
    }

    TEST_CASE("A plan follows seed, number, groups and design, and neither the id nor texts nor language.") {
        const Study study = everyKind();
        const std::vector<TargetItem> targets = targetsFor(study, 40);
        const Groups us{{"who", "us"}};
        const std::string before = fingerprint(planOf(study, targets, 7, us));
        CHECK(fingerprint(buildPlan(study, targets, "somebody-else", 7, us).value()) == before);
        Study said_otherwise = study;
        said_otherwise.title = said_otherwise.description = "Something else.";
        said_otherwise.languages = {"de", "en"};
        said_otherwise.language = "de";
        for (Stage& stage : said_otherwise.stages) {
            stage.text = stage.question = stage.break_text = stage.measure = "Etwas anderes.";
            stage.scale.labels = {"schlecht", "gut"};
            for (Question& question : stage.questionnaire.questions) question.text = "Wie?";
        }
        CHECK(fingerprint(planOf(said_otherwise, targets, 7, us)) == before);

        CHECK(fingerprint(planOf(study, targets, 8, us)) != before);
        Study other_seed = study;
        other_seed.seed += 1;
        StudyPlan from_other_seed = planOf(other_seed, targets, 7, us);
        from_other_seed.seed = study.seed;
        CHECK(fingerprint(from_other_seed) != before);

        // A stage's order depends on its own design: one more question or stage leaves the others alone.
        Study longer = study;
        longer.stages.push_back(trials(longer, "more", StageKind::rating, 3));
        const auto ordersOf = [](const StudyPlan& plan) {
            std::string out;
            for (const Trial& trial : trialsOf(plan, "game"))
                out += trial.stimuli[0].system + trial.layout + trial.distance;
            return out;
        };
        CHECK(ordersOf(planOf(longer, targets, 7, us)) == ordersOf(planOf(study, targets, 7, us)));
    }

    TEST_CASE("Participants and groups that the study does not know are rejected.") {
        const Study study = rating();
        const std::vector<TargetItem> targets = targetsFor(study, 40);
        const Groups groups{{"measure", "appropriateness"}};
        CHECK(buildPlan(study, targets, "P01", 1, groups).has_value());
        CHECK_FALSE(buildPlan(study, targets, "P 01", 1, groups).has_value());
        CHECK_FALSE(buildPlan(study, targets, "P01", 0, groups).has_value());
        CHECK(errorOf(study, 40).find("groups.measure: found none, expected one of \"human-likeness\", "
                                      "\"appropriateness\"") == 0);
        CHECK(errorOf(study, 40, {{"measure", "beauty"}}).find("groups.measure: found \"beauty\"") == 0);
        CHECK(errorOf(study, 40, {{"measure", "appropriateness"}, {"age", "old"}}).find("groups.age") == 0);
    }

    TEST_CASE("Too few targets are rejected with the number needed.") {
        CHECK(errorOf(pointing(), 19).empty());
        CHECK(errorOf(pointing(), 18).find("targets.count: found 18 targets, expected at least 19") == 0);
        const Study study = everyKind();
        CHECK(errorOf(study, 18, {{"who", "them"}}).empty());
        CHECK(errorOf(study, 21, {{"who", "us"}}).empty());
        CHECK(errorOf(study, 17, {{"who", "them"}}).find("expected at least 18") != std::string::npos);
        CHECK(errorOf(study, 20, {{"who", "us"}}).find("expected at least 21") != std::string::npos);
    }

    TEST_CASE("A design that lacks what its trials are made of is rejected by key.") {
        const auto rejected = [](const auto& spoil) {
            Study study = pointing();
            study.stages = {study.stages[5]};
            spoil(study.stages[0]);
            return errorOf(study, 40);
        };
        CHECK(rejected([](Stage&) {}).empty());
        CHECK(rejected([](Stage& stage) { stage.design.systems.clear(); }).find("stages.game.systems") == 0);
        CHECK(rejected([](Stage& stage) { stage.design.systems = {"x"}; }).find("stages.game.systems") == 0);
        CHECK(rejected([](Stage& stage) { stage.design.layouts.clear(); }).find("stages.game.layouts") == 0);
        CHECK(rejected([](Stage& stage) { stage.design.layouts = {"x"}; }).find("stages.game.layouts") == 0);
        CHECK(rejected([](Stage& stage) { stage.design.distances.clear(); }).find("stages.game.distances") ==
              0);
        CHECK(rejected([](Stage& stage) { stage.design.distances = {"x"}; }).find("stages.game.distances") ==
              0);
        CHECK(rejected([](Stage& stage) { stage.design.items = 0; }).find("stages.game.items") == 0);
        CHECK(rejected([](Stage& stage) {
                  stage.kind = StageKind::pairwise;
                  stage.design.systems = {"direct"};
              }).find("stages.game.systems: found 1, expected at least 2") == 0);
        CHECK(rejected([](Stage& stage) {
                  stage.kind = StageKind::parallel_rating;
                  stage.design.system_meets = Crossing::nested;
              }).find("stages.game.system_meets") == 0);
        CHECK(rejected([](Stage& stage) {
                  stage.practice = Practice{};
                  stage.practice->of = "nothing";
              }).find("stages.game.of: found \"nothing\"") == 0);
    }
}
