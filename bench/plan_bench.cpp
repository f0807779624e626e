// What it takes to plan for many participants. Limit: 10,000 plans in one second.
#include <benchmark/benchmark.h>

#include <string>

#include "studies/plan.hpp"
#include "studies/plan_fixture.hpp"

namespace {

using namespace deixis;
using namespace deixis::studies;

constexpr int participants = 10'000;

/// Plans 10,000 participants of a study, who take the groups in turn.
void plan10000(benchmark::State& state, const Study& study) {
    const std::vector<TargetItem> targets = plan_fixture::targetsFor(study, 100);
    for (auto _ : state)
        for (int number = 1; number <= participants; ++number) {
            Groups groups;
            for (const BetweenFactor& factor : study.between)
                groups[factor.name] = factor.levels[number % factor.levels.size()];
            const Result<StudyPlan> plan = buildPlan(study, targets, "P01", number, groups);
            if (!plan) return state.SkipWithError(plan.error().text().c_str());
            benchmark::DoNotOptimize(plan->trials.data());
        }
    state.counters["plans_per_s"] =
        benchmark::Counter(participants, benchmark::Counter::kIsIterationInvariantRate);
}

/// The pointing study under limits on runs: they are searched for.
Study limited() {
    Study study = plan_fixture::pointing();
    for (Stage& stage : study.stages) {
        stage.design.max_run_of_system = 2;
        stage.design.no_target_twice_running = true;
    }
    return study;
}

void pointing(benchmark::State& state) {
    plan10000(state, plan_fixture::pointing());
}
BENCHMARK(pointing)->Name("plan/10000_pointing")->Unit(benchmark::kMillisecond);

void pointingLimited(benchmark::State& state) {
    plan10000(state, limited());
}
BENCHMARK(pointingLimited)->Name("plan/10000_pointing_limited_runs")->Unit(benchmark::kMillisecond);

void pages(benchmark::State& state) {
    plan10000(state, plan_fixture::rating());
}
BENCHMARK(pages)->Name("plan/10000_parallel_rating")->Unit(benchmark::kMillisecond);

}  // namespace
