#include "learning/gestures/training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/hash.hpp"
#include "gesture_trainer.hpp"
#include "learning/networks/training_state.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using motion::WeightsPrecision;

constexpr int gestures_report_every = 10;  // updates

std::vector<double> numbersOfScores(const GestureScores& s) {
    return {s.fgd_no_controls, s.fgd_pose_controls, s.fgd_style_controls, s.pcs, s.scs};
}
GestureScores scoresOf(const std::vector<double>& numbers, bool controls) {
    return {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3), numbers.at(4), controls};
}

/// Sums of what some updates gave.
struct LossSums {
    GestureLosses sums;
    int count = 0;

    void add(const GestureLosses& one) {
        sums.huber += one.huber;
        sums.gan += one.gan;
        sums.style += one.style;
        sums.discriminator += one.discriminator;
        ++count;
    }
    [[nodiscard]] GestureLosses mean() const {
        const double n = std::max(1, count);
        return {sums.huber / n, sums.gan / n, sums.style / n, sums.discriminator / n};
    }
};

/// A training under way, with what is on disk of it.
class GestureTraining {
  public:
    GestureTraining(const GestureTakes& takes, const GestureSettings& settings, const Provenance& provenance,
                    fs::path file)
        : takes_(takes),
          settings_(settings),
          provenance_(provenance),
          file_(std::move(file)),
          state_(file_, "takes"),
          trainer_(takes, settings) {}

    [[nodiscard]] std::size_t validationWindows() const { return trainer_.validationWindows(); }

    Result<GestureOutcome> run(const GestureCallbacks& callbacks) {
        const auto resumed = resume();
        if (!resumed) return tl::unexpected(resumed.error());
        if (!*resumed) trainer_.trainAutoencoder();
        outcome_.mean_pose = trainer_.meanPoseScores();
        using Clock = std::chrono::steady_clock;
        auto since = Clock::now();
        LossSums recent, of_epoch;
        while (outcome_.updates < trainer_.updates() && !outcome_.stopped) {
            const int number = outcome_.updates + 1;
            const GestureLosses losses = trainer_.update(number);
            if (!std::isfinite(losses.huber) || !trainer_.sound()) return diverged(number, losses.huber);
            outcome_.updates = number;
            recent.add(losses);
            of_epoch.add(losses);
            const bool last = number == trainer_.updates();
            const bool validate =
                last || number % (trainer_.updatesPerEpoch() * settings_.validate_every) == 0;
            if (!validate && number % gestures_report_every != 0) continue;
            const double seconds = std::chrono::duration<double>(Clock::now() - since).count();
            losses_ = recent.mean();
            TrainingProgress progress = progressNow();
            progress.numbers.emplace_back("seconds an update", seconds / recent.count);
            if (validate) {
                if (const auto tried = tryOut(progress, of_epoch.mean(), callbacks); !tried)
                    return tl::unexpected(tried.error());
                of_epoch = {};
            }
            outcome_.stopped = callbacks.report && !callbacks.report(progress) && !last;
            recent = {};
            since = Clock::now();
        }
        return finish();
    }

  private:
    /// What must be the same for a training to go on.
    [[nodiscard]] std::string identity() const {
        auto weights = trainer_.weights();
        weights.arrays.clear();
        weights.training_data_sha256 = takes_.sha256;
        weights.settings["validate_every"] = double(settings_.validate_every);
        return sha256Hex(motion::encodeWeights(weights, WeightsPrecision::float32));
    }

    /// Whether there was something to go on from.
    Result<bool> resume() {
        return state_.load(identity(), [this](torch::serialize::InputArchive& archive) {
            c10::IValue value;
            archive.read("updates", value);
            outcome_.updates = static_cast<int>(value.toInt());
            archive.read("best_epoch", value);
            outcome_.best_epoch = static_cast<int>(value.toInt());
            archive.read("best", value);
            outcome_.best = scoresOf(value.toDoubleVector(), settings_.shape.controls);
            trainer_.load(archive);
        });
    }

    Result<void> save() const {
        return state_.save(identity(), [this](torch::serialize::OutputArchive& archive) {
            archive.write("updates", c10::IValue(outcome_.updates));
            archive.write("best_epoch", c10::IValue(outcome_.best_epoch));
            archive.write("best", c10::IValue(numbersOfScores(outcome_.best)));
            trainer_.save(archive);
        });
    }

    [[nodiscard]] int epochNow() const {
        return (outcome_.updates + trainer_.updatesPerEpoch() - 1) / trainer_.updatesPerEpoch();
    }

    [[nodiscard]] TrainingProgress progressNow() const {
        TrainingProgress out{.update = outcome_.updates, .updates = trainer_.updates()};
        out.done = static_cast<double>(out.update) / out.updates;
        out.numbers = {{"epoch", epochNow()}, {"Huber", losses_.huber}, {"style", losses_.style}};
        if (losses_.discriminator > 0.0) {
            out.numbers.emplace_back("GAN", losses_.gan);
            out.numbers.emplace_back("discriminator", losses_.discriminator);
        }
        return out;
    }

    /// Scores the model, and writes the file where it is the best yet.
    Result<void> tryOut(TrainingProgress& progress, const GestureLosses& of_epoch,
                        const GestureCallbacks& callbacks) {
        const GestureScores tried = trainer_.validate();
        progress.numbers.emplace_back("FGD", tried.fgd_no_controls);
        if (tried.controls) {
            progress.numbers.emplace_back("FGD with poses", tried.fgd_pose_controls);
            progress.numbers.emplace_back("FGD with styles", tried.fgd_style_controls);
            progress.numbers.emplace_back("PCS", tried.pcs);
            progress.numbers.emplace_back("SCS", tried.scs);
        }
        progress.best = std::isfinite(tried.score()) &&
                        (outcome_.best_epoch == 0 || tried.score() < outcome_.best.score());
        if (progress.best) {
            outcome_.best = tried;
            outcome_.best_epoch = epochNow();
            if (const auto written = write(); !written) return written;
        }
        if (callbacks.epoch)
            callbacks.epoch(
                {epochNow(), outcome_.updates, of_epoch, tried, outcome_.mean_pose, progress.best});
        return save();
    }

    [[nodiscard]] Result<void> write() const {
        motion::NetworkWeights weights = trainer_.weights();
        setProvenance(weights, takes_.sha256, takes_.synthetic, settings_.seed, provenance_);
        weights.metrics = {{"updates", double(outcome_.updates)},
                           {"epoch", double(outcome_.best_epoch)},
                           {"validation_fgd_no_controls", outcome_.best.fgd_no_controls},
                           {"mean_pose_fgd", outcome_.mean_pose.fgd_no_controls},
                           {"mean_pose_pcs", outcome_.mean_pose.pcs},
                           {"mean_pose_scs", outcome_.mean_pose.scs}};
        if (outcome_.best.controls) {
            weights.metrics["validation_fgd_pose_controls"] = outcome_.best.fgd_pose_controls;
            weights.metrics["validation_fgd_style_controls"] = outcome_.best.fgd_style_controls;
            weights.metrics["validation_pcs"] = outcome_.best.pcs;
            weights.metrics["validation_scs"] = outcome_.best.scs;
        }
        return motion::writeWeights(file_, weights, WeightsPrecision::float16);
    }

    [[nodiscard]] tl::unexpected<Error> diverged(int number, double loss) const {
        return tl::unexpected(hasDiverged(
            file_, number, fmt::format("{}", loss),
            outcome_.best_epoch > 0 ? fmt::format("epoch {}", outcome_.best_epoch) : std::string()));
    }

    Result<GestureOutcome> finish() {
        if (outcome_.stopped) {
            // So that there is a file to use, whenever it was stopped.
            TrainingProgress progress = progressNow();
            const auto kept = outcome_.best_epoch == 0 ? tryOut(progress, losses_, {}) : save();
            if (!kept) return tl::unexpected(kept.error());
        } else {
            state_.remove();
        }
        return outcome_;
    }

    const GestureTakes& takes_;
    const GestureSettings& settings_;
    const Provenance& provenance_;
    fs::path file_;
    TrainingState state_;
    GestureTrainer trainer_;
    GestureOutcome outcome_;
    GestureLosses losses_;  ///< mean since the last report
};

Result<void> checkTakes(const std::vector<GestureTake>& takes, const char* what, const std::string& file) {
    if (takes.empty()) return fail(file, fmt::format("found no takes {}, expected at least one", what));
    for (std::size_t i = 0; i < takes.size(); ++i)
        if (takes[i].motion.frames.empty() || takes[i].samples.empty())
            return fail(
                fmt::format("{}: take {} {}", file, i + 1, what),
                fmt::format("found {} frames of motion and {} samples of sound, expected some of each",
                            takes[i].motion.frames.size(), takes[i].samples.size()));
    return {};
}

}  // namespace

Result<GestureOutcome> trainGestures(const GestureTakes& takes, const GestureSettings& settings,
                                     const Provenance& provenance, const fs::path& file,
                                     const GestureCallbacks& callbacks) {
    if (const auto checked = checkTakes(takes.training, "to train on", file.string()); !checked)
        return tl::unexpected(checked.error());
    if (const auto checked = checkTakes(takes.validation, "held out", file.string()); !checked)
        return tl::unexpected(checked.error());
    if (takes.words.size() != settings.shape.word_size)
        return fail(file.string(), fmt::format("found words' vectors of {} numbers, expected {}",
                                               takes.words.size(), settings.shape.word_size));
    GestureTraining training(takes, settings, provenance, file);
    if (training.validationWindows() < 2)
        return fail(file.string(), "found a single window of motion held out, expected at least two: 6 s");
    return training.run(callbacks);
}

}  // namespace deixis::learning
