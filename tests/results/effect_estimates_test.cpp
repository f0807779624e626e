// Effects estimated from answers that were drawn from known ones.
#include "results/analysis/effect_estimates.hpp"

#include <doctest/doctest.h>

#include "studies/plan_fixture.hpp"
#include "studies/simulation/assumed_answers.hpp"

using namespace deixis;
using namespace deixis::results;
using namespace deixis::studies;

namespace {

/// A large study's answers under the effects.
ResponseTable drawn(const Study& study, const AssumedEffects& effects, int participants) {
    std::vector<StudyPlan> plans;
    std::vector<Groups> taken;
    GroupSizes sizes;
    for (int number = 1; number <= participants; ++number) {
        taken.push_back(assignGroups(study, sizes, number));
        ++sizes[taken.back()];
        plans.push_back(
            buildPlan(study, plan_fixture::targetsFor(study, 100), "S1", number, taken.back()).value());
    }
    const AssumedAnswers answers(study, effects, plans);
    std::vector<double> values(answers.planned().size());
    answers.draw(7, values);
    ResponseTable table;
    table.database = "drawn.sqlite";
    table.layouts = {"across", "side-by-side"};
    table.distances = {"near"};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const PlannedAnswer& planned = answers.planned()[i];
        ResponseRow row;
        row.participant = std::to_string(planned.participant);
        table.groups[row.participant] = taken[planned.participant];
        row.measure = answers.measures()[planned.measure].name;
        row.system = planned.trial->stimuli[0].system;
        row.layout = planned.trial->layout;
        row.distance = planned.trial->distance;
        row.target_id = planned.trial->stimuli[0].item;
        if (planned.trial->stimuli.size() > 1) row.other_system = planned.trial->stimuli[1].system;
        row.value = values[i];
        table.rows.push_back(row);
    }
    return table;
}

}  // namespace

TEST_SUITE("results/effect_estimates") {
    TEST_CASE("From many answers the effects come back that they were drawn from.") {
        Study study = plan_fixture::pointing();
        study.between = {{"training", {"none", "long"}}};
        AssumedEffects effects;
        effects.accuracy.emplace();
        effects.accuracy->groups["training"] = {{"none", -0.4}, {"long", 0.4}};
        effects.accuracy->systems = {
            {"demonstration-nn", 0.85}, {"direct", 0.95}, {"stiff", 0.8}, {"drifting", 0.45}};
        effects.accuracy->spread = {0.7, 0.6, 0.5};
        effects.accuracy->layouts = {{"across", 0.25}, {"side-by-side", -0.25}};
        effects.ratings["naturalness"].systems = {
            {"demonstration-nn", 4.1}, {"direct", 3.6}, {"stiff", 2.9}, {"drifting", 2.4}};
        effects.ratings["naturalness"].spread = {0.6, 0.5, 0.3};
        effects.ratings["naturalness"].noise_sd = 0.8;
        effects.ratings["naturalness"].groups["training"] = {{"none", 0.3}, {"long", -0.3}};
        const auto found = estimateEffects(drawn(study, effects, 500), study);
        REQUIRE(found.has_value());
        const AssumedAccuracy& accuracy = *found->effects.accuracy;
        for (const auto& [system, share] : effects.accuracy->systems)
            CHECK(accuracy.systems.at(system) == doctest::Approx(share).epsilon(0.04));
        CHECK(accuracy.spread.participant_sd == doctest::Approx(0.7).epsilon(0.15));
        CHECK(accuracy.spread.participant_system_sd == doctest::Approx(0.6).epsilon(0.2));
        CHECK(accuracy.spread.item_sd == doctest::Approx(0.5).epsilon(0.25));
        CHECK(accuracy.layouts.at("across") == doctest::Approx(0.25).epsilon(0.3));
        const AssumedRating& rating = found->effects.ratings.at("naturalness");
        for (const auto& [system, mean] : effects.ratings["naturalness"].systems)
            CHECK(rating.systems.at(system) == doctest::Approx(mean).epsilon(0.03));
        CHECK(rating.spread.participant_sd == doctest::Approx(0.6).epsilon(0.1));
        CHECK(rating.spread.participant_system_sd == doctest::Approx(0.5).epsilon(0.1));
        CHECK(rating.spread.item_sd == doctest::Approx(0.3).epsilon(0.25));
        CHECK(rating.noise_sd == doctest::Approx(0.8).epsilon(0.05));
        CHECK(accuracy.groups.at("training").at("long") == doctest::Approx(0.4).epsilon(0.25));
        CHECK(rating.groups.at("training").at("long") == doctest::Approx(-0.3).epsilon(0.25));
    }

    TEST_CASE("From many preferences strengths, zones and spread come back, as ratios to the noise.") {
        Study study = plan_fixture::studyOf({"x", "y", "z"});
        study.stages = {plan_fixture::trials(study, "pairs", StageKind::pairwise, 4)};
        AssumedEffects effects;
        effects.preference = {{{"x", 2.0}, {"y", 0.4}, {"z", -1.2}}, 1.0, 2.0, 0.6, 2.4};
        const ResponseTable table = drawn(study, effects, 800);
        const auto found = estimateEffects(table, study);
        REQUIRE(found.has_value());
        const AssumedPreference& preference = found->effects.preference.value();
        CHECK(preference.noise_sd == 1.0);
        CHECK(preference.systems.at("x") - preference.systems.at("y") == doctest::Approx(0.8).epsilon(0.06));
        CHECK(preference.systems.at("y") - preference.systems.at("z") == doctest::Approx(0.8).epsilon(0.06));
        CHECK(preference.participant_system_sd == doctest::Approx(0.5).epsilon(0.06));
        CHECK(preference.tie_zone == doctest::Approx(0.3).epsilon(0.06));
        CHECK(preference.clear_zone == doctest::Approx(1.2).epsilon(0.04));

        // Where z never wins, its strength has no end.
        ResponseTable won = table;
        std::erase_if(won.rows, [](const ResponseRow& row) {
            return row.value == 0.0 || (row.value < 0.0 ? row.system : row.other_system) == "z";
        });
        const auto none = estimateEffects(won, study);
        REQUIRE_FALSE(none.has_value());
        CHECK(none.error().text().find("that can be estimated") != std::string::npos);
    }

    TEST_CASE("Answers that lack a system, or are all alike, are rejected by name.") {
        const Study study = plan_fixture::pointing();
        AssumedEffects effects;
        for (const SystemSource& system : study.systems)
            effects.ratings["naturalness"].systems[system.name] = 3.0;
        ResponseTable table = drawn(study, effects, 10);
        ResponseTable alike = table;
        for (ResponseRow& row : alike.rows)
            if (row.system == "stiff") row.value = 1.0;
        const auto at_end = estimateEffects(alike, study);
        REQUIRE_FALSE(at_end.has_value());
        CHECK(at_end.error().text().find("\"stiff\" are 1") != std::string::npos);
        std::erase_if(table.rows, [](const ResponseRow& row) { return row.system == "direct"; });
        const auto lacking = estimateEffects(table, study);
        REQUIRE_FALSE(lacking.has_value());
        CHECK(lacking.error().text().find(
                  "drawn.sqlite: has no answer on naturalness for the system \"direct\"") !=
              std::string::npos);
    }
}
