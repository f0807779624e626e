// What it takes to plan for many participants. Limit: 10,000 plans in one second.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "clocks.hpp"
#include "inputs.hpp"
#include "studies/design/plan.hpp"

namespace {

using namespace deixis;
using namespace deixis::studies;

constexpr int participants = 10'000;
constexpr double max_plan_seconds = 1.0;

/// Levels of a participant to whom the cells come in turn.
Groups groupsInTurn(const Study& study, int number) {
    Groups groups;
    auto place = static_cast<std::size_t>(number);
    for (const BetweenFactor& factor : study.between) {
        groups[factor.name] = factor.levels[place % factor.levels.size()];
        place /= factor.levels.size();
    }
    return groups;
}

/// Plans 10,000 participants of a study.
void plan10000(benchmark::State& state, const app::StudySetup& setup) {
    double slowest_s = 0.0;
    std::size_t trials = 0;
    for (auto _ : state) {
        const double begin_s = bench::threadSeconds();
        for (int number = 1; number <= participants; ++number) {
            const Result<StudyPlan> plan =
                buildPlan(setup.study, setup.targets, "P01", number, groupsInTurn(setup.study, number));
            if (!plan) return state.SkipWithError(plan.error().text().c_str());
            trials = plan->trials.size();
            benchmark::DoNotOptimize(plan->trials.data());
        }
        slowest_s = std::max(slowest_s, bench::threadSeconds() - begin_s);
    }
    state.counters["trials_a_plan"] = static_cast<double>(trials);
    state.counters["limit_s"] = max_plan_seconds;
    if (slowest_s > max_plan_seconds)
        state.SkipWithError(
            fmt::format("over the limit: {:.2f} s of {} s of processor time", slowest_s, max_plan_seconds)
                .c_str());
}

void shipped(benchmark::State& state, const std::string& study) {
    plan10000(state, bench::valueOf(app::loadStudySetup(study)));
}
BENCHMARK_CAPTURE(shipped, pointing, "pointing2023")
    ->Name("plan/10000_pointing")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shipped, rating, "sgtoolkit2021")
    ->Name("plan/10000_parallel_rating")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shipped, pairwise, "genea-pairwise")
    ->Name("plan/10000_pairwise")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shipped, distance, "distractor-distance")
    ->Name("plan/10000_distractor_distance")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shipped, style, "pointing-style")
    ->Name("plan/10000_pointing_style")
    ->Unit(benchmark::kMillisecond);

/// The pointing study under limits on runs: orders that keep them are searched for.
void pointingLimited(benchmark::State& state) {
    app::StudySetup setup = bench::valueOf(app::loadStudySetup("pointing2023"));
    for (Stage& stage : setup.study.stages) {
        stage.design.max_run_of_system = 2;
        stage.design.no_target_twice_running = true;
    }
    plan10000(state, setup);
}
BENCHMARK(pointingLimited)->Name("plan/10000_pointing_limited_runs")->Unit(benchmark::kMillisecond);

/// The group of one more participant, where 10,000 have theirs.
void assignOne(benchmark::State& state) {
    Study study;
    study.seed = 2023;
    study.between = {{"measure", {"human-likeness", "appropriateness"}}, {"style", {"calm", "lively"}}};
    GroupSizes taken;
    for (int number = 1; number <= participants; ++number) ++taken[groupsInTurn(study, number)];
    for (auto _ : state) benchmark::DoNotOptimize(assignGroups(study, taken, participants + 1).size());
}
BENCHMARK(assignOne)->Name("plan/assign_groups_after_10000")->Unit(benchmark::kMicrosecond);

}  // namespace
