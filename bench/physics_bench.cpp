// The simulated body: steps, and poses as angles.
#include <benchmark/benchmark.h>

#include "core/random.hpp"
#include "inputs.hpp"
#include "physics/body/body.hpp"
#include "physics/figure/figure_pose.hpp"
#include "physics/figure/mjcf.hpp"
#include "physics/projection/projection.hpp"

namespace {

using namespace deixis;

physics::Figure figureOf(physics::Stance stance) {
    return bench::valueOf(physics::makeFigure(motion::referenceHumanoid(), stance));
}

/// A pose of the gesture that sessions show, at its peak.
motion::LocalPose pointingPose() {
    const motion::Clip clip = bench::pointingClip();
    return motion::sample(clip, 0.5 * clip.duration_s());
}

/// With targets that change at every control, as a policy's do; begun anew every four seconds.
void step(benchmark::State& state, physics::Stance stance) {
    physics::Body body = bench::valueOf(physics::Body::make(figureOf(stance)));
    const motion::LocalPose pose = motion::relaxedPose(body.figure().skeleton);
    physics::BodyState start;
    start.root.pose = physics::rootOf(body.figure(), pose);
    start.angles_rad = physics::fitPose(body.figure(), pose).angles_rad;
    start.speeds_rad_s.assign(start.angles_rad.size(), 0.0);
    Random random(1, "bench");
    std::vector<double> targets;
    int controls = 0;
    for (auto _ : state) {
        if (controls++ % 120 == 0) body.setState(start);
        targets = start.angles_rad;
        for (double& target : targets) target += random.normal(0.0, 0.03);
        body.step(targets, physics::steps_per_control);
        benchmark::DoNotOptimize(body.angles_rad().data());
    }
    const double steps = static_cast<double>(state.iterations()) * physics::steps_per_control;
    state.counters["steps_s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(step, pinned, physics::Stance::pinned)
    ->Name("physics/step_pinned")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, full, physics::Stance::free)
    ->Name("physics/step_full_body")
    ->Unit(benchmark::kMicrosecond);

void poseToAngles(benchmark::State& state) {
    const physics::Figure figure = figureOf(physics::Stance::pinned);
    const motion::LocalPose pose = pointingPose();
    for (auto _ : state) benchmark::DoNotOptimize(physics::fitPose(figure, pose).angles_rad.data());
}
BENCHMARK(poseToAngles)->Name("physics/pose_to_angles")->Unit(benchmark::kMicrosecond);

void anglesToPose(benchmark::State& state) {
    const physics::Figure figure = figureOf(physics::Stance::pinned);
    const motion::LocalPose pose = pointingPose();
    const auto angles = physics::fitPose(figure, pose).angles_rad;
    motion::LocalPose relaxed = motion::relaxedPose(figure.skeleton);
    for (auto _ : state) {
        physics::applyAngles(figure, angles, relaxed);
        benchmark::DoNotOptimize(relaxed.joints.data());
    }
}
BENCHMARK(anglesToPose)->Name("physics/angles_to_pose")->Unit(benchmark::kMicrosecond);

/// `playing_s` is how long the clip takes to watch.
void projectClip(benchmark::State& state) {
    physics::Body body = bench::valueOf(physics::Body::make(figureOf(physics::Stance::pinned)));
    const motion::Clip clip = bench::pointingClip();
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::valueOf(physics::project(body, clip, {})).clip.frames.data());
    state.counters["playing_s"] = clip.duration_s();
}
BENCHMARK(projectClip)->Name("physics/project")->Unit(benchmark::kMillisecond);

}  // namespace
