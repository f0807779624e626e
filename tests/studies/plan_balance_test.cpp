// What every participant's plan, and those of 1,000 together, must hold.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "plan_fixture.hpp"
#include "studies/design/plan.hpp"

using namespace deixis;
using namespace deixis::studies;
using namespace deixis::studies::plan_fixture;

namespace {

constexpr int participants = 1000;
constexpr int some_participants = 200;  // where many designs are tried

using Counts = std::map<std::string, int>;

/// The largest count less the smallest, of `levels` levels of which some may not have been met.
int spread(const Counts& counts, std::size_t levels) {
    int min = counts.size() < levels ? 0 : counts.begin()->second;
    int max = 0;
    for (const auto& entry : counts) {
        min = std::min(min, entry.second);
        max = std::max(max, entry.second);
    }
    return max - min;
}

/// Whether a set of trials, each an item and a system, can be put into an order under the limits: by trying
/// them all.
bool someOrderExists(std::vector<std::pair<int, int>> trials, int max_run, bool items_apart) {
    std::sort(trials.begin(), trials.end());
    do {
        bool good = true;
        int run = 1;
        for (std::size_t i = 1; i < trials.size() && good; ++i) {
            run = trials[i].second == trials[i - 1].second ? run + 1 : 1;
            good =
                (max_run == 0 || run <= max_run) && !(items_apart && trials[i].first == trials[i - 1].first);
        }
        if (good) return true;
    } while (std::next_permutation(trials.begin(), trials.end()));
    return false;
}

}  // namespace

TEST_SUITE("studies/plan_balance") {
    TEST_CASE("For 1,000 participants every plan is balanced as the paper's design asks.") {
        const Study study = pointing();
        const std::vector<TargetItem> targets = targetsFor(study, 100);
        int wrong = 0;
        for (int number = 1; number <= participants; ++number) {
            std::map<std::string, std::set<std::string>> rated, played, across, beside;
            std::set<std::string> scored, practised;
            for (const Trial& trial : planOf(study, targets, number).trials) {
                const Stimulus& stimulus = trial.stimuli.front();
                const bool game = trial.kind == StageKind::game;
                if (trial.practice) {
                    wrong += !practised.insert(stimulus.item).second;
                    continue;
                }
                scored.insert(stimulus.item);
                wrong += !(game ? played : rated)[stimulus.system].insert(stimulus.item).second;
                if (game)
                    wrong += !(trial.layout == "across" ? across : beside)[stimulus.system]
                                  .insert(stimulus.item)
                                  .second;
                else
                    wrong += trial.layout != "across";
            }
            wrong += rated.size() != 4 || played.size() != 4 || scored.size() != 15 || practised.size() != 4;
            for (const auto& entry : rated)
                wrong += entry.second.size() != 5 || entry.second != rated["stiff"];
            for (const auto& entry : played)
                wrong += entry.second.size() != 10 || entry.second != played["stiff"];
            for (const auto& entry : across)
                wrong += entry.second.size() != 5 || entry.second != across["stiff"];
            for (const auto& entry : beside)
                wrong += entry.second.size() != 5 || entry.second != beside["stiff"];
            for (const std::string& item : practised) wrong += static_cast<int>(scored.count(item));
        }
        CHECK(wrong == 0);
    }

    TEST_CASE("Nested layouts and distances share items out evenly, alone and together, each system alike.") {
        Study study = studyOf({"a", "b", "c"});
        study.distances.push_back({"middle", {0.4, 0.8}, 2});
        study.stages = {trials(study, "game", StageKind::game, 1)};
        TrialDesign& design = study.stages[0].design;
        design.distances = {"near", "middle", "far"};
        const std::vector<TargetItem> targets = targetsFor(study, 40);
        for (const int items : {1, 4, 5, 6, 7, 9, 12, 17}) {
            CAPTURE(items);
            design.items = items;
            int wrong = 0;
            Counts odd_ones;
            for (int number = 1; number <= some_participants; ++number) {
                std::map<std::string, Counts> layouts, distances, both;
                std::map<std::string, std::set<std::string>> kept;
                for (const Trial& trial : planOf(study, targets, number).trials) {
                    const Stimulus& stimulus = trial.stimuli.front();
                    ++layouts[stimulus.system][trial.layout];
                    ++distances[stimulus.system][trial.distance];
                    ++both[stimulus.system][trial.layout + trial.distance];
                    kept[stimulus.item].insert(trial.layout + trial.distance);
                }
                for (const auto& item : kept) wrong += item.second.size() != 1;
                for (const char* system : {"a", "b", "c"}) {
                    wrong += spread(layouts[system], 2) != (items % 2 == 0 ? 0 : 1);
                    wrong += spread(distances[system], 3) != (items % 3 == 0 ? 0 : 1);
                    wrong += spread(both[system], 6) != (items % 6 == 0 ? 0 : 1);
                    wrong += both[system] != both["a"];
                }
                odd_ones["across"] += layouts["a"]["across"] > layouts["a"]["side-by-side"];
                odd_ones["far"] += distances["a"]["far"] > distances["a"]["near"];
                odd_ones["near"] += distances["a"]["near"] > distances["a"]["far"];
            }
            CHECK(wrong == 0);
            // Four standard deviations of a fair coin: chance gives the odd ones out.
            if (items % 2 == 1) CHECK(std::abs(odd_ones["across"] - some_participants / 2) < 29);
            CHECK(std::abs(odd_ones["far"] - odd_ones["near"]) < 2 * 29);
            if (items % 3 != 0) CHECK(odd_ones["far"] > some_participants / 4);
        }
    }

    TEST_CASE("Where an item has one system only, systems, layouts and distances are balanced in pairs.") {
        Study study = studyOf({"a", "b", "c", "d"});
        study.stages = {trials(study, "game", StageKind::game, 8)};
        TrialDesign& design = study.stages[0].design;
        design.system_meets = Crossing::nested;
        design.distances = {"near", "far"};
        const std::vector<TargetItem> targets = targetsFor(study, 40);
        for (const int items : {8, 12, 16, 24}) {
            CAPTURE(items);
            design.items = items;
            int wrong = 0;
            for (int number = 1; number <= some_participants; ++number) {
                Counts systems, of_layout, of_distance, both;
                for (const Trial& trial : planOf(study, targets, number).trials) {
                    const std::string& system = trial.stimuli.front().system;
                    ++systems[system];
                    ++of_layout[system + trial.layout];
                    ++of_distance[system + trial.distance];
                    ++both[trial.layout + trial.distance];
                }
                wrong += spread(systems, 4) != 0;
                wrong += spread(of_layout, 8) != (items % 8 == 0 ? 0 : 1);
                wrong += spread(of_distance, 8) != (items % 8 == 0 ? 0 : 1);
                wrong += spread(both, 4) != 0;
            }
            CHECK(wrong == 0);
        }
    }

    TEST_CASE("Crossed levels meet every item once under every system.") {
        Study study = studyOf({"a", "b"});
        study.stages = {trials(study, "game", StageKind::game, 3)};
        study.stages[0].design.distances = {"near", "far"};
        study.stages[0].design.layout_meets = Crossing::crossed;
        study.stages[0].design.distance_meets = Crossing::crossed;
        Counts met;
        for (const Trial& trial : planOf(study, targetsFor(study, 10), 1).trials)
            ++met[trial.stimuli[0].item + trial.stimuli[0].system + trial.layout + trial.distance];
        CHECK(met.size() == 3 * 2 * 2 * 2);
        for (const auto& entry : met) CHECK(entry.second == 1);
    }

    TEST_CASE("Blocks by a Williams square are balanced within each cell of a design with groups, too.") {
        Study study = studyOf({"a", "b", "c", "d"});
        study.between = {{"training", {"feedback", "none"}}, {"hand", {"left", "right"}}};
        study.stages = {trials(study, "rating", StageKind::rating, 2)};
        study.stages[0].design.block_by = "system";
        study.stages[0].design.block_order = BlockOrder::williams;
        const std::vector<TargetItem> targets = targetsFor(study, 4);
        constexpr int rows = 4;
        constexpr int cells = 4;
        std::map<Groups, std::set<std::string>> first_block;  // by cell: the systems that began
        GroupSizes sizes;
        for (int number = 1; number <= rows * cells; ++number) {
            const Assignment turn = assignmentOf(study, number);
            CHECK(turn.groups == assignGroups(study, sizes, number));
            CHECK(turn.number_in_cell == ++sizes[turn.groups]);
            const Result<StudyPlan> plan =
                buildPlan(study, targets, "P1", number, turn.groups, turn.number_in_cell);
            REQUIRE(plan.has_value());
            first_block[turn.groups].insert(plan->trials.front().stimuli.front().system);
            CHECK(planJson(planFromJson(planJson(*plan)).value()) == planJson(*plan));
        }
        CHECK(first_block.size() == cells);
        for (const auto& cell : first_block) CHECK(cell.second.size() == rows);
        const Groups asked{{"training", "none"}, {"hand", "left"}};
        CHECK(assignmentOf(study, 1, asked).number_in_cell == 1);
        CHECK(assignmentOf(study, 17, asked).number_in_cell == 5);
    }

    TEST_CASE("Blocks by a Williams square: every place and every succession equally often, over 1,000.") {
        for (const int systems : {2, 4, 5}) {  // rows: 2, 4, 10, which all go into 1,000
            CAPTURE(systems);
            Study study = studyOf({"a", "b", "c", "d", "e"});
            study.systems.resize(static_cast<std::size_t>(systems));
            study.stages = {trials(study, "rating", StageKind::rating, 3)};
            study.stages[0].design.block_by = "system";
            study.stages[0].design.block_order = BlockOrder::williams;
            const std::vector<TargetItem> targets = targetsFor(study, 10);
            Counts in_place, after;
            int wrong = 0;
            for (int number = 1; number <= participants; ++number) {
                const StudyPlan plan = planOf(study, targets, number);
                for (std::size_t i = 0; i < plan.trials.size(); ++i) {
                    const std::string& system = plan.trials[i].stimuli[0].system;
                    if (i % 3 != 0) {
                        wrong += system != plan.trials[i - 1].stimuli[0].system;
                        continue;
                    }
                    ++in_place[fmt::format("{}{}", system, i / 3)];
                    if (i > 0) ++after[plan.trials[i - 1].stimuli[0].system + system];
                }
            }
            CHECK(wrong == 0);
            CHECK(static_cast<int>(in_place.size()) == systems * systems);
            CHECK(static_cast<int>(after.size()) == systems * (systems - 1));
            for (const auto& entry : in_place) CHECK(entry.second == participants / systems);
            for (const auto& entry : after) CHECK(entry.second == participants / systems);
        }
    }

    TEST_CASE("A pair's systems stand left and right equally often, in each layout, the odd one by chance.") {
        Study study = studyOf({"a", "b", "c"});
        study.stages = {trials(study, "pairs", StageKind::pairwise, 6)};
        TrialDesign& design = study.stages[0].design;
        design.layouts = {"across", "side-by-side"};
        const std::vector<TargetItem> targets = targetsFor(study, 20);
        int more_left = 0;
        int wrong = 0;
        for (int number = 1; number <= participants; ++number) {
            for (const int items : {6, 8}) {
                design.items = items;
                Counts left, left_by_layout, pairs;
                for (const Trial& trial : planOf(study, targets, number).trials) {
                    const std::string& l = trial.stimuli[0].system;
                    const std::string& r = trial.stimuli[1].system;
                    const std::string pair = std::min(l, r) + std::max(l, r);
                    ++pairs[pair];
                    left[pair] += l < r;
                    left_by_layout[pair + trial.layout] += l < r;
                }
                wrong += pairs != Counts{{"ab", items}, {"ac", items}, {"bc", items}};
                for (const auto& entry : left) wrong += entry.second != items / 2;
                for (const auto& entry : left_by_layout)  // of 3 or 4
                    wrong += items == 8 ? entry.second != 2 : entry.second != 1 && entry.second != 2;
                more_left += items == 6 && left_by_layout["abacross"] == 2;
            }
        }
        CHECK(wrong == 0);
        CHECK(std::abs(more_left - participants / 2) < 64);
    }

    TEST_CASE("Where an item meets one pair only, the pairs share the items out.") {
        Study study = studyOf({"a", "b", "c"});
        study.stages = {trials(study, "pairs", StageKind::pairwise, 12)};
        study.stages[0].design.system_meets = Crossing::nested;
        for (int number = 1; number <= 100; ++number) {
            const StudyPlan plan = planOf(study, targetsFor(study, 20), number);
            CHECK(plan.trials.size() == 12);
            Counts pairs, left;
            for (const Trial& trial : plan.trials) {
                ++pairs[std::min(trial.stimuli[0], trial.stimuli[1]).system +
                        std::max(trial.stimuli[0], trial.stimuli[1]).system];
                ++left[trial.stimuli[0].system];
            }
            CHECK(pairs == Counts{{"ab", 4}, {"ac", 4}, {"bc", 4}});
            CHECK(left == Counts{{"a", 4}, {"b", 4}, {"c", 4}});
        }
    }

    TEST_CASE("Limits on runs hold for 1,000 participants, with blocks and checks too.") {
        Study study = pointing();
        study.distances = studyOf({}).distances;
        for (Stage& stage : study.stages) {
            stage.design.max_run_of_system = 2;
            stage.design.no_target_twice_running = true;
        }
        study.stages[5].design.block_by = "layout";
        study.stages[5].checks = {check(CheckKind::catch_trial, 2)};
        study.stages[2].design.max_run_of_system = 1;
        study.stages[2].checks = {check(CheckKind::repeat, 2)};
        const std::vector<TargetItem> targets = targetsFor(study, 100);
        int wrong = 0;
        for (int number = 1; number <= participants; ++number) {
            const StudyPlan plan = planOf(study, targets, number);
            for (const char* name : {"naturalness", "game"}) {
                const std::vector<Trial> trials = trialsOf(plan, name);
                const int limit = name == std::string("game") ? 2 : 1;
                int run = 1;
                int changes = 0;
                for (std::size_t i = 1; i < trials.size(); ++i) {
                    const Stimulus& now = trials[i].stimuli[0];
                    const Stimulus& before = trials[i - 1].stimuli[0];
                    run = now.system == before.system ? run + 1 : 1;
                    wrong += run > limit || now.item == before.item;
                    changes += trials[i].layout != trials[i - 1].layout;
                }
                wrong += changes > 1;
            }
        }
        CHECK(wrong == 0);
    }

    TEST_CASE("An order is found exactly where one exists, as trying all orders of small designs shows.") {
        int possible = 0;
        int impossible = 0;
        for (int systems = 1; systems <= 4; ++systems)
            for (int items = 1; items * systems <= 8; ++items)
                for (const int max_run : {0, 1, 2})
                    for (const bool apart : {false, true}) {
                        Study study = studyOf({"a", "b", "c", "d"});
                        study.systems.resize(static_cast<std::size_t>(systems));
                        study.stages = {trials(study, "rating", StageKind::rating, items)};
                        study.stages[0].design.max_run_of_system = max_run;
                        study.stages[0].design.no_target_twice_running = apart;
                        std::vector<std::pair<int, int>> pairs;
                        for (int i = 0; i < items * systems; ++i)
                            pairs.emplace_back(i / systems, i % systems);
                        const bool exists = someOrderExists(pairs, max_run, apart);
                        (exists ? possible : impossible) += 1;
                        CAPTURE(systems);
                        CAPTURE(items);
                        CAPTURE(max_run);
                        CAPTURE(apart);
                        for (int number = 1; number <= 20; ++number) {
                            const Result<StudyPlan> plan =
                                buildPlan(study, targetsFor(study, items), "P1", number, {});
                            CHECK(plan.has_value() == exists);
                            if (plan) continue;
                            CHECK(plan.error().where.find("stages.rating.") == 0);
                            CHECK(plan.error().message.find(
                                      fmt::format("found no order of the {} trials", items * systems)) == 0);
                        }
                    }
        CHECK(possible > 20);
        CHECK(impossible > 10);
    }

    TEST_CASE("Tight limits on large stages are met, and a page that shows all systems cannot meet one.") {
        for (const int systems : {2, 3, 4, 6})
            for (const int items : {3, 6, 10, 25}) {
                CAPTURE(systems);
                CAPTURE(items);
                Study study = studyOf({"a", "b", "c", "d", "e", "f"});
                study.systems.resize(static_cast<std::size_t>(systems));
                study.stages = {trials(study, "rating", StageKind::rating, items)};
                study.stages[0].design.max_run_of_system = 1;
                study.stages[0].design.no_target_twice_running = true;
                for (int number = 1; number <= 50; ++number)
                    CHECK(buildPlan(study, targetsFor(study, items), "P1", number, {}).has_value());
            }
        Study study = studyOf({"a", "b"});
        study.stages = {trials(study, "pages", StageKind::parallel_rating, 5)};
        study.stages[0].design.max_run_of_system = 2;
        const Result<StudyPlan> plan = buildPlan(study, targetsFor(study, 5), "P1", 1, {});
        REQUIRE_FALSE(plan.has_value());
        CHECK(plan.error().where == "stages.pages.max_run_of_system");
    }

    TEST_CASE("Under limits systems still come equally early and late, and orders differ.") {
        Study study = pointing();
        study.stages[5].design.max_run_of_system = 2;
        study.stages[5].design.no_target_twice_running = true;
        const std::vector<TargetItem> targets = targetsFor(study, 100);
        std::set<std::string> orders;
        std::map<std::string, double> place;
        for (int number = 1; number <= participants; ++number) {
            std::string order;
            const std::vector<Trial> trials = trialsOf(planOf(study, targets, number), "game");
            for (std::size_t i = 0; i < trials.size(); ++i) {
                order += trials[i].stimuli[0].system + " ";
                place[trials[i].stimuli[0].system] += static_cast<double>(i) / (10.0 * participants);
            }
            orders.insert(order);
        }
        CHECK(orders.size() == participants);
        // The mean place of a system's 10 trials among 40: expected 19.5; SD of one participant's mean at
        // most 3.2 (sampling without replacement: sqrt((40^2 - 1) / 12 / 10 * 30 / 39)), so 0.1 over 1,000.
        for (const auto& entry : place) CHECK(std::abs(entry.second - 19.5) < 4 * 0.1);
    }

    TEST_CASE("Every target serves about equally often, and the target's place among the balls is uniform.") {
        const Study study = pointing();
        const std::vector<TargetItem> targets = targetsFor(study, 100);
        Counts used;
        int places[3] = {0, 0, 0};
        for (int number = 1; number <= participants; ++number)
            for (const Trial& trial : planOf(study, targets, number).trials) {
                if (trial.kind != StageKind::game) continue;
                ++places[trial.targetPlace()];
                if (!trial.practice && trial.stimuli[0].system == "direct") ++used[trial.stimuli[0].item];
            }
        double sum = 0.0;
        for (const int count : places)
            sum += (count - participants * 14.0) * (count - participants * 14.0) / (participants * 14.0);
        CHECK(sum < 13.816);  // 2 degrees of freedom, p = 0.001
        CHECK(used.size() == 100);
        sum = 0.0;
        for (const auto& entry : used) sum += (entry.second - 100.0) * (entry.second - 100.0) / 100.0;
        CHECK(sum < 148.23);  // 99 degrees of freedom, p = 0.001; drawing without replacement only narrows it
        CHECK(sum > 50.0);    // and it is chance, not a rota
    }

    TEST_CASE("A page's systems come in every place equally often, as chance has it.") {
        const Study study = rating();
        const std::vector<TargetItem> targets = targetsFor(study, 20);
        std::map<std::string, Counts> places;
        for (int number = 1; number <= participants; ++number)
            for (const Trial& trial : planOf(study, targets, number, {{"measure", "appropriateness"}}).trials)
                for (std::size_t i = 0; i < trial.stimuli.size() && !trial.practice; ++i)
                    ++places[fmt::format("{}", i)][trial.stimuli[i].system];
        REQUIRE(places.size() == 4);
        for (const auto& place : places)
            for (const auto& system : place.second)
                CHECK(std::abs(system.second - 3000) < 4 * 47.5);  // SD sqrt(12,000 / 4 * 3 / 4)
    }
}
