#include "app/clips/systems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "assets/data/data_paths.hpp"
#include "assets/data/demonstrations.hpp"
#include "core/files.hpp"
#include "motion/learned/flow_matching.hpp"
#include "motion/learned/gt_nn.hpp"
#include "motion/learned/moglow.hpp"
#include "physics/policy/amp_system.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

bool isLearned(const std::string& name) {
    return std::ranges::find(motion::learnedNames(), name) != motion::learnedNames().end();
}

/// gt-nn is both: without weights the synthetic demonstrations'. Any number of clusters is a system.
bool mayBeLearned(const std::string& name) {
    return isLearned(name) || name == motion::gt_nn_architecture || name.starts_with("amp-pfnn-");
}

Result<fs::path> sourceOf(const std::string& name) {
    if (!isLearned(name)) return assets::dataFile("demonstrations.toml");
    fs::path file = assets::dataFile("weights/" + name + ".weights");
    std::error_code code;
    if (fs::exists(file, code)) return file;
    return fail("",
                fmt::format("the system '{}' is learned, and no weights of it come with this program", name),
                "Train it with 'deixis learn' (docs/learning.md) and name its file: deixis generate " + name +
                    " --weights FILE");
}

Result<System> fromWeights(const std::string& name, const fs::path& file, const motion::Skeleton& avatar) {
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto weights = motion::decodeWeights(*bytes, file.string());
    if (!weights) return tl::unexpected(weights.error());
    Result<std::unique_ptr<motion::Generator>> system;
    if (weights->architecture == motion::moglow_architecture)
        system = motion::makeMoglow(*weights, avatar);
    else if (weights->architecture == motion::gt_nn_architecture)
        system = motion::makeGtNn(*weights, avatar);
    else if (weights->architecture == motion::flow_architecture)
        system = motion::makeFlow(*weights, avatar);
    else if (weights->architecture == physics::amp_architecture)
        system = physics::makeAmp(*weights, avatar);
    else
        return fail(file.string(),
                    fmt::format("these are weights of '{}', expected those of one of {}",
                                weights->architecture, fmt::join(motion::learnedNames(), ", ")));
    if (!system) return tl::unexpected(system.error());
    if ((*system)->name() != name)
        return fail(file.string(), fmt::format("these are weights of the system '{}', expected those of '{}'",
                                               (*system)->name(), name));
    return System{std::move(*system),
                  std::string(weights->synthetic ? assets::learned_from_synthetic : std::string_view())};
}

}  // namespace

Result<System> makeSystem(const std::string& name, const std::string& weights,
                          const motion::Skeleton& avatar) {
    if (!weights.empty()) {
        if (!mayBeLearned(name))
            return fail("--weights", fmt::format("the system '{}' has no weights", name),
                        fmt::format("Weights belong to a learned system: {}",
                                    fmt::join(motion::learnedNames(), ", ")));
        return fromWeights(name, weights, avatar);
    }
    const auto source = sourceOf(name);
    if (!source) return tl::unexpected(source.error());
    if (isLearned(name)) return fromWeights(name, *source, avatar);
    const auto parameters = assets::loadDemonstrationParameters(*source);
    if (!parameters) return tl::unexpected(parameters.error());
    auto generator = motion::makeGenerator(name, avatar, *parameters);
    if (!generator) return tl::unexpected(generator.error());
    return System{std::move(*generator),
                  std::string(name == motion::gt_nn_architecture ? assets::learned_from_synthetic
                                                                 : std::string_view())};
}

bool isSynthetic(const assets::ManifestRow& row) {
    return std::ranges::find(motion::generatorNames(), row.system) != motion::generatorNames().end() ||
           row.processing == assets::learned_from_synthetic || row.processing == assets::made_by_rules;
}

Result<std::string> systemSource(const std::string& name) {
    const auto source = sourceOf(name);
    if (!source) return tl::unexpected(source.error());
    return readFile(*source);
}

}  // namespace deixis::app
