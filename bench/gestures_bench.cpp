// Gestures to four seconds of speech, and to two minutes, on one core.
#include <benchmark/benchmark.h>

#include "inputs.hpp"
#include "motion/gesture_weights.hpp"

namespace {

using namespace deixis;

motion::GestureShape paperShape() {
    return {};
}
/// The trainer's default (learning/gestures/training.hpp).
motion::GestureShape smallShape() {
    motion::GestureShape out;
    out.sound_channels = 8;
    out.word_channels = 64;
    out.hidden = 160;
    out.layers = 2;
    return out;
}

void gesture(benchmark::State& state, const motion::GestureShape& shape) {
    const auto model = bench::valueOf(motion::SpeechGestureModel::read(tests::randomGestureWeights(shape)));
    Random random(1);
    motion::SpeechGestureRequest request;
    request.duration_s = static_cast<double>(state.range(0));
    std::vector<float> samples;
    for (int i = 0; i < static_cast<int>(request.duration_s * motion::speech_rate_hz); ++i)
        samples.push_back(static_cast<float>(random.normal()));
    request.samples = samples;
    request.poses = {{30, motion::relaxedUpperBody()}};
    request.exact = true;
    for (auto _ : state) benchmark::DoNotOptimize(bench::valueOf(model.generate(request)).frames.data());
}
BENCHMARK_CAPTURE(gesture, small, smallShape())
    ->Name("speech_gestures/trained_size_s")
    ->Arg(4)
    ->Arg(120)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gesture, paper, paperShape())
    ->Name("speech_gestures/papers_size_s")
    ->Arg(4)
    ->Unit(benchmark::kMillisecond);

}  // namespace
