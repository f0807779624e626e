// Trains moglow on the synthetic demonstrations: deixis-learn-moglow FILE demonstrations.toml [UPDATES
// [SEED]]. Until 'deixis learn' does it.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "assets/data/demonstrations.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/number.hpp"
#include "learning/moglow/training.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

namespace {

using namespace deixis;

volatile std::sig_atomic_t interrupted = 0;

/// Every 13th demonstration and its mirror image are held out.
Result<learning::MoglowData> syntheticData(const std::filesystem::path& parameters_file) {
    const auto bytes = readFile(parameters_file);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto parameters = assets::parseDemonstrationParameters(*bytes, parameters_file.string());
    if (!parameters) return tl::unexpected(parameters.error());
    const auto made = motion::makeDemonstrations(motion::referenceHumanoid(), *parameters);
    if (!made) return tl::unexpected(made.error());
    constexpr std::size_t held_out = 13;
    learning::MoglowData out;
    for (std::size_t i = 0; i < made->size(); ++i) {
        auto& set = i % held_out == held_out / 2 ? out.validation : out.training;
        set.push_back((*made)[i]);
        set.push_back(motion::mirrored((*made)[i]));
    }
    out.sha256 = sha256Hex(*bytes);
    return out;
}

bool show(const learning::MoglowProgress& progress) {
    if (progress.validation)
        fmt::print(
            "{:6} of {}: {:8.2f} bits a frame, held out {:8.2f}; Eq. 2 {:.3f}, at rest {:.0f} %, jerk x "
            "{:.2f}{}\n",
            progress.update, progress.updates, progress.bits, progress.validation_bits,
            progress.validation->reward, 100.0 * progress.validation->at_rest,
            progress.validation->jerk_ratio, progress.best ? "; written" : "");
    else if (progress.update % 50 == 0)
        fmt::print("{:6} of {}: {:8.2f} bits a frame, {:.2f} s an update\n", progress.update,
                   progress.updates, progress.bits, progress.seconds_an_update);
    std::fflush(stdout);
    return interrupted == 0;
}

Result<void> run(const std::string& file, const learning::MoglowSettings& settings,
                 const std::string& parameters) {
    const auto data = syntheticData(parameters);
    if (!data) return tl::unexpected(data.error());
    const auto outcome = learning::trainMoglow(*data, settings, {}, file, show);
    if (!outcome) return tl::unexpected(outcome.error());
    const auto system = motion::loadMoglow(file, motion::referenceHumanoid());
    if (!system) return tl::unexpected(system.error());
    const auto on_training = learning::measureGenerated(**system, data->training, 1);
    fmt::print(
        "{} after {} updates, best at {}; training targets: Eq. 2 {:.3f}, at rest {:.0f} %, jerk x {:.2f}\n",
        outcome->stopped ? "stopped" : "done", outcome->updates, outcome->best_update, on_training.reward,
        100.0 * on_training.at_rest, on_training.jerk_ratio);
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int at) { return argc > at ? naturalNumber(argv[at]) : std::nullopt; };
    if (argc < 3 || argc > 5 || (argc > 3 && !number(3)) || (argc > 4 && !number(4))) {
        fmt::print(stderr, "usage: deixis-learn-moglow FILE demonstrations.toml [UPDATES [SEED]]\n");
        return 2;
    }
    std::signal(SIGINT, [](int) { interrupted = 1; });
    learning::MoglowSettings settings;
    settings.updates = static_cast<int>(number(3).value_or(settings.updates));
    settings.seed = number(4).value_or(settings.seed);
    const auto done = run(argv[1], settings, argv[2]);
    if (done) return 0;
    fmt::print(stderr, "{}\n", done.error().text());
    return 1;
}
