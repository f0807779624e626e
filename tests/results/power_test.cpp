// Power: against exact and simulated power made by other programs, and what must hold of every power
// analysis.
#include "results/analysis/power.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "paths.hpp"
#include "studies/plan_fixture.hpp"

using namespace deixis;
using namespace deixis::results;
using namespace deixis::studies;

namespace {

nlohmann::json powerOracle() {
    std::ifstream in(deixis::tests::sourceDir() / "tests/results/oracles/power.json");
    return nlohmann::json::parse(in);
}

/// Two systems, or as many as named, and one stage.
Study oneStage(StageKind kind, int items, const std::vector<std::string>& systems = {"x", "y"}) {
    Study study = plan_fixture::studyOf(systems);
    study.distances.resize(1);
    study.alpha = 0.05;
    Stage stage = plan_fixture::trials(study, "stage", kind, items);
    stage.design.layouts = {"across"};
    study.stages = {stage};
    return study;
}

PowerResult powerOf(const Study& study, const AssumedEffects& effects, const std::vector<int>& participants,
                    const PowerOptions& options) {
    auto power = PowerAnalysis::make(study, plan_fixture::targetsFor(study, 100), effects,
                                     *std::max_element(participants.begin(), participants.end()), options);
    REQUIRE(power.has_value());
    power->simulate(participants, [](std::size_t, std::size_t) {});
    return power->result();
}

PowerOptions manyStudies(int studies, std::uint64_t seed = 1, unsigned threads = 2) {
    PowerOptions out;
    out.studies = studies;
    out.seed = seed;
    out.threads = threads;
    return out;
}

/// Of four standard errors of either simulation.
bool agrees(double share, double expected, int studies, double other_se = 0.0) {
    const double variance = std::max(expected * (1.0 - expected), 1.0 / studies) / studies;
    return std::abs(share - expected) <= 4.0 * std::sqrt(variance + other_se * other_se);
}

/// Four systems that do not differ, in a rating and a game.
AssumedEffects noEffect(const Study& study) {
    AssumedEffects effects;
    effects.accuracy.emplace();
    effects.accuracy->spread = {0.6, 0.5, 0.5};
    effects.accuracy->lapse_rate = 0.05;
    AssumedRating rating;
    rating.spread = {0.5, 0.4, 0.3};
    for (const SystemSource& system : study.systems) {
        effects.accuracy->systems[system.name] = 0.75;
        rating.systems[system.name] = 3.4;
    }
    effects.ratings["naturalness"] = rating;
    return effects;
}

}  // namespace

TEST_SUITE("results/power") {
    TEST_CASE("The power of a game with one choice a system is that of the sign test, computed exactly.") {
        const auto oracle = powerOracle();
        constexpr int studies = 3000;
        for (const auto& one : oracle["games"]) {
            const Study study = oneStage(StageKind::game, 1);
            AssumedEffects effects;
            effects.accuracy.emplace();
            effects.accuracy->systems = {{"x", one["shares"][0]}, {"y", one["shares"][1]}};
            const int n = one["participants"];
            const PowerResult power = powerOf(study, effects, {n}, manyStudies(studies, 11));
            REQUIRE(power.contrasts.size() == 1);
            const Found found = power.contrasts[0].found.at(n);
            INFO(one.dump() << " found " << found.a_higher << " and " << found.b_higher);
            CHECK(agrees(static_cast<double>(found.a_higher) / studies, one["a_higher"], studies));
            CHECK(agrees(static_cast<double>(found.b_higher) / studies, one["b_higher"], studies));
        }
    }

    TEST_CASE("The power of ratings agrees with a simulation in NumPy and SciPy.") {
        const auto oracle = powerOracle();
        constexpr int studies = 3000;
        for (const auto& one : oracle["ratings"]) {
            const Study study = oneStage(StageKind::rating, one["items"]);
            AssumedEffects effects;
            AssumedRating& rating = effects.ratings["naturalness"];
            rating.systems = {{"x", one["means"][0]}, {"y", one["means"][1]}};
            rating.spread = {one["participant_sd"], one["participant_system_sd"], one["item_sd"]};
            rating.noise_sd = one["noise_sd"];
            const int n = one["participants"];
            const PowerResult power = powerOf(study, effects, {n}, manyStudies(studies, 12));
            const double share = static_cast<double>(power.contrasts[0].found.at(n).either()) / studies;
            INFO(one.dump() << " found " << share);
            CHECK(agrees(share, one["power"], studies, one["se"]));
        }
    }

    TEST_CASE(
        "Without any effect the family-wise error does not exceed alpha, and with a large one all is "
        "found.") {
        Study study = plan_fixture::pointing();
        study.alpha = 0.05;
        AssumedEffects effects = noEffect(study);
        constexpr int studies = 600;
        const PowerResult none = powerOf(study, effects, {8, 16}, manyStudies(studies, 5));
        // Six pairs in each of two measures, four systems by two layouts.
        REQUIRE(none.families.size() == 3);
        for (const FamilyPower& family : none.families)
            for (const auto& any : family.any) {
                INFO(family.name << " of " << any.first << ": " << any.second);
                CHECK(*none.share(any.second).lower <= study.alpha);
            }
        effects.accuracy->systems = {
            {"demonstration-nn", 0.95}, {"direct", 0.8}, {"stiff", 0.6}, {"drifting", 0.35}};
        effects.ratings["naturalness"].systems = {
            {"demonstration-nn", 4.6}, {"direct", 3.5}, {"stiff", 2.4}, {"drifting", 1.4}};
        const PowerResult large = powerOf(study, effects, {40}, manyStudies(100, 5));
        CHECK(large.families[0].all.at(40) > 50);
        CHECK(large.families[1].all.at(40) > 95);
    }

    TEST_CASE("The numbers depend on the seed, and neither on threads nor on what else is simulated.") {
        const Study study = oneStage(StageKind::rating, 4, {"x", "y", "z"});
        AssumedEffects effects;
        AssumedRating& rating = effects.ratings["naturalness"];
        rating.systems = {{"x", 3.0}, {"y", 3.5}, {"z", 3.8}};
        rating.spread = {0.5, 0.4, 0.2};
        const auto json = [&](const std::vector<int>& participants, std::uint64_t seed, unsigned threads) {
            return powerJson(powerOf(study, effects, participants, manyStudies(150, seed, threads)), 0.8);
        };
        CHECK(json({6, 12}, 3, 1) == json({12, 6}, 3, 3));
        CHECK(json({6, 12}, 3, 1) != json({6, 12}, 4, 1));
        const PowerResult both = powerOf(study, effects, {6, 12}, manyStudies(150, 3));
        const PowerResult one = powerOf(study, effects, {6}, manyStudies(150, 3));
        for (std::size_t i = 0; i < one.contrasts.size(); ++i)
            CHECK(one.contrasts[i].found.at(6).either() == both.contrasts[i].found.at(6).either());
    }

    TEST_CASE(
        "The search ends at a number of participants that reaches the goal, next to one that does not.") {
        const Study study = oneStage(StageKind::rating, 3);
        AssumedEffects effects;
        effects.ratings["naturalness"].systems = {{"x", 3.0}, {"y", 3.6}};
        effects.ratings["naturalness"].spread = {0.5, 0.4, 0.2};
        auto power =
            PowerAnalysis::make(study, plan_fixture::targetsFor(study, 100), effects, 40, manyStudies(300));
        REQUIRE(power.has_value());
        const auto silent = [](std::size_t, std::size_t) {};
        power->simulate({4, 40}, silent);
        CHECK(participantsFor(power->result(), power->result().contrasts[0], 0.8) == 40);
        searchParticipants(*power, 0.8, silent);
        const ContrastPower& contrast = power->result().contrasts[0];
        const auto enough = participantsFor(power->result(), contrast, 0.8);
        REQUIRE(enough.has_value());
        CHECK(*enough < 40);
        CHECK(contrast.found.at(*enough).either() >= 240);
        REQUIRE(contrast.found.contains(*enough - 1));
        CHECK(contrast.found.at(*enough - 1).either() < 240);
    }

    TEST_CASE(
        "Preferences and measures by group are simulated, and a measure without assumptions is named.") {
        Study pairs = oneStage(StageKind::pairwise, 6, {"x", "y", "z"});
        AssumedEffects effects;
        effects.preference = {{{"x", 1.5}, {"y", 0.0}, {"z", 0.0}}, 0.3, 1.0, 0.4, 1.2};
        const PowerResult preferred = powerOf(pairs, effects, {20}, manyStudies(100));
        REQUIRE(preferred.contrasts.size() == 3);
        CHECK(preferred.contrasts[0].found.at(20).a_higher > 90);  // x against y
        CHECK(preferred.contrasts[2].found.at(20).either() < 15);  // y against z

        // Factors that are nested in the systems are compared over them, as in the report.
        Study nested = oneStage(StageKind::rating, 3, {"x", "y", "z"});
        for (SystemSource& system : nested.systems)
            system.levels = {{"hold", system.name == "x" ? "long" : "short"}};
        AssumedEffects higher;
        higher.ratings["naturalness"].systems = {{"x", 4.0}, {"y", 2.5}, {"z", 2.5}};
        const PowerResult by_level = powerOf(nested, higher, {20}, manyStudies(50));
        REQUIRE(by_level.families.size() == 2);
        CHECK(by_level.families[1].name == "naturalness: hold over systems");
        const ContrastPower& hold = by_level.contrasts.back();
        CHECK(hold.a == "long");
        CHECK(hold.found.at(20).a_higher > 45);

        // Groups differ where they are assumed to, and by no more than the error where they are not.
        Study grouped = oneStage(StageKind::rating, 4);
        grouped.between = {{"training", {"none", "long"}}, {"hand", {"left", "right"}}};
        AssumedEffects trained;
        trained.ratings["naturalness"].systems = {{"x", 3.0}, {"y", 3.0}};
        trained.ratings["naturalness"].spread = {0.5, 0.2, 0.2};
        trained.ratings["naturalness"].groups["training"] = {{"none", -0.6}, {"long", 0.6}};
        const PowerResult of_groups = powerOf(grouped, trained, {40}, manyStudies(200));
        REQUIRE(of_groups.families.size() == 3);  // of systems, and of either factor: all, x, y
        CHECK(of_groups.families[1].name == "naturalness: training");
        CHECK(of_groups.families[1].tests == 3);
        CHECK(of_groups.contrasts[1].system == "all");
        CHECK(of_groups.contrasts[1].found.at(40).b_higher > 180);
        CHECK(*of_groups.share(of_groups.families[2].any.at(40)).lower <= grouped.alpha);

        const Study groups = plan_fixture::rating();
        AssumedEffects one;
        for (const SystemSource& system : groups.systems)
            one.ratings["human-likeness"].systems[system.name] = system.name == "manual" ? 70.0 : 40.0;
        one.ratings["human-likeness"].noise_sd = 15.0;
        const PowerResult by_group = powerOf(groups, one, {30}, manyStudies(50));
        CHECK(by_group.not_simulated == std::vector<std::string>{"appropriateness"});
        for (const ContrastPower& contrast : by_group.contrasts) {
            const bool differ = contrast.a == "manual" || contrast.b == "manual";
            CHECK((contrast.found.at(30).either() > 40) == differ);
        }
    }
}
