// The report of a whole study: 39 participants with 60 answers each, made up.
#include <benchmark/benchmark.h>

#include "inputs.hpp"
#include "results/analysis.hpp"
#include "results/fixtures.hpp"
#include "results/response_table.hpp"

namespace {

using namespace deixis;

std::filesystem::path wholeStudy(const fixtures::Folder& folder) {
    const auto file = folder / "study.sqlite";
    fixtures::fill(file, fixtures::study({"one", "two", "three", "four"}), 39, 5, true, {0.9, 0.8, 0.8, 0.5},
                   {4.0, 3.5, 2.0, 3.0}, fixtures::everything);
    return file;
}

void load(benchmark::State& state) {
    const fixtures::Folder folder;
    const auto file = wholeStudy(folder);
    for (auto _ : state) benchmark::DoNotOptimize(bench::valueOf(results::loadResponses(file)).rows.data());
}
BENCHMARK(load)->Name("report/load_2340_answers")->Unit(benchmark::kMillisecond);

void analyseAndRender(benchmark::State& state) {
    const fixtures::Folder folder;
    const auto table = bench::valueOf(results::loadResponses(wholeStudy(folder)));
    if (table.rows.size() != 39U * 60U) return state.SkipWithError("not 39 x 60 answers");
    for (auto _ : state) benchmark::DoNotOptimize(results::renderReport(results::analyse(table)).data());
}
BENCHMARK(analyseAndRender)->Name("report/analyse_and_render_2340_answers")->Unit(benchmark::kMillisecond);

}  // namespace
