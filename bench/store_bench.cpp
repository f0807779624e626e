// How long the next trial waits for an answer to be on the disk, against a bare write and sync there.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "results/fixtures.hpp"
#include "results/store.hpp"

namespace {

using namespace deixis;

/// Times each call by itself: a participant meets the slowest answer, not the mean.
class Stopwatch {
  public:
    template <typename Call>
    void time(benchmark::State& state, const Call& call) {
        const auto begin = std::chrono::steady_clock::now();
        call();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        state.SetIterationTime(passed.count());
        slowest_ms_ = std::max(slowest_ms_, passed.count() * 1e3);
    }
    void report(benchmark::State& state) const { state.counters["slowest_ms"] = slowest_ms_; }

  private:
    double slowest_ms_ = 0.0;
};

void durableAnswer(benchmark::State& state) {
    const fixtures::Folder folder;
    results::Store store = fixtures::open(folder / "answers.sqlite");
    const studies::Study study = fixtures::study({"one", "two", "three", "four"});
    int participants = 0;
    studies::StudyPlan plan;
    results::ClipRecords clips;
    std::size_t next = 0;
    Stopwatch stopwatch;
    for (auto _ : state) {
        if (next == plan.trials.size()) {
            if (participants > 0) store.endSession(studies::SessionOutcome::finished, 1.7e9);
            const std::string participant = "P" + std::to_string(++participants);
            plan = fixtures::plan(study, participant, 5);
            clips = fixtures::clips(plan);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session(participant, true));
            next = 1;  // after practice
        }
        const studies::SessionEvent answer = fixtures::answer(plan.trials[next++], 1);
        stopwatch.time(state, [&] { store.record(answer, study, plan, clips); });
    }
    stopwatch.report(state);
}
BENCHMARK(durableAnswer)->Name("store/durable_answer")->UseManualTime()->Unit(benchmark::kMillisecond);

void writeAndSync(benchmark::State& state) {
    const fixtures::Folder folder;
    const int file = ::open((folder / "bare").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    if (file < 0) return state.SkipWithError("no file in the temporary folder");
    std::array<char, 4096> page{};
    page.fill('x');
    bool written = true;
    Stopwatch stopwatch;
    for (auto _ : state)
        stopwatch.time(state, [&] {
            written = written &&
                      ::write(file, page.data(), page.size()) == static_cast<ssize_t>(page.size()) &&
                      ::fdatasync(file) == 0;
        });
    ::close(file);
    if (!written) return state.SkipWithError("a write failed");
    stopwatch.report(state);
}
BENCHMARK(writeAndSync)->Name("store/peer_write_and_sync")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
