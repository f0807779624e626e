// The plan of an authoring session (Yoon et al. 2021, 7.1.1), over many participants.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

#include "plan_fixture.hpp"
#include "studies/design/plan.hpp"

using namespace deixis;
using namespace deixis::studies;
using namespace deixis::studies::plan_fixture;

namespace {

Study authoringStudy(int items, int practice) {
    Study study = studyOf({"SGT", "MANUAL"});
    for (SystemSource& system : study.systems) {
        system.generator.clear();
        system.projects = "speeches";
    }
    Stage stage = trials(study, "authoring", StageKind::authoring, items);
    stage.measure.clear();
    stage.design.system_meets = Crossing::nested;
    stage.design.block_by = "system";
    stage.design.block_order = BlockOrder::williams;
    stage.authoring.practice_per_block = practice;
    study.stages = {stage};
    return study;
}

/// Twelve speeches, as the paper's, without a place.
std::vector<TargetItem> speeches() {
    std::vector<TargetItem> out;
    for (int i = 0; i < 12; ++i) out.push_back({fmt::format("speech{}", i + 1), Vec3(0.0), false});
    return out;
}

StudyPlan planFor(const Study& study, int number) {
    auto plan = buildPlan(study, speeches(), fmt::format("P{:03}", number), number, {});
    REQUIRE_MESSAGE(plan.has_value(), (plan ? "" : plan.error().text()));
    return *plan;
}

}  // namespace

TEST_SUITE("studies/plan_authoring") {
    TEST_CASE("Each condition is a block, its first trials are practice, and nobody has a speech twice") {
        for (const auto& [items, practice] : {std::pair(8, 2), std::pair(4, 1)}) {
            const Study study = authoringStudy(items, practice);
            int first_sgt = 0;
            for (int number = 1; number <= 200; ++number) {
                const StudyPlan plan = planFor(study, number);
                REQUIRE(plan.trials.size() == static_cast<std::size_t>(items));
                std::set<std::string> seen;
                for (int i = 0; i < items; ++i) {
                    const Trial& trial = plan.trials[static_cast<std::size_t>(i)];
                    const Trial& block = plan.trials[static_cast<std::size_t>(i < items / 2 ? 0 : items / 2)];
                    CHECK(trial.stimuli[0].system == block.stimuli[0].system);
                    CHECK(trial.practice == (i % (items / 2) < practice));
                    CHECK(trial.scored() == !trial.practice);
                    CHECK(seen.insert(trial.stimuli[0].item).second);
                }
                CHECK(plan.trials.front().stimuli[0].system != plan.trials.back().stimuli[0].system);
                first_sgt += plan.trials.front().stimuli[0].system == "SGT" ? 1 : 0;
                CHECK(planJson(*planFromJson(planJson(plan))) == planJson(plan));
            }
            CHECK(first_sgt == 100);  // the order is balanced by the participants' numbers
        }
    }

    TEST_CASE("Over the paper's 12 participants every speech is made under both conditions") {
        for (const auto& [items, practice, scored] : {std::tuple(8, 2, 24), std::tuple(4, 1, 12)}) {
            const Study study = authoringStudy(items, practice);
            std::map<std::pair<std::string, std::string>, int> counts;
            for (int number = 1; number <= 12; ++number)
                for (const Trial& trial : planFor(study, number).trials)
                    if (trial.scored()) ++counts[{trial.stimuli[0].system, trial.stimuli[0].item}];
            CHECK(counts.size() == 24);
            for (const auto& cell : counts) {
                CAPTURE(cell.first.first + " " + cell.first.second);
                CHECK(cell.second == scored / 12);
            }
        }
    }
}
