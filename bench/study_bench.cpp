// What is fixed before a participant comes: the study as its file says, its targets, and the plan.
#include <benchmark/benchmark.h>

#include <string>

#include "app/clips/study_setup.hpp"
#include "inputs.hpp"
#include "studies/design/plan.hpp"
#include "studies/design/targets.hpp"

namespace {

using namespace deixis;

/// With its language, its questionnaires and its targets, as every command does first.
void read(benchmark::State& state, const std::string& study) {
    for (auto _ : state) benchmark::DoNotOptimize(bench::valueOf(app::loadStudySetup(study)).targets.data());
}
BENCHMARK_CAPTURE(read, pointing, "pointing2023")
    ->Name("study/read_pointing2023")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, rating, "sgtoolkit2021")
    ->Name("study/read_sgtoolkit2021")
    ->Unit(benchmark::kMillisecond);

void targets(benchmark::State& state) {
    const studies::Study study = bench::valueOf(app::loadStudySetup("pointing2023")).study;
    for (auto _ : state) benchmark::DoNotOptimize(bench::valueOf(studies::sampleTargets(study)).data());
}
BENCHMARK(targets)->Name("study/sample_100_targets")->Unit(benchmark::kMicrosecond);

void plan(benchmark::State& state) {
    const app::StudySetup setup = bench::valueOf(app::loadStudySetup("pointing2023"));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            bench::valueOf(studies::buildPlan(setup.study, setup.targets, "P01", 1, {})).trials.data());
}
BENCHMARK(plan)->Name("study/build_plan")->Unit(benchmark::kMicrosecond);

}  // namespace
