// A power analysis of the whole study that ships: 1,000 studies each of 10, 20, 39 and 60 participants, every
// test of the report. Limit: a minute on two cores.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include "app/clips/study_setup.hpp"
#include "assets/data/data_paths.hpp"
#include "clocks.hpp"
#include "inputs.hpp"
#include "results/analysis/power.hpp"

namespace {

using namespace deixis;

constexpr double max_seconds = 60.0;
constexpr unsigned cores = 2;

void wholeStudy(benchmark::State& state) {
    const app::StudySetup setup = bench::valueOf(app::loadStudySetup("pointing2023"));
    const auto effects = bench::valueOf(
        studies::loadAssumedEffects(assets::dataFile("effects/pointing2023.toml"), setup.study));
    results::PowerOptions options;
    options.studies = 1000;
    options.threads = cores;
    double slowest_s = 0.0;
    for (auto _ : state) {
        const double begin_s = bench::processorSeconds();
        auto power =
            bench::valueOf(results::PowerAnalysis::make(setup.study, setup.targets, effects, 60, options));
        power.simulate({10, 20, 39, 60}, [](std::size_t, std::size_t) {});
        benchmark::DoNotOptimize(power.result().contrasts.data());
        slowest_s = std::max(slowest_s, (bench::processorSeconds() - begin_s) / cores);
    }
    state.counters["limit_s"] = max_seconds;
    if (slowest_s > max_seconds)
        state.SkipWithError(
            fmt::format("over the limit: {:.1f} s of {} s on each of {} cores", slowest_s, max_seconds, cores)
                .c_str());
}
BENCHMARK(wholeStudy)
    ->Name("power/4_sizes_of_1000_studies")
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->UseRealTime();

}  // namespace
