// Playing a clip, and making one.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/clips/systems.hpp"
#include "inputs.hpp"
#include "motion/retarget/retarget.hpp"

namespace {

using namespace deixis;

void sampleAndPlace(benchmark::State& state) {
    const motion::Clip clip = bench::pointingClip();
    motion::LocalPose pose;
    std::vector<Pose> world;
    double time_s = 0.0;
    for (auto _ : state) {
        time_s = std::fmod(time_s + bench::frame_time_s, clip.duration_s());
        motion::sample(clip, time_s, pose);
        motion::worldPose(clip.skeleton, pose, world);
        benchmark::DoNotOptimize(world.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(sampleAndPlace)->Name("clip/sample_and_forward_kinematics")->Unit(benchmark::kMicrosecond);

/// 10,000 frames of 55 joints: the gesture again and again, by a figure whose arms are longer and which walks
/// on.
motion::Clip longClip() {
    motion::Clip clip = bench::pointingClip();
    const std::vector<motion::LocalPose> gesture = clip.frames;
    clip.frames.clear();
    for (std::size_t f = 0; f < 10000; ++f) {
        clip.frames.push_back(gesture[f % gesture.size()]);
        clip.frames.back().joints[0].position.z += 0.01 * static_cast<double>(f);
    }
    for (const motion::Bone bone : {motion::Bone::leftHand, motion::Bone::rightHand}) {
        const auto joint = static_cast<std::size_t>(bone);
        clip.skeleton.joints[joint].rest.position *= 1.2;
        for (auto& frame : clip.frames) frame.joints[joint].position *= 1.2;
    }
    return clip;
}

void retargetLong(benchmark::State& state) {
    const motion::Clip clip = longClip();
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const motion::HumanoidMap map = motion::detectHumanoid(clip.skeleton);
    const motion::HumanoidMap avatar_map = motion::mapByVrmNames(avatar);
    for (auto _ : state) {
        auto made = motion::retarget(clip, map, avatar, avatar_map);
        benchmark::DoNotOptimize(made->frames.data());
    }
}
BENCHMARK(retargetLong)->Name("retarget/10000_frames")->Unit(benchmark::kMillisecond);

/// `playing_s` is how long the clips take to watch.
void generate(benchmark::State& state, const std::string& system) {
    const auto generator = bench::valueOf(app::makeSystem(system, "", motion::referenceHumanoid())).generator;
    std::uint64_t seed = 0;
    double playing_s = 0.0;
    for (auto _ : state) {
        ++seed;
        const double azimuth = radiansFromDegrees(static_cast<double>(seed % 17) * 10.0 - 80.0);
        const Vec3 target{2.0 * std::sin(azimuth), 0.2 + 0.15 * static_cast<double>(seed % 13),
                          2.0 * std::cos(azimuth)};
        const motion::GeneratedClip made = generator->generate({"T001", target, seed});
        playing_s += made.clip.duration_s();
        benchmark::DoNotOptimize(made.clip.frames.data());
    }
    state.counters["playing_s"] = benchmark::Counter(playing_s, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(generate, nn, "demonstration-nn")
    ->Name("generate/demonstration-nn")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, direct, "direct")->Name("generate/direct")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, stiff, "stiff")->Name("generate/stiff")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, drifting, "drifting")->Name("generate/drifting")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, gp, "gp")->Name("generate/gp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, flow, "flow")->Name("generate/flow")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, moglow, "moglow")->Name("generate/moglow")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, amp_base, "amp-base")->Name("generate/amp-base")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(generate, amp_pfnn, "amp-pfnn-8")
    ->Name("generate/amp-pfnn-8")
    ->Unit(benchmark::kMillisecond);

}  // namespace
