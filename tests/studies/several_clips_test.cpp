// A system may have several clips for an item; a plan draws one of them for each participant.
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "plan_fixture.hpp"
#include "studies/design/targets.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

/// Pages with four systems, and a rating with a repeat, so that a clip comes more than once.
Study rushedStudy() {
    Study study = plan_fixture::studyOf({"ref", "auto", "sgt", "manual"});
    study.stages.push_back(plan_fixture::trials(study, "pages", StageKind::parallel_rating, 8));
    study.stages.back().scale.high = 100;
    Stage single = plan_fixture::trials(study, "single", StageKind::rating, 4);
    single.checks.push_back(plan_fixture::check(CheckKind::repeat, 2));
    study.stages.push_back(single);
    return study;
}

std::vector<TargetItem> twelve(const Study& study, bool several) {
    Study sampled = study;
    sampled.targets.count = 12;
    sampled.targets.clear_view = false;
    auto targets = sampleTargets(sampled);
    REQUIRE(targets.has_value());
    if (several)
        for (TargetItem& item : *targets) item.clips = {{"sgt", 2}, {"manual", 3}};
    return *targets;
}

StudyPlan severalPlanned(const Study& study, const std::vector<TargetItem>& targets, int number) {
    auto plan = buildPlan(study, targets, "P" + std::to_string(number), number, {});
    REQUIRE_MESSAGE(plan.has_value(), (plan ? "" : plan.error().text()));
    return *plan;
}

}  // namespace

TEST_SUITE("studies/several_clips") {
    TEST_CASE("Each participant has one of them in all trials, every one comes, and nothing else changes.") {
        const Study study = rushedStudy();
        const std::vector<TargetItem> targets = twelve(study, true);
        const std::vector<TargetItem> single = twelve(study, false);
        std::map<std::string, std::map<int, int>> drawn;
        for (int number = 1; number <= 60; ++number) {
            StudyPlan plan = severalPlanned(study, targets, number);
            CHECK(planJson(severalPlanned(study, targets, number)) == planJson(plan));
            std::map<std::pair<std::string, std::string>, std::set<int>> shown;
            for (Trial& trial : plan.trials)
                for (Stimulus& stimulus : trial.stimuli) {
                    shown[{stimulus.system, stimulus.item}].insert(stimulus.clip);
                    stimulus.clip = 0;
                }
            for (const auto& [which, clips] : shown) {
                CHECK(clips.size() == 1);
                ++drawn[which.first][*clips.begin()];
            }
            CHECK(planJson(severalPlanned(study, single, number)) == planJson(plan));
        }
        // 12 items of 60 participants: each of two clips 360 times, SD 13; of three 240 times, SD 13.
        CHECK(drawn["ref"].size() == 1);
        CHECK(drawn["auto"].size() == 1);
        REQUIRE(drawn["sgt"].size() == 2);
        for (const auto& one : drawn["sgt"]) CHECK(std::abs(one.second - 360) < 60);
        REQUIRE(drawn["manual"].size() == 3);
        for (const auto& one : drawn["manual"]) CHECK(std::abs(one.second - 240) < 60);
    }

    TEST_CASE("Which clip it is comes back from the disk, as does how many there are.") {
        const Study study = rushedStudy();
        const std::vector<TargetItem> targets = twelve(study, true);
        const StudyPlan plan = severalPlanned(study, targets, 3);
        const std::string json = planJson(plan);
        const auto written = nlohmann::json::parse(json);
        for (std::size_t i = 0; i < plan.trials.size(); ++i)
            for (std::size_t j = 0; j < plan.trials[i].stimuli.size(); ++j)
                CHECK(written["trials"][i]["stimuli"][j].value("clip", 0) == plan.trials[i].stimuli[j].clip);
        const auto back = planFromJson(json);
        REQUIRE_MESSAGE(back.has_value(), (back ? "" : back.error().text()));
        CHECK(planJson(*back) == json);
        CHECK(back->trials.front().stimuli == plan.trials.front().stimuli);
        const auto kept = targetsFromJson(targetsJson(targets));
        REQUIRE(kept.has_value());
        CHECK(kept->front().clips == targets.front().clips);
        CHECK(planTable(plan).find("(clip 2)") != std::string::npos);
        for (const auto& target : nlohmann::json::parse(targetsJson(twelve(study, false))))
            CHECK_FALSE(target.contains("clips"));
    }
}
