#include "learning/moglow/training.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "core/hash.hpp"
#include "learning/networks/training_state.hpp"
#include "trainer.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using motion::WeightsPrecision;

constexpr int report_every = 10;

/// A training under way, with what is on disk of it.
class Training {
  public:
    Training(const DemonstrationSets& data, const motion::PoseFeatures& features,
             const MoglowSettings& settings, const Provenance& provenance, fs::path file)
        : data_(data),
          settings_(settings),
          provenance_(provenance),
          file_(std::move(file)),
          state_(file_, "demonstrations"),
          trainer_(data, features, settings),
          avatar_(features.skeleton()) {
        outcome_.best.reward = -1.0;  // any other is better
    }

    Result<TrainingOutcome> run(const TrainingReport& report) {
        if (const auto resumed = resume(); !resumed) return tl::unexpected(resumed.error());
        using Clock = std::chrono::steady_clock;
        auto since = Clock::now();
        double sum = 0.0;
        int summed = 0;
        while (outcome_.updates < settings_.updates && !outcome_.stopped) {
            const int number = outcome_.updates + 1;
            const double bits = trainer_.update(number);
            if (!std::isfinite(bits) || !trainer_.sound()) return diverged(number, bits);
            outcome_.updates = number;
            sum += bits;
            ++summed;
            const bool last = number == settings_.updates;
            const bool validate = last || number % settings_.validate_every == 0;
            if (!validate && number % report_every != 0) continue;
            const double seconds = std::chrono::duration<double>(Clock::now() - since).count();
            bits_ = sum / summed;
            TrainingProgress progress = progressNow();
            progress.numbers.emplace_back("seconds an update", seconds / summed);
            if (validate)
                if (const auto tried = tryOut(progress); !tried) return tl::unexpected(tried.error());
            outcome_.stopped = !report(progress) && !last;
            sum = 0.0;
            summed = 0;
            since = Clock::now();
        }
        return finish();
    }

  private:
    /// What must be the same for a training to go on.
    [[nodiscard]] std::string identity() const {
        auto weights = trainer_.weights();
        weights.arrays.clear();
        weights.training_data_sha256 = data_.sha256;
        return sha256Hex(motion::encodeWeights(weights, WeightsPrecision::float32));
    }

    Result<bool> resume() {
        return state_.load(identity(), [this](torch::serialize::InputArchive& archive) {
            c10::IValue value;
            archive.read("updates", value);
            outcome_.updates = static_cast<int>(value.toInt());
            archive.read("best_update", value);
            outcome_.best_update = static_cast<int>(value.toInt());
            archive.read("best", value);
            const auto best = value.toDoubleVector();
            outcome_.best = {.reward = best.at(0), .at_rest = best.at(1), .jerk_ratio = best.at(2)};
            trainer_.load(archive);
        });
    }

    Result<void> save() const {
        return state_.save(identity(), [this](torch::serialize::OutputArchive& archive) {
            archive.write("updates", c10::IValue(outcome_.updates));
            archive.write("best_update", c10::IValue(outcome_.best_update));
            archive.write("best", c10::IValue(std::vector<double>{outcome_.best.reward, outcome_.best.at_rest,
                                                                  outcome_.best.jerk_ratio}));
            trainer_.save(archive);
        });
    }

    [[nodiscard]] TrainingProgress progressNow() const {
        TrainingProgress out{.update = outcome_.updates, .updates = settings_.updates};
        out.done = static_cast<double>(out.update) / out.updates;
        out.numbers = {{"bits a frame", bits_}};
        return out;
    }

    /// Generates for the held-out targets with the numbers as a file would hold them, and writes the file
    /// where they are the best yet.
    Result<void> tryOut(TrainingProgress& progress) {
        auto weights = trainer_.weights();
        setProvenance(weights, data_, settings_.seed, provenance_);
        const auto held =
            motion::decodeWeights(motion::encodeWeights(weights, WeightsPrecision::float16), file_.string());
        if (!held) return tl::unexpected(held.error());
        const auto system = motion::makeMoglow(*held, avatar_);
        if (!system) return tl::unexpected(system.error());
        const ClipMeasures tried = measureGenerated(**system, data_.validation, settings_.seed);
        const double held_out_bits = trainer_.validationBits();
        progress.validation = tried;
        progress.numbers.emplace_back("bits a frame held out", held_out_bits);
        progress.best = std::isfinite(tried.jerk_ratio) && std::isfinite(held_out_bits) &&
                        (outcome_.best_update == 0 || tried.score() > outcome_.best.score());
        if (progress.best) {
            outcome_.best = tried;
            outcome_.best_update = progress.update;
            weights.metrics = {{"updates", double(progress.update)},
                               {"validation_reward", tried.reward},
                               {"validation_at_rest", tried.at_rest},
                               {"validation_jerk_ratio", tried.jerk_ratio},
                               {"validation_arm_error_m", tried.arm_error_m},
                               {"validation_bits_a_frame", held_out_bits},
                               {"training_bits_a_frame", bits_}};
            const auto written = motion::writeWeights(file_, weights, WeightsPrecision::float16);
            if (!written) return written;
        }
        return save();
    }

    [[nodiscard]] tl::unexpected<Error> diverged(int number, double bits) const {
        return tl::unexpected(hasDiverged(
            file_, number, fmt::format("{} bits a frame", bits),
            outcome_.best_update > 0 ? fmt::format("update {}", outcome_.best_update) : std::string()));
    }

    Result<TrainingOutcome> finish() {
        if (outcome_.stopped) {
            // So that there is a file to use, whenever it was stopped.
            TrainingProgress progress = progressNow();
            const auto kept = outcome_.best_update == 0 ? tryOut(progress) : save();
            if (!kept) return tl::unexpected(kept.error());
        } else {
            state_.remove();
        }
        return outcome_;
    }

    const DemonstrationSets& data_;
    const MoglowSettings& settings_;
    const Provenance& provenance_;
    fs::path file_;
    TrainingState state_;
    MoglowTrainer trainer_;
    motion::Skeleton avatar_;
    TrainingOutcome outcome_;
    double bits_ = 0.0;  ///< a frame, mean since the last report
};

}  // namespace

Result<TrainingOutcome> trainMoglow(const DemonstrationSets& data, const MoglowSettings& settings,
                                    const Provenance& provenance, const fs::path& file,
                                    const TrainingReport& report) {
    if (data.training.empty() || data.validation.empty())
        return fail(
            file.string(),
            fmt::format("found {} demonstrations to train on and {} held out, expected at least one of each",
                        data.training.size(), data.validation.size()));
    const auto features = motion::PoseFeatures::of(data.training.front().gesture.clip.skeleton);
    if (!features) return tl::unexpected(features.error());
    return Training(data, *features, settings, provenance, file).run(report);
}

}  // namespace deixis::learning
