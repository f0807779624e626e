// How long the next trial waits for an answer to be on the disk, against a bare write and sync there, and how
// long a frame waits for what is kept of it to be handed over.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <thread>

#include "inputs.hpp"
#include "results/fixtures.hpp"
#include "results/store/recording_thread.hpp"
#include "results/store/store.hpp"

namespace {

using namespace deixis;

constexpr double between_trials_s = 0.1;

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
    void report(benchmark::State& state, double limit_s) const {
        state.counters["slowest_ms"] = slowest_ms_;
        state.counters["limit_ms"] = limit_s * 1e3;
    }

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
    stopwatch.report(state, between_trials_s);
}
BENCHMARK(durableAnswer)->Name("store/durable_answer")->UseManualTime()->Unit(benchmark::kMillisecond);

/// A frame's tracking, every 90th time with an answer, given to the thread that writes; twelve times as often
/// as a headset would.
void handOver(benchmark::State& state) {
    const fixtures::Folder folder;
    results::Store store = fixtures::open(folder / "frames.sqlite");
    const studies::Study study = fixtures::study({"one", "two", "three", "four"});
    const studies::StudyPlan plan = fixtures::plan(study, "P01", 5);
    fixtures::store(store, study, plan);
    store.beginSession(fixtures::session("P01", true));
    results::RecordingThread thread(store, study, plan, fixtures::clips(plan), {});
    std::uint64_t number = 0;
    std::size_t next = 1;  // after practice
    Stopwatch stopwatch;
    for (auto _ : state) {
        const studies::TrackingSample frame = fixtures::frame(++number);
        const bool answered = number % 90 == 0 && next < plan.trials.size();
        stopwatch.time(state, [&] {
            if (answered) thread.record(fixtures::answer(plan.trials[next], 1));
            thread.sample(frame, static_cast<int>(next));
        });
        if (answered) ++next;
        std::this_thread::sleep_for(std::chrono::microseconds(900));
    }
    thread.finish();
    stopwatch.report(state, bench::frame_time_s);
}
BENCHMARK(handOver)
    ->Name("store/hand_over_frame")
    ->UseManualTime()
    ->Iterations(2700)
    ->Unit(benchmark::kMicrosecond);

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
    stopwatch.report(state, between_trials_s);
}
BENCHMARK(writeAndSync)->Name("store/peer_write_and_sync")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
