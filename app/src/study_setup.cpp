#include "study_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "assets/data_paths.hpp"
#include "assets/manifest.hpp"
#include "motion/generator.hpp"

namespace deixis::app {

namespace {

std::filesystem::path studyPath(const std::string& name) {
    const std::filesystem::path path = name;
    std::error_code code;
    if (std::filesystem::exists(path, code) || path.has_parent_path() || path.has_extension()) return path;
    return assets::dataFile("studies/" + name + ".toml");
}

}  // namespace

Result<StudySetup> loadStudySetup(const std::string& name) {
    auto study = studies::loadStudy(studyPath(name));
    if (!study) return tl::unexpected(study.error());
    const auto& known = motion::generatorNames();
    for (const auto& system : study->systems)
        if (!system.generator.empty() &&
            std::find(known.begin(), known.end(), system.generator) == known.end())
            return fail(
                fmt::format("{}: systems.{}.generator", study->file.string(), system.name),
                fmt::format("found \"{}\", expected one of {}", system.generator, fmt::join(known, ", ")));
    if (!study->targets.fit_manifest.empty()) {
        const auto manifest = assets::readManifest(study->targets.fit_manifest);
        if (!manifest) return tl::unexpected(manifest.error());
        std::vector<Vec3> positions;
        for (const auto& row : manifest->rows) positions.push_back(row.target);
        const auto fitted = studies::fitTargetSpace(study->targets, positions);
        if (!fitted) return tl::unexpected(fitted.error());
        study->targets = *fitted;
    }
    auto targets = studies::sampleTargets(study->targets, study->seed);
    if (!targets) {
        Error error = targets.error();
        error.where = study->file.string() + ": " + error.where;
        return tl::unexpected(error);
    }
    return StudySetup{std::move(*study), std::move(*targets)};
}

Result<assets::Avatar> loadShippedAvatar() {
    return assets::loadAvatar(assets::dataFile("avatar.glb"));
}

}  // namespace deixis::app
