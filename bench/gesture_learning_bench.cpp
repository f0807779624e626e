// An update of the speech gestures' training, of 128 windows, with the discriminator.
#include <torch/torch.h>

// LibTorch first: its logging has macros of the same names.
#include <benchmark/benchmark.h>

#include "gesture_trainer.hpp"
#include "learning/toy_speakers.hpp"

namespace {

using namespace deixis;

void updateGestures(benchmark::State& state, learning::GestureSettings settings) {
    learning::GestureTakes takes = tests::toyTakes(30, 2, 30.0);
    motion::MatrixXf vectors = motion::MatrixXf::Random(settings.shape.word_size, 2);
    takes.words = motion::WordVectors({"well", "so"}, vectors);
    settings.threads = static_cast<int>(state.range(0));
    settings.gan_after = 0;
    learning::GestureTrainer trainer(takes, settings);
    int number = 0;
    for (auto _ : state) benchmark::DoNotOptimize(trainer.update(++number).huber);
}

learning::GestureSettings papersSettings() {
    learning::GestureSettings out;
    out.shape = {};
    out.discriminator_layers = 4;
    return out;
}

BENCHMARK_CAPTURE(updateGestures, small, learning::GestureSettings())
    ->Name("learning/gestures_update_threads")
    ->Arg(1)
    ->Arg(2)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(4);
BENCHMARK_CAPTURE(updateGestures, paper, papersSettings())
    ->Name("learning/gestures_update_papers_size_threads")
    ->Arg(1)
    ->Arg(2)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);

}  // namespace
