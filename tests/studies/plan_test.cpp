#include "studies/plan.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/hash.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

const Study& pointing2023() {
    static const Study study = [] {
        Result<Study> loaded =
            loadStudy(std::filesystem::path(DEIXIS_SOURCE_DIR) / "assets/data/studies/pointing2023.toml");
        if (!loaded) FAIL(loaded.error().text());
        return *loaded;
    }();
    return study;
}

const std::vector<TargetItem>& itsTargets() {
    static const std::vector<TargetItem> targets =
        sampleTargets(pointing2023().targets, pointing2023().seed).value();
    return targets;
}

StudyPlan planFor(const Study& study, std::string_view participant) {
    Result<StudyPlan> plan = buildPlan(study, itsTargets(), participant);
    if (!plan) FAIL(plan.error().text());
    return *plan;
}

std::string participantId(int number) {
    return fmt::format("P{:04}", number);
}

}  // namespace

TEST_SUITE("studies/plan") {
    TEST_CASE("For 1,000 participants every plan is balanced as the paper's design asks.") {
        int wrong = 0;
        for (int number = 0; number < 1000; ++number) {
            const StudyPlan plan = planFor(pointing2023(), participantId(number));
            std::map<std::string, std::set<std::string>> rated, played, across, beside;
            std::set<std::string> scored, practised;
            for (const Trial& trial : plan.trials) {
                const bool game = trial.stage == StageKind::game;
                if (trial.practice) {
                    wrong += !practised.insert(trial.target_id).second;
                    continue;
                }
                scored.insert(trial.target_id);
                wrong += !(game ? played : rated)[trial.system].insert(trial.target_id).second;
                if (game)
                    wrong += !(trial.layout == "across" ? across : beside)[trial.system]
                                  .insert(trial.target_id)
                                  .second;
                if (!game)
                    wrong +=
                        trial.layout != "across" || !trial.ball_order.empty() || trial.targetPlace() != -1;
            }
            wrong += rated.size() != 4 || played.size() != 4 || scored.size() != 15 || practised.size() != 4;
            for (const auto& [system, targets] : rated)
                wrong += targets.size() != 5 || targets != rated["stiff"];
            for (const auto& [system, targets] : played)
                wrong += targets.size() != 10 || targets != played["stiff"];
            for (const auto& [system, targets] : across)
                wrong += targets.size() != 5 || targets != across["stiff"];
            for (const auto& [system, targets] : beside)
                wrong += targets.size() != 5 || targets != beside["stiff"];
            for (const std::string& target : practised) wrong += static_cast<int>(scored.count(target));
        }
        CHECK(wrong == 0);
    }

    TEST_CASE("A session is practice and ratings, then practice and games, numbered through.") {
        const StudyPlan plan = planFor(pointing2023(), "P01");
        REQUIRE(plan.trials.size() == 2 + 20 + 2 + 40);
        for (std::size_t i = 0; i < plan.trials.size(); ++i) {
            const Trial& trial = plan.trials[i];
            CHECK(trial.index == static_cast<int>(i));
            CHECK(trial.stage == (i < 22 ? StageKind::naturalness : StageKind::game));
            CHECK(trial.practice == (i < 2 || i == 22 || i == 23));
        }
        CHECK(plan.participant == "P01");
        CHECK(plan.study_name == "pointing2023");
        CHECK(plan.study_hash == pointing2023().hash);
        CHECK(plan.seed == 2023);
    }

    TEST_CASE("Practice shows four systems in four trials and both layouts of the game.") {
        for (int number = 0; number < 50; ++number) {
            std::set<std::string> systems, layouts;
            for (const Trial& trial : planFor(pointing2023(), participantId(number)).trials) {
                if (!trial.practice) continue;
                systems.insert(trial.system);
                if (trial.stage == StageKind::game) layouts.insert(trial.layout);
            }
            CHECK(systems.size() == 4);
            CHECK(layouts.size() == 2);
        }
    }

    TEST_CASE(
        "A trial carries the positions of its target and distractors, and its balls are a permutation of "
        "them.") {
        std::map<std::string, TargetItem> by_id;
        for (const TargetItem& item : itsTargets()) by_id[item.id] = item;
        for (const Trial& trial : planFor(pointing2023(), "P17").trials) {
            const TargetItem& item = by_id.at(trial.target_id);
            CHECK(trial.target == item.target);
            if (trial.stage == StageKind::naturalness) continue;
            CHECK(trial.distractors == item.distractors);
            REQUIRE(trial.ball_order.size() == 3);
            CHECK(trial.ball(trial.targetPlace()) == item.target);
            std::vector<Vec3> shown{trial.ball(0), trial.ball(1), trial.ball(2)};
            for (const Vec3& distractor : item.distractors)
                CHECK(std::count(shown.begin(), shown.end(), distractor) == 1);
            CHECK_THROWS(std::ignore = trial.ball(3));
        }
    }

    TEST_CASE("Orders differ between participants and systems come equally early and late.") {
        std::set<std::string> orders;
        std::map<std::string, double> place;
        constexpr int participants = 400;
        for (int number = 0; number < participants; ++number) {
            std::string order;
            for (const Trial& trial : planFor(pointing2023(), participantId(number)).trials) {
                if (trial.practice || trial.stage == StageKind::naturalness) continue;
                order += trial.system + trial.target_id + " ";
                place[trial.system] += (trial.index - 24) / (10.0 * participants);
            }
            orders.insert(order);
        }
        CHECK(orders.size() == participants);
        // The mean place of a system's 10 trials among 40: expected 19.5; SD of one participant's mean 3.2
        // (sampling without replacement: sqrt((40^2 - 1) / 12 / 10 * 30 / 39)), so 0.16 over 400.
        for (const auto& [system, mean] : place)
            CHECK(mean == doctest::Approx(19.5).epsilon(4 * 0.16 / 19.5));
    }

    TEST_CASE("Every target serves about equally often, and the target's place among the balls is uniform.") {
        std::map<std::string, int> used;
        int places[3] = {0, 0, 0};
        int first_index[3] = {0, 0, 0};
        constexpr int participants = 1000;
        for (int number = 0; number < participants; ++number) {
            bool first = true;
            for (const Trial& trial : planFor(pointing2023(), participantId(number)).trials) {
                if (trial.stage == StageKind::naturalness) continue;
                ++places[trial.targetPlace()];
                if (first) ++first_index[trial.targetPlace()];
                first = false;
                if (!trial.practice && trial.system == "direct") ++used[trial.target_id];
            }
        }
        const auto chiSquared = [](const int(&counts)[3]) {
            const double expected = (counts[0] + counts[1] + counts[2]) / 3.0;
            double sum = 0.0;
            for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
            return sum;
        };
        CHECK(places[0] + places[1] + places[2] == participants * 42);
        CHECK(chiSquared(places) < 13.816);  // 2 degrees of freedom, p = 0.001
        CHECK(chiSquared(first_index) < 13.816);
        CHECK(used.size() == 100);
        double sum = 0.0;
        for (const auto& [target, count] : used) sum += (count - 100.0) * (count - 100.0) / 100.0;
        CHECK(sum < 148.23);  // 99 degrees of freedom, p = 0.001; drawing without replacement only narrows it
        CHECK(sum > 50.0);    // and it is chance, not a rota
    }

    TEST_CASE(
        "Where items do not divide by layouts all systems share the split, and the odd item evens out.") {
        Study study = pointing2023();
        study.game.items = 9;
        int more_across = 0;
        for (int number = 0; number < 400; ++number) {
            std::map<std::string, int> across;
            for (const Trial& trial : planFor(study, participantId(number)).trials)
                if (!trial.practice && trial.stage == StageKind::game)
                    across[trial.system] += trial.layout == "across";
            for (const auto& [system, count] : across) {
                CHECK(count == across["direct"]);
                CHECK((count == 4 || count == 5));
            }
            more_across += across["direct"] == 5;
        }
        CHECK(std::abs(more_across - 200) < 40);  // four standard deviations of a fair coin
    }

    TEST_CASE("The plan of P01 in the study that ships is the same on every machine and compiler.") {
        StudyPlan plan = planFor(pointing2023(), "P01");
        plan.study_hash.clear();  // changes with every comment in the study file; the trials must not
        CHECK(sha256Hex(planJson(plan)) ==
              "f0ad0621acc156a68d93c43a6178b01c04ff017b9872ebd1e5b6563ad95b8e63");
    }

    TEST_CASE("Plans follow the seed and the participant, and not the study's texts.") {
        const std::string before = planJson(planFor(pointing2023(), "P01"));
        Study study = pointing2023();
        study.welcome = "Something else.";
        CHECK(planJson(planFor(study, "P01")) == before);
        study.seed += 1;
        CHECK(planJson(planFor(study, "P01")) != before);
        const auto trialsOf = [](std::string_view participant) {
            const std::string json = planJson(planFor(pointing2023(), participant));
            return json.substr(json.find("\"trials\""));
        };
        CHECK(trialsOf("P01") == trialsOf("P01"));
        CHECK(trialsOf("P01") != trialsOf("P02"));
    }

    TEST_CASE("Too few targets and ids that cannot name a participant are refused.") {
        const std::vector<TargetItem> few(itsTargets().begin(), itsTargets().begin() + 18);
        const Result<StudyPlan> plan = buildPlan(pointing2023(), few, "P01");
        REQUIRE_FALSE(plan.has_value());
        CHECK(plan.error().where == "targets.count");
        CHECK(plan.error().message.find("found 18 targets, expected at least 19") != std::string::npos);
        for (const std::string& bad :
             {std::string(), std::string("P 01"), std::string("../P01"), std::string(33, 'a'),
              std::string("P\0", 2), std::string("Zo\xc3\xab")}) {
            CHECK_FALSE(validParticipant(bad));
            CHECK_FALSE(buildPlan(pointing2023(), itsTargets(), bad).has_value());
        }
        for (const std::string& good : {std::string("P01"), std::string("a_b-C9"), std::string(32, 'a')})
            CHECK(validParticipant(good));
    }
}

TEST_SUITE("studies/plan_json") {
    TEST_CASE("A round trip through JSON gives the same plan and the same bytes.") {
        const StudyPlan plan = planFor(pointing2023(), "P01");
        const std::string json = planJson(plan);
        const Result<StudyPlan> back = planFromJson(json);
        if (!back) FAIL(back.error().text());
        CHECK(planJson(*back) == json);
        REQUIRE(back->trials.size() == plan.trials.size());
        for (std::size_t i = 0; i < plan.trials.size(); ++i) {
            const Trial& a = plan.trials[i];
            const Trial& b = back->trials[i];
            CHECK(a.target == b.target);
            CHECK(a.distractors == b.distractors);
            CHECK(a.ball_order == b.ball_order);
            CHECK(std::pair(a.system, a.layout) == std::pair(b.system, b.layout));
            CHECK(std::pair(a.stage, a.practice) == std::pair(b.stage, b.practice));
        }
        StudyPlan hard = plan;
        hard.seed = 18446744073709551615ULL;
        hard.study_name = "a \"quoted\" name\n";
        hard.trials[0].target = Vec3(0.1 + 0.2, 1.0 / 3.0, -5e-324);
        const Result<StudyPlan> hard_back = planFromJson(planJson(hard));
        REQUIRE(hard_back.has_value());
        CHECK(hard_back->seed == hard.seed);
        CHECK(hard_back->study_name == hard.study_name);
        CHECK(hard_back->trials[0].target == hard.trials[0].target);
    }

    TEST_CASE("Each trial has the keys on which scripts rely.") {
        const auto json = nlohmann::json::parse(planJson(planFor(pointing2023(), "P01")));
        CHECK(json.at("participant") == "P01");
        CHECK(json.at("trials").size() == 64);
        const auto& trial = json.at("trials").at(30);
        for (const char* key : {"stage", "system", "target_id", "layout", "practice", "index", "target",
                                "distractors", "ball_order"})
            CHECK_MESSAGE(trial.contains(key), key);
        CHECK(trial.at("stage") == "game");
        CHECK(trial.at("index") == 30);
        CHECK(trial.at("target").size() == 3);
        CHECK(trial.at("distractors").size() == 2);
    }

    TEST_CASE("JSON that is no plan is refused with the place and the reason.") {
        const auto whole = nlohmann::ordered_json::parse(planJson(planFor(pointing2023(), "P01")));
        struct BadPlan {
            std::string pointer, value, where;
        };
        const std::vector<BadPlan> bad{
            {"/participant", "5", "plan: participant"},
            {"/participant", "\"a b\"", "plan: participant"},
            {"/seed", "-1", "plan: seed"},
            {"/trials", "{}", "plan: trials"},
            {"/more", "1", "plan"},
            {"/trials/3", "[]", "plan: trials[3]"},
            {"/trials/3/index", "4", "plan: trials[3].index"},
            {"/trials/3/stage", "\"gane\"", "plan: trials[3].stage"},
            {"/trials/3/practice", "1", "plan: trials[3].practice"},
            {"/trials/3/target", "[1, 2]", "plan: trials[3].target"},
            {"/trials/3/target", "[1, 2, null]", "plan: trials[3].target"},
            {"/trials/3/distractors", "[[1, 2, 3]]", "plan: trials[3].distractors"},
            {"/trials/3/colour", "1", "plan: trials[3]"},
            {"/trials/30/ball_order", "[0, 1]", "plan: trials[30].ball_order"},
            {"/trials/30/ball_order", "[0, 1, 1]", "plan: trials[30].ball_order"},
            {"/trials/30/ball_order", "[0, 1, 3]", "plan: trials[30].ball_order"},
            {"/trials/30/ball_order", "[0, 1, 2, 0]", "plan: trials[30].ball_order"},
            {"/trials/30/ball_order", "[0, 1, -2]", "plan: trials[30].ball_order"},
        };
        for (const BadPlan& edit : bad) {
            CAPTURE(edit.pointer);
            CAPTURE(edit.value);
            auto json = whole;
            json[nlohmann::ordered_json::json_pointer(edit.pointer)] =
                nlohmann::ordered_json::parse(edit.value);
            const Result<StudyPlan> plan = planFromJson(json.dump());
            REQUIRE_FALSE(plan.has_value());
            CHECK(plan.error().where == edit.where);
            CHECK_FALSE(plan.error().message.empty());
        }
        for (const char* key : {"index", "stage", "practice", "system", "target_id", "layout", "target",
                                "distractors", "ball_order"}) {
            auto json = whole;
            json["trials"][7].erase(key);
            const Result<StudyPlan> plan = planFromJson(json.dump());
            REQUIRE_FALSE(plan.has_value());
            CHECK(plan.error().text() == fmt::format("plan: trials[7].{}: missing", key));
        }
        for (const char* text : {"", "[]", "5", "{\"participant\":", "\xff"})
            CHECK_FALSE(planFromJson(text).has_value());
    }

    TEST_CASE("Cut anywhere, the JSON of a plan is refused.") {
        const std::string json = planJson(planFor(pointing2023(), "P01"));
        for (std::size_t length = 0; length + 2 < json.size(); length += 97)
            CHECK_FALSE(planFromJson(std::string_view(json).substr(0, length)).has_value());
    }

    TEST_CASE("The table has a line for each trial, under a head that names participant, study and seed.") {
        const StudyPlan plan = planFor(pointing2023(), "P01");
        const std::string table = planTable(plan);
        CHECK(std::count(table.begin(), table.end(), '\n') == 2 + 64);
        CHECK(table.rfind("participant P01, study pointing2023, seed 2023\n", 0) == 0);
        const Trial& trial = plan.trials[40];
        const std::string line =
            fmt::format("   40  game         scored    {:<16}  {}    {:<12}  ball {} of 3\n", trial.system,
                        trial.target_id, trial.layout, trial.targetPlace() + 1);
        CHECK_MESSAGE(table.find(line) != std::string::npos, line);
    }
}
