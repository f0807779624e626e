#include <doctest/doctest.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "plan_fixture.hpp"
#include "studies/design/plan.hpp"

using namespace deixis;
using namespace deixis::studies;
using namespace deixis::studies::plan_fixture;

namespace {

/// All that a plan can hold: pages, every kind of trial and check, practice, groups.
StudyPlan everything() {
    Study study = studyOf({"one", "two", "three"});
    study.between = {{"who", {"us", "them"}}};
    Stage rating = trials(study, "rating", StageKind::rating, 4);
    rating.checks = {check(CheckKind::number, 1), check(CheckKind::repeat, 1)};
    Stage game = trials(study, "game", StageKind::game, 2);
    game.checks = {check(CheckKind::catch_trial, 1)};
    study.stages = {page("consent", StageKind::consent),
                    questionnaire("before", 5, 2),
                    practiceOf(rating, 2),
                    rating,
                    trials(study, "pages", StageKind::parallel_rating, 2),
                    trials(study, "pairs", StageKind::pairwise, 2),
                    practiceOf(game, 1, 2),
                    game};
    std::vector<TargetItem> targets = targetsFor(study, 20);
    targets[3].placed = false;
    return planOf(study, targets, 7, {{"who", "them"}});
}

int firstOf(const StudyPlan& plan, const std::string& stage) {
    return trialsOf(plan, stage).front().index;
}

bool same(const Trial& a, const Trial& b) {
    const auto parts = [](const Trial& t) {
        return std::tie(t.index, t.stage, t.kind, t.practice, t.attempt, t.page, t.stimuli, t.layout,
                        t.distance, t.distractors, t.ball_order);
    };
    if (parts(a) != parts(b) || a.target != b.target || a.check.has_value() != b.check.has_value())
        return false;
    return !a.check || (a.check->kind == b.check->kind && a.check->stimulus == b.check->stimulus &&
                        a.check->expected == b.check->expected && a.check->of_trial == b.check->of_trial);
}

}  // namespace

TEST_SUITE("studies/plan_text") {
    TEST_CASE("A round trip through JSON gives the same plan and the same bytes.") {
        StudyPlan plan = everything();
        plan.seed = 18446744073709551615ULL;
        plan.study_name = "a \"quoted\" name\n";
        plan.trials[static_cast<std::size_t>(firstOf(plan, "game"))].target =
            Vec3(0.1 + 0.2, 1.0 / 3.0, -5e-324);
        const std::string json = planJson(plan);
        const Result<StudyPlan> back = planFromJson(json);
        if (!back) FAIL(back.error().text());
        CHECK(planJson(*back) == json);
        CHECK(back->participant == plan.participant);
        CHECK(back->number == 7);
        CHECK(back->study_name == plan.study_name);
        CHECK(back->study_hash == plan.study_hash);
        CHECK(back->seed == plan.seed);
        CHECK(back->groups == plan.groups);
        CHECK(back->stages == plan.stages);
        REQUIRE(back->trials.size() == plan.trials.size());
        for (std::size_t i = 0; i < plan.trials.size(); ++i) CHECK(same(back->trials[i], plan.trials[i]));
    }

    TEST_CASE("Each trial has the keys on which scripts rely.") {
        const StudyPlan plan = everything();
        const auto json = nlohmann::json::parse(planJson(plan));
        CHECK(json.at("number") == 7);
        CHECK(json.at("groups").at("who") == "them");
        CHECK(json.at("stages").size() == 8);
        CHECK(json.at("trials").size() == plan.trials.size());
        for (const auto& trial : json.at("trials"))
            for (const char* key : {"index", "stage", "kind", "practice", "attempt", "page", "stimuli",
                                    "layout", "distance", "target", "distractors", "ball_order", "check"})
                CHECK_MESSAGE(trial.contains(key), key);
        const auto& consent = json.at("trials").at(0);
        CHECK(consent.at("kind") == "consent");
        CHECK(consent.at("target").is_null());
        CHECK(consent.at("check").is_null());
        const auto& game = json.at("trials").at(firstOf(plan, "game"));
        CHECK(game.at("kind") == "referential-game");
        CHECK(game.at("target").size() == 3);
        CHECK(game.at("distractors").size() == 2);
        CHECK(game.at("stimuli").at(0).contains("item"));
    }

    TEST_CASE("JSON that is no plan is rejected with the place and the reason.") {
        const StudyPlan plan = everything();
        const auto whole = nlohmann::ordered_json::parse(planJson(plan));
        const int rating = firstOf(plan, "rating");
        const int game = firstOf(plan, "game");
        const int pairs = firstOf(plan, "pairs");
        const int pages = firstOf(plan, "pages");
        int number = 0, again = 0;
        for (const Trial& trial : plan.trials) {
            if (!trial.check) continue;
            if (trial.check->kind == CheckKind::number) number = trial.index;
            if (trial.check->kind == CheckKind::repeat) again = trial.index;
        }
        struct BadPlan {
            std::string pointer, value, where;
        };
        std::vector<BadPlan> bad{{"/participant", "5", "plan: participant"},
                                 {"/participant", "\"a b\"", "plan: participant"},
                                 {"/number", "0", "plan: number"},
                                 {"/number", "1.5", "plan: number"},
                                 {"/number", "4294967297", "plan: number"},
                                 {"/seed", "-1", "plan: seed"},
                                 {"/groups", "[]", "plan: groups"},
                                 {"/groups/who", "1", "plan: groups"},
                                 {"/stages/0", "1", "plan: stages"},
                                 {"/trials", "{}", "plan: trials"},
                                 {"/more", "1", "plan"}};
        const auto add = [&](int trial, const std::string& pointer, const std::string& value,
                             const std::string& where) {
            bad.push_back({fmt::format("/trials/{}{}", trial, pointer), value,
                           fmt::format("plan: trials[{}]{}", trial, where)});
        };
        add(3, "", "[]", "");
        add(3, "/colour", "1", "");
        add(3, "/index", "4", ".index");
        add(3, "/stage", "\"gane\"", ".stage");
        add(3, "/kind", "\"break\"", ".kind");
        add(3, "/kind", "\"gane\"", ".kind");
        add(3, "/practice", "1", ".practice");
        add(3, "/page", "-1", ".page");
        add(0, "/page", "1", ".page");
        add(0, "/stimuli", R"([{"system":"one","item":"T001"}])", ".stimuli");
        add(rating, "/attempt", "1", ".attempt");
        add(rating, "/stimuli", "[]", ".stimuli");
        add(rating, "/stimuli/0/item", "1", ".stimuli[0].item");
        add(rating, "/stimuli/0/more", "1", ".stimuli[0]");
        add(rating, "/distance", "\"near\"", ".distance");
        add(rating, "/target", "[1, 2]", ".target");
        add(rating, "/target", "[1, 2, null]", ".target");
        add(rating, "/distractors", "[[1, 2, 3]]", ".distractors");
        add(pairs, "/stimuli", R"([{"system":"one","item":"T001"}])", ".stimuli");
        add(pages, "/stimuli", R"([{"system":"one","item":"T001"}])", ".stimuli");
        add(game, "/target", "null", ".target");
        for (const char* order : {"[0, 1]", "[0, 1, 1]", "[0, 1, 3]", "[0, 1, 2, 0]", "[0, 1, -2]"})
            add(game, "/ball_order", order, ".ball_order");
        add(number, "/check/kind", "\"catsh\"", ".check.kind");
        add(number, "/check/stimulus", "1", ".check.stimulus");
        add(number, "/check/expected", "\"4\"", ".check.expected");
        add(number, "/check/of_trial", "0", ".check.of_trial");
        add(number, "/check", "4", ".check");
        add(again, "/check/of_trial", "-1", ".check.of_trial");
        add(again, "/check/of_trial", fmt::format("{}", again), ".check.of_trial");
        for (const BadPlan& edit : bad) {
            CAPTURE(edit.pointer);
            CAPTURE(edit.value);
            auto json = whole;
            json[nlohmann::ordered_json::json_pointer(edit.pointer)] =
                nlohmann::ordered_json::parse(edit.value);
            const Result<StudyPlan> read = planFromJson(json.dump());
            REQUIRE_FALSE(read.has_value());
            CHECK(read.error().where == edit.where);
            CHECK_FALSE(read.error().message.empty());
        }
        for (const auto& key : whole["trials"][7].items()) {
            auto json = whole;
            json["trials"][7].erase(key.key());
            const Result<StudyPlan> read = planFromJson(json.dump());
            REQUIRE_FALSE(read.has_value());
            CHECK(read.error().text() == fmt::format("plan: trials[7].{}: missing", key.key()));
        }
        for (const auto& key : whole.items()) {
            auto json = whole;
            json.erase(key.key());
            const Result<StudyPlan> read = planFromJson(json.dump());
            REQUIRE_FALSE(read.has_value());
            CHECK(read.error().text() == fmt::format("plan: {}: missing", key.key()));
        }
        for (const char* text : {"", "[]", "5", "{\"participant\":", "\xff"})
            CHECK_FALSE(planFromJson(text).has_value());
    }

    TEST_CASE("The table has a line for each trial, with what is shown and why.") {
        const StudyPlan plan = everything();
        const std::string table = planTable(plan);
        std::istringstream lines(table);
        std::string line;
        std::getline(lines, line);
        CHECK(line == "participant P0007 (number 7), study by-hand, seed 2023");
        std::getline(lines, line);
        CHECK(line == "who: them");
        std::getline(lines, line);
        CHECK(line.find("trial  stage") == 0);
        for (const Trial& trial : plan.trials) {
            CAPTURE(line);
            REQUIRE(std::getline(lines, line));
            CHECK(line.find(trial.stage) != std::string::npos);
            CHECK(line.find(trial.layout) != std::string::npos);
            for (const Stimulus& stimulus : trial.stimuli) {
                CHECK(line.find(stimulus.system) != std::string::npos);
                CHECK(line.find(stimulus.item) != std::string::npos);
            }
            if (trial.kind == StageKind::game)
                CHECK(line.find(fmt::format("target is ball {} of 3", trial.targetPlace() + 1)) !=
                      std::string::npos);
            if (trial.check && trial.check->kind == CheckKind::number)
                CHECK(line.find(fmt::format("asks for {} with", trial.check->expected)) != std::string::npos);
            if (trial.check && trial.check->kind == CheckKind::repeat)
                CHECK(line.find(fmt::format("trial {} again", trial.check->of_trial)) != std::string::npos);
            if (trial.attempt == 1) CHECK(line.find("practice, attempt 2") != std::string::npos);
        }
        CHECK_FALSE(std::getline(lines, line));
    }
}
