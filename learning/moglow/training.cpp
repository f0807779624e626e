#include "learning/moglow/training.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "trainer.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using motion::WeightsPrecision;

constexpr int report_every = 10;

/// A training under way, with what is on disk of it.
class Training {
  public:
    Training(const MoglowData& data, const motion::PoseFeatures& features, const MoglowSettings& settings,
             const Provenance& provenance, fs::path file)
        : data_(data),
          settings_(settings),
          provenance_(provenance),
          file_(std::move(file)),
          state_(file_.string() + ".training"),
          trainer_(data, features, settings),
          avatar_(features.skeleton()) {
        outcome_.best.reward = -1.0;  // any other is better
    }

    Result<MoglowOutcome> run(const MoglowReport& report) {
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
            MoglowProgress progress{number, settings_.updates, sum / summed, seconds / summed};
            if (validate)
                if (const auto tried = tryOut(progress); !tried) return tl::unexpected(tried.error());
            reported_bits_ = progress.bits;
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

    Result<void> resume() {
        if (!fs::exists(state_)) return {};
        try {
            torch::serialize::InputArchive archive;
            archive.load_from(state_.string());
            c10::IValue value;
            archive.read("identity", value);
            if (value.toStringRef() != identity())
                return fail(state_.string(), "this is of a training with other settings or demonstrations",
                            "Remove it to begin anew, or use the settings it was begun with");
            archive.read("updates", value);
            outcome_.updates = static_cast<int>(value.toInt());
            archive.read("best_update", value);
            outcome_.best_update = static_cast<int>(value.toInt());
            archive.read("best", value);
            const auto best = value.toDoubleVector();
            outcome_.best = {best.at(0), best.at(1), best.at(2)};
            trainer_.load(archive);
        } catch (const std::exception&) {
            return fail(state_.string(), "this is no state of a training, or damaged",
                        "Remove it to begin anew");
        }
        return {};
    }

    Result<void> save() const {
        torch::serialize::OutputArchive archive;
        archive.write("identity", c10::IValue(identity()));
        archive.write("updates", c10::IValue(outcome_.updates));
        archive.write("best_update", c10::IValue(outcome_.best_update));
        archive.write("best", c10::IValue(std::vector<double>{outcome_.best.reward, outcome_.best.at_rest,
                                                              outcome_.best.jerk_ratio}));
        trainer_.save(archive);
        std::string bytes;
        archive.save_to([&bytes](const void* data, std::size_t size) {
            bytes.append(static_cast<const char*>(data), size);
            return size;
        });
        return writeFile(state_, bytes);
    }

    /// Generates for the held-out targets with the numbers as a file would hold them, and writes the file
    /// where they are the best yet.
    Result<void> tryOut(MoglowProgress& progress) {
        auto weights = trainer_.weights();
        weights.training_data_sha256 = data_.sha256;
        weights.program_version = provenance_.version;
        weights.commit = provenance_.commit;
        weights.synthetic = data_.synthetic;
        const auto held =
            motion::decodeWeights(motion::encodeWeights(weights, WeightsPrecision::float16), file_.string());
        if (!held) return tl::unexpected(held.error());
        const auto system = motion::makeMoglow(*held, avatar_);
        if (!system) return tl::unexpected(system.error());
        progress.validation = measureGenerated(**system, data_.validation, settings_.seed);
        progress.validation_bits = trainer_.validationBits();
        progress.best = std::isfinite(progress.validation->jerk_ratio) &&
                        std::isfinite(progress.validation_bits) &&
                        (outcome_.best_update == 0 || progress.validation->score() > outcome_.best.score());
        if (progress.best) {
            outcome_.best = *progress.validation;
            outcome_.best_update = progress.update;
            weights.metrics = {{"updates", double(progress.update)},
                               {"validation_reward", outcome_.best.reward},
                               {"validation_at_rest", outcome_.best.at_rest},
                               {"validation_jerk_ratio", outcome_.best.jerk_ratio},
                               {"validation_bits_a_frame", progress.validation_bits},
                               {"training_bits_a_frame", progress.bits}};
            const auto written = motion::writeWeights(file_, weights, WeightsPrecision::float16);
            if (!written) return written;
        }
        return save();
    }

    [[nodiscard]] tl::unexpected<Error> diverged(int number, double bits) const {
        const std::string kept = outcome_.best_update > 0
                                     ? fmt::format("The weights of update {} are kept", outcome_.best_update)
                                     : std::string("No weights were written yet");
        return fail(
            file_.string(),
            fmt::format("the training has diverged at update {}: its loss is {} bits a frame", number, bits),
            kept + "; a lower learning rate may help");
    }

    Result<MoglowOutcome> finish() {
        if (outcome_.stopped) {
            // So that there is a file to use, whenever it was stopped.
            MoglowProgress progress{outcome_.updates, settings_.updates, reported_bits_};
            const auto kept = outcome_.best_update == 0 ? tryOut(progress) : save();
            if (!kept) return tl::unexpected(kept.error());
        } else {
            std::error_code ignored;
            fs::remove(state_, ignored);
        }
        return outcome_;
    }

    const MoglowData& data_;
    const MoglowSettings& settings_;
    const Provenance& provenance_;
    fs::path file_;
    fs::path state_;
    MoglowTrainer trainer_;
    motion::Skeleton avatar_;
    MoglowOutcome outcome_;
    double reported_bits_ = 0.0;
};

}  // namespace

Result<MoglowOutcome> trainMoglow(const MoglowData& data, const MoglowSettings& settings,
                                  const Provenance& provenance, const fs::path& file,
                                  const MoglowReport& report) {
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
