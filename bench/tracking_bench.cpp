// What the tracking of a long session costs: a person in a headset for 40 minutes at 90 frames a second, head
// and both hands, with the noise of real sensors. Two limits: 30 MB in the database file, and 2 % of one
// core.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "clocks.hpp"
#include "results/database/tracking_blocks.hpp"
#include "results/fixtures.hpp"
#include "results/store/store.hpp"

namespace {

using namespace deixis;

constexpr double frames_per_s = 90.0;
constexpr double session_s = 40.0 * 60.0;
constexpr std::uint64_t session_frames = 216'000;
constexpr std::uint64_t trial_frames = 900;
constexpr double max_megabytes = 30.0;
constexpr double max_percent_of_a_core = 2.0;

// Of good inside-out tracking, frame to frame.
constexpr double position_noise_m = 0.0005;
constexpr double turn_noise_rad = 0.0009;
constexpr double clock_noise_s = 0.0003;

/// A body part that moves as people do: slow drift, and reaches of about a second each.
class Part {
  public:
    Part(const Vec3& rest, double reach_m, double turn_rad, std::string_view name)
        : random_(2023, name), rest_(rest), reach_m_(reach_m), turn_rad_(turn_rad) {
        for (double& phase : phases_) phase = random_.uniform(0.0, 2.0 * pi);
    }
    [[nodiscard]] studies::TrackedPose at(double time_s) {
        const auto wave = [&](std::size_t i, double hertz) {
            return std::sin(2.0 * pi * hertz * time_s + phases_[i]);
        };
        const double reach = 0.5 + 0.5 * wave(0, 0.13);
        const auto noisy = [&](double value, double sd) { return value + random_.normal(0.0, sd); };
        const Vec3 moved = rest_ + reach_m_ * reach * Vec3(wave(1, 0.71), wave(2, 0.53), wave(3, 0.37)) +
                           0.01 * Vec3(wave(4, 0.23), wave(5, 1.9), wave(1, 0.11));
        const double half_yaw = noisy(0.5 * turn_rad_ * reach * wave(2, 0.31), turn_noise_rad / 2.0);
        const double half_pitch = noisy(0.3 * turn_rad_ * wave(3, 0.47), turn_noise_rad / 2.0);
        const double half_roll = noisy(0.1 * turn_rad_ * wave(5, 0.29), turn_noise_rad / 2.0);
        const Quat turn = Quat(std::cos(half_yaw), 0.0, std::sin(half_yaw), 0.0) *
                          Quat(std::cos(half_pitch), std::sin(half_pitch), 0.0, 0.0) *
                          Quat(std::cos(half_roll), 0.0, 0.0, std::sin(half_roll));
        const Vec3 measured{noisy(moved.x, position_noise_m), noisy(moved.y, position_noise_m),
                            noisy(moved.z, position_noise_m)};
        return {{measured, turn}, true, true, true};
    }

  private:
    Random random_;
    Vec3 rest_;
    double reach_m_;
    double turn_rad_;
    std::array<double, 6> phases_{};
};

class Person {
  public:
    [[nodiscard]] results::TrackedFrame frame(std::uint64_t number) {
        const double time_s = static_cast<double>(number) / frames_per_s;
        studies::TrackingSample out;
        out.frame = number;
        out.display_time_s = 1000.0 + time_s;
        out.begun_s = out.display_time_s - 0.025 + clock_.normal(0.0, clock_noise_s);
        out.submitted_s = out.display_time_s - 0.018 + clock_.normal(0.0, clock_noise_s);
        out.head = head_.at(time_s);
        out.aim = {left_aim_.at(time_s), right_aim_.at(time_s)};
        out.grip = {left_grip_.at(time_s), right_grip_.at(time_s)};
        const Vec3& place = out.head.stage_from_device.position;
        out.off_place_m = std::hypot(place.x, place.z - 2.0);
        const auto unit = static_cast<int>(number / trial_frames);
        return {out, unit % 2 == 0 ? -1 : 1 + unit / 2 % 10};
    }

  private:
    Random clock_{2023, "clock"};
    Part head_{{0.0, 1.65, 2.0}, 0.10, 1.0, "head"};
    Part left_aim_{{-0.3, 1.1, 1.8}, 0.35, 1.5, "left aim"},
        right_aim_{{0.3, 1.1, 1.8}, 0.35, 1.5, "right aim"};
    Part left_grip_{{-0.3, 1.1, 1.85}, 0.35, 1.5, "left grip"},
        right_grip_{{0.3, 1.1, 1.85}, 0.35, 1.5, "right grip"};
};

void session(benchmark::State& state) {
    const auto frames_together = static_cast<std::size_t>(state.range(0));
    double megabytes = 0.0;
    double percent = 0.0;
    for (auto _ : state) {
        const fixtures::Folder folder;
        double processor_s = 0.0;
        {
            results::Store store = fixtures::open(folder / "tracked.sqlite");
            const studies::Study study = fixtures::study({"one"});
            const studies::StudyPlan plan = fixtures::plan(study, "P01", 5);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", true));
            Person person;
            std::vector<results::TrackedFrame> frames;
            for (std::uint64_t number = 1; number <= session_frames; ++number) {
                frames.push_back(person.frame(number));
                if (frames.size() < frames_together && number < session_frames) continue;
                const double begin = bench::processorSeconds();
                store.recordTracking(frames, {});
                processor_s += bench::processorSeconds() - begin;
                frames.clear();
            }
            store.endSession(studies::SessionOutcome::finished, 1.7e9);
        }
        state.SetIterationTime(processor_s);
        megabytes = static_cast<double>(std::filesystem::file_size(folder / "tracked.sqlite")) / 1e6;
        percent = 100.0 * processor_s / session_s;
    }
    state.counters["MB"] = megabytes;
    state.counters["MB_limit"] = max_megabytes;
    state.counters["bytes_a_frame"] = 1e6 * megabytes / static_cast<double>(session_frames);
    state.counters["core_percent"] = percent;
    state.counters["core_percent_limit"] = max_percent_of_a_core;
    if (megabytes > max_megabytes || percent > max_percent_of_a_core) {
        const std::string reason = fmt::format("over a limit: {:.1f} MB of {}, {:.2f} % of a core of {}",
                                               megabytes, max_megabytes, percent, max_percent_of_a_core);
        state.SkipWithError(reason.c_str());
    }
}
// Full blocks, and the short ones of a session in which something happens four times a second.
BENCHMARK(session)
    ->Name("store/tracking_40_minutes")
    ->Arg(64)
    ->Arg(22)
    ->ArgName("frames_together")
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

void pack(benchmark::State& state) {
    Person person;
    std::vector<studies::TrackingSample> samples;
    for (std::uint64_t i = 1; i <= results::max_frames_in_block; ++i)
        samples.push_back(person.frame(i).sample);
    std::size_t bytes = 0;
    for (auto _ : state) {
        const std::string data = results::packTracking(samples);
        bytes = data.size();
        benchmark::DoNotOptimize(bytes);
    }
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(pack)->Name("store/pack_tracking_block")->Unit(benchmark::kMicrosecond);

void unpack(benchmark::State& state) {
    Person person;
    std::vector<studies::TrackingSample> samples;
    for (std::uint64_t i = 1; i <= results::max_frames_in_block; ++i)
        samples.push_back(person.frame(i).sample);
    const std::string data = results::packTracking(samples);
    for (auto _ : state) {
        const auto read = results::unpackTracking(data);
        if (!read) return state.SkipWithError("the block cannot be read");
        benchmark::DoNotOptimize(read->size());
    }
}
BENCHMARK(unpack)->Name("store/unpack_tracking_block")->Unit(benchmark::kMicrosecond);

}  // namespace
