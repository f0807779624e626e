// The session's own share of a frame while a clip plays.
#include <benchmark/benchmark.h>

#include "inputs.hpp"

namespace {

using namespace deixis;

void step(benchmark::State& state) {
    bench::Participant participant;
    participant.toPlayingClip();
    for (auto _ : state) {
        studies::InputFrame input = participant.pointing({0.0, 1.2, 2.0}, false);
        participant.time_s += bench::frame_time_s;
        input.time_s = participant.time_s;
        const studies::SessionStep made = participant.session->step(input);
        benchmark::DoNotOptimize(made.frame.avatar_joints.data());
        benchmark::DoNotOptimize(participant.session->shown({made.frame.number, true, input.time_s}));
        if (!bench::Participant::showsClip(made.frame.state)) {
            state.PauseTiming();
            participant.frame = made.frame;
            participant.toPlayingClip();
            state.ResumeTiming();
        }
    }
}
BENCHMARK(step)->Name("session/step_while_playing")->Unit(benchmark::kMicrosecond);

}  // namespace
