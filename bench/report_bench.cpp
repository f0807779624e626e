// From the database to the report: a study of 39 participants with 60 answers each, made up, and one of ten
// times as many; and 100,000 answers in a CSV file. Limits: a second each for who waits for the first and
// the last, 150 ms for the page of one study with all figures.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "core/files.hpp"
#include "core/random.hpp"
#include "inputs.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/long_table.hpp"
#include "results/answers/response_table.hpp"
#include "results/fixtures.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"

namespace {

using namespace deixis;

constexpr double max_seconds_for_a_report = 1.0;
constexpr double max_seconds_for_a_page = 0.15;  // of one study
constexpr int answers_each = 60;

std::filesystem::path wholeStudy(const fixtures::Folder& folder, int participants) {
    const auto file = folder / "study.sqlite";
    fixtures::fill(file, fixtures::study({"one", "two", "three", "four"}), participants, 5, true,
                   {0.9, 0.8, 0.8, 0.5}, {4.0, 3.5, 2.0, 3.0}, fixtures::everything);
    return file;
}

/// What is read must be the whole study.
results::ResponseTable loaded(const std::filesystem::path& file, int participants) {
    auto table = bench::valueOf(results::loadResponses(file));
    if (table.rows.size() != static_cast<std::size_t>(participants * answers_each))
        throw std::runtime_error("some answers were not read");
    return table;
}

void load(benchmark::State& state, int participants) {
    const fixtures::Folder folder;
    const auto file = wholeStudy(folder, participants);
    for (auto _ : state) benchmark::DoNotOptimize(loaded(file, participants).rows.data());
    state.counters["limit_s"] = max_seconds_for_a_report;
}
BENCHMARK_CAPTURE(load, study, 39)->Name("report/load_2340_answers")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load, ten_studies, 390)->Name("report/load_23400_answers")->Unit(benchmark::kMillisecond);

void analyseAndRender(benchmark::State& state, int participants, double limit_s) {
    const fixtures::Folder folder;
    const auto table = loaded(wholeStudy(folder, participants), participants);
    for (auto _ : state) benchmark::DoNotOptimize(results::renderReport(results::analyse(table)).data());
    state.counters["limit_s"] = limit_s;
}
BENCHMARK_CAPTURE(analyseAndRender, study, 39, max_seconds_for_a_page)
    ->Name("report/analyse_and_render_2340_answers")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(analyseAndRender, ten_studies, 390, max_seconds_for_a_report)
    ->Name("report/analyse_and_render_23400_answers")
    ->Unit(benchmark::kMillisecond);

/// Of 1,000 participants: an accuracy and a rating of four systems in two layouts.
std::string manyAnswers() {
    std::string text = "participant,measure,system,layout,item,order,correct,rating,rt\n";
    Random random(39, "answers");
    for (int p = 0; p < 1000; ++p)
        for (int i = 0; i < 100; ++i) {
            const bool choice = i % 2 == 0;
            const int system = i / 2 % 4;
            const auto steps = static_cast<int>(random.below(5));
            text += fmt::format("P{:04},{},{},{},T{:03},{},{},{},{:.3f}\n", p,
                                choice ? "accuracy" : "naturalness", "abcd"[system],
                                i / 8 % 2 == 0 ? "across" : "side", i % 125, i,
                                choice ? (steps >= system ? "1" : "0") : "",
                                choice ? "" : fmt::format("{}", 1 + steps), 0.5 + 0.001 * (i * 7 % 3000));
        }
    return text;
}

/// From the file to every table, the answers among them, and the page.
void analyseMany(benchmark::State& state) {
    const fixtures::Folder folder;
    const auto file = folder / "answers.csv";
    if (!writeFile(file, manyAnswers())) throw std::runtime_error("no place for the answers");
    for (auto _ : state) {
        const auto result = results::analyse(bench::valueOf(results::loadLongTable(file)));
        if (result.table.rows.size() != 100000) throw std::runtime_error("some answers were not read");
        benchmark::DoNotOptimize(results::renderReport(result).data());
        benchmark::DoNotOptimize(results::analysisTables(result, results::TableFormat::csv).data());
    }
    state.counters["limit_s"] = max_seconds_for_a_report;
}
BENCHMARK(analyseMany)
    ->Name("report/100000_answers_to_all_tables")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
