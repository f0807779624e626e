// The session's own share of a frame, and whole sessions of a simulated participant.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/session/recorders.hpp"
#include "app/session/session_loop.hpp"
#include "app/stations/simulated_setup.hpp"
#include "app/study/enrolment.hpp"
#include "app/study/stimuli.hpp"
#include "assets/data/data_paths.hpp"
#include "clocks.hpp"
#include "inputs.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "results/fixtures.hpp"
#include "studies/simulation/simulated_participant.hpp"

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
    state.counters["limit_us"] = 1e6 * bench::frame_time_s;
}
BENCHMARK(step)->Name("session/step_while_playing")->Unit(benchmark::kMicrosecond);

/// The simulated station, which takes down what passes between the input of a frame and its picture: one step
/// of the session and the keeping of its events.
class TimedStation : public studies::Station {
  public:
    explicit TimedStation(studies::SimulatedStation& station) : station_(station) {}
    [[nodiscard]] studies::StationInfo info() const override { return station_.info(); }
    [[nodiscard]] studies::InputFrame beginFrame() override {
        studies::InputFrame input = station_.beginFrame();
        begin_s_ = bench::threadSeconds();
        return input;
    }
    studies::FrameReport present(const studies::PresentedFrame& frame) override {
        steps_us_.push_back(1e6 * (bench::threadSeconds() - begin_s_));
        return station_.present(frame);
    }
    [[nodiscard]] std::vector<double>& stepsUs() { return steps_us_; }

  private:
    studies::SimulatedStation& station_;
    double begin_s_ = 0.0;
    std::vector<double> steps_us_{};
};

/// All of one participant's answers, kept as `deixis simulate` keeps them. The clips are there already.
void simulate(benchmark::State& state, const std::string& study) {
    const fixtures::Folder folder;
    const app::StudySetup setup = bench::valueOf(app::loadStudySetup(study));
    const assets::Avatar avatar = bench::valueOf(app::loadShippedAvatar());
    const motion::LocalPose idle = motion::relaxedPose(avatar.skeleton);
    const auto parameters = bench::valueOf(
        studies::loadSimulatedParameters(assets::dataFile("simulated_participant.toml").string()));
    results::Store store = fixtures::open(folder / "study.sqlite", results::Durability::whole_run);
    const auto hash = app::lockStudy(setup, {folder / "study.sqlite", folder / "stimuli", {}, {}, false});
    if (!hash) return state.SkipWithError("the study cannot be locked");
    const app::LockedStudy locked = bench::valueOf(app::openLocked(folder / "study.sqlite", *hash));

    int number = 0;
    double session_s = 0.0;
    double answers = 0.0;
    std::vector<double> steps_us;
    for (auto _ : state) {
        state.PauseTiming();
        const auto enrolled =
            bench::valueOf(app::enrol(setup, store, fmt::format("S{:03}", ++number), {}, 0.0));
        if (!store.storePlan(setup.study, enrolled.registration, enrolled.plan))
            return state.SkipWithError("the plan cannot be stored");
        const auto clips = bench::valueOf(app::StimulusLibrary::load(locked, {enrolled.plan}, avatar));
        const results::ClipRecords records = clips.records();
        state.ResumeTiming();

        studies::SimulatedStation simulated(parameters, avatar.skeleton, app::simulatedSeed(enrolled.plan));
        TimedStation station(simulated);
        studies::SessionRunner session(setup.study, enrolled.plan, clips, avatar.skeleton, idle, {}, true);
        store.beginSession(fixtures::session(enrolled.plan.participant, true));
        app::DirectRecorder recorder(store, setup.study, enrolled.plan, records);
        const double end_s = app::runSession(session, station, recorder).time_s;
        store.endSession(session.outcome(), end_s);

        state.PauseTiming();
        session_s += end_s;
        answers += recorder.answered();
        steps_us.insert(steps_us.end(), station.stepsUs().begin(), station.stepsUs().end());
        state.ResumeTiming();
    }
    store.commit();
    state.counters["session_s"] = benchmark::Counter(session_s, benchmark::Counter::kAvgIterations);
    state.counters["answers"] = benchmark::Counter(answers, benchmark::Counter::kAvgIterations);
    state.counters["step_median_us"] = bench::median(steps_us);
    state.counters["step_slowest_us"] = *std::max_element(steps_us.begin(), steps_us.end());
    state.counters["step_limit_us"] = 1e6 * bench::frame_time_s;
}
BENCHMARK_CAPTURE(simulate, pointing, "pointing2023-stand-ins")
    ->Name("session/simulated_pointing2023-stand-ins")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulate, rating, "sgtoolkit2021")
    ->Name("session/simulated_sgtoolkit2021")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulate, pairwise, "genea-pairwise")
    ->Name("session/simulated_genea-pairwise")
    ->Unit(benchmark::kMillisecond);

}  // namespace
