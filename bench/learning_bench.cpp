// What a training does in a second, beside the bodies' steps that are a part of it.
#include <torch/torch.h>

// LibTorch first: its logging has macros of the same names.
#include <benchmark/benchmark.h>

#include "inputs.hpp"
#include "learning/networks/optimising.hpp"
#include "motion/synthesis/pose_features.hpp"
#include "physics/figure/mjcf.hpp"
#include "trainer.hpp"

namespace {

using namespace deixis;

/// Of all built-in demonstrations, as `deixis learn amp-base` begins.
struct Trained {
    Trained() {
        learning::setUpTorch(1);
        const motion::Skeleton& avatar = motion::referenceHumanoid();
        const auto data = learning::splitDemonstrations(
            bench::valueOf(motion::makeDemonstrations(avatar, motion::DemonstrationParameters{})), true);
        const auto features = bench::valueOf(motion::PoseFeatures::of(avatar));
        const auto figure = bench::valueOf(physics::makeFigure(avatar, physics::Stance::pinned));
        body = std::make_unique<physics::Body>(bench::valueOf(physics::Body::make(figure)));
        const auto base = physics::BaseMotion::meanOf(features, data.training);
        settings.variant.phase_functioned = false;
        references = bench::valueOf(learning::makeReferences(*body, base, data.training, settings));
        ranks = bench::valueOf(learning::Ranks::join({}));
        trainer = std::make_unique<learning::AmpTrainer>(*body, references, references, settings, 1, *ranks);
    }

    [[nodiscard]] std::int64_t samples() const {
        return static_cast<std::int64_t>(settings.environments) * settings.horizon;
    }

    learning::AmpSettings settings;
    std::unique_ptr<physics::Body> body;
    std::vector<learning::ReferenceMotion> references;
    std::shared_ptr<learning::Ranks> ranks;
    std::unique_ptr<learning::AmpTrainer> trainer;
};

/// `samples_s` are controls, on one core.
void iterate(benchmark::State& state) {
    Trained trained;
    int number = trained.settings.frozen_iterations;
    for (auto _ : state) benchmark::DoNotOptimize(trained.trainer->iterate(++number).task_reward);
    state.counters["samples_s"] = benchmark::Counter(
        static_cast<double>(state.iterations() * trained.samples()), benchmark::Counter::kIsRate);
}
BENCHMARK(iterate)->Name("learning/amp_iteration")->Unit(benchmark::kMillisecond)->Iterations(5);

/// As many controls by the same bodies with nothing learned and nothing rewarded.
void simulate(benchmark::State& state) {
    Trained trained;
    std::vector<physics::Body> bodies(static_cast<std::size_t>(trained.settings.environments), *trained.body);
    for (auto _ : state)
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const learning::ReferenceMotion& one = trained.references[i % trained.references.size()];
            bodies[i].setState(one.states.front());
            for (int control = 0; control < trained.settings.horizon; ++control)
                bodies[i].step(one.targets_rad[static_cast<std::size_t>(control)],
                               physics::steps_per_control);
        }
    state.counters["samples_s"] = benchmark::Counter(
        static_cast<double>(state.iterations() * trained.samples()), benchmark::Counter::kIsRate);
}
BENCHMARK(simulate)->Name("learning/simulation_alone")->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
