// What is fixed before a participant comes: the study's targets, and the plan.
#include <benchmark/benchmark.h>

#include "inputs.hpp"
#include "studies/plan.hpp"
#include "studies/targets.hpp"
#include "study_setup.hpp"

namespace {

using namespace deixis;

void targets(benchmark::State& state) {
    const studies::Study study = bench::valueOf(app::loadStudySetup("pointing2023")).study;
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::valueOf(studies::sampleTargets(study.targets, study.seed)).data());
}
BENCHMARK(targets)->Name("study/sample_100_targets")->Unit(benchmark::kMicrosecond);

void plan(benchmark::State& state) {
    const app::StudySetup setup = bench::valueOf(app::loadStudySetup("pointing2023"));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            bench::valueOf(studies::buildPlan(setup.study, setup.targets, "P01")).trials.data());
}
BENCHMARK(plan)->Name("study/build_plan")->Unit(benchmark::kMicrosecond);

}  // namespace
