// Drawing a frame of the game off screen and reading it back.
#include <benchmark/benchmark.h>

#include "app/clips/study_setup.hpp"
#include "renderer/drawing/renderer.hpp"
#include "scenes.hpp"

namespace {

using namespace deixis;

/// Arguments: width, height, samples.
void capture(benchmark::State& state) {
    const auto context = renderer::OffscreenContext::create();
    if (!context) return state.SkipWithError(context.error().text().c_str());
    const assets::Avatar avatar = bench::valueOf(app::loadShippedAvatar());
    renderer::Quality quality;
    quality.samples = static_cast<int>(state.range(2));
    renderer::Renderer drawing = bench::valueOf(renderer::Renderer::create(avatar, quality));
    const renderer::Scene scene = bench::sceneOf(bench::gameFrame());
    const auto width = static_cast<int>(state.range(0));
    const auto height = static_cast<int>(state.range(1));
    benchmark::DoNotOptimize(drawing.capture(scene, width, height).rgb.data());  // paints the board
    for (auto _ : state) benchmark::DoNotOptimize(drawing.capture(scene, width, height).rgb.data());
    state.SetLabel(drawing.driver());
}
BENCHMARK(capture)
    ->Name("renderer/capture")
    ->Args({640, 360, 1})
    ->Args({640, 360, 4})
    ->Args({1280, 720, 1})
    ->Args({1280, 720, 4})
    ->ArgNames({"width", "height", "samples"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
