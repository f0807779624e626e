#include "study_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "assets/data_paths.hpp"
#include "assets/manifest.hpp"
#include "motion/generator.hpp"

namespace deixis::app {

namespace {

// Which generators there are is not the study's to know.
void checkGenerators(const studies::Study& study, std::vector<Error>& problems) {
    const auto& known = motion::generatorNames();
    for (const auto& system : study.systems)
        if (!system.generator.empty() &&
            std::find(known.begin(), known.end(), system.generator) == known.end())
            problems.push_back(
                {fmt::format("{}: systems.{}.generator", study.file.string(), system.name),
                 fmt::format("found \"{}\", expected one of {}", system.generator, fmt::join(known, ", "))});
}

// The items of a manifest, each once, in its order.
Result<std::vector<studies::TargetItem>> itemsOfManifest(const std::string& file) {
    const auto manifest = assets::readManifest(file);
    if (!manifest) return tl::unexpected(manifest.error());
    std::vector<studies::TargetItem> items;
    for (const auto& row : manifest->rows) {
        const auto known = std::find_if(items.begin(), items.end(),
                                        [&](const auto& item) { return item.id == row.target_id; });
        if (known == items.end()) {
            items.push_back({row.target_id, row.target.value_or(Vec3(0.0)), row.target.has_value(), {}});
        } else if (known->placed != row.target.has_value() || (row.target && known->target != *row.target)) {
            return fail(file, fmt::format("item {} has different targets in different rows", row.target_id),
                        "The clips of one item are made for one target");
        }
    }
    if (items.empty()) return fail(file, "lists no clips");
    return items;
}

Result<void> fillTargetSpace(studies::Study& study) {
    if (study.targets.fit_manifest.empty()) return {};
    const auto manifest = assets::readManifest(study.targets.fit_manifest);
    if (!manifest) return tl::unexpected(manifest.error());
    std::vector<Vec3> positions;
    for (const auto& row : manifest->rows)
        if (row.target) positions.push_back(*row.target);
    const auto fitted = studies::fitTargetSpace(study.targets, positions);
    if (!fitted) return tl::unexpected(fitted.error());
    study.targets = *fitted;
    return {};
}

Result<std::vector<studies::TargetItem>> targetsOf(studies::Study& study) {
    if (auto filled = fillTargetSpace(study); !filled) return tl::unexpected(filled.error());
    if (study.targets.from_manifest.empty())
        return studies::sampleTargets(study.targets, study.distances, study.seed);
    auto items = itemsOfManifest(study.targets.from_manifest);
    if (!items) return items;
    study.targets.count = static_cast<int>(items->size());
    if (study.distances.empty()) return items;
    return studies::drawDistractors(std::move(*items), study.targets, study.distances, study.seed);
}

}  // namespace

tl::expected<StudySetup, std::vector<Error>> checkStudySetup(const std::string& name,
                                                             const std::string& language) {
    const studies::StudyFolders folders{assets::dataFile("languages"), assets::dataFile("questionnaires")};
    auto study = studies::loadStudy(assets::fileOrShipped(name, "studies"), folders, language);
    if (!study) return tl::unexpected(study.error());
    std::vector<Error> problems;
    checkGenerators(*study, problems);
    auto targets = targetsOf(*study);
    if (!targets) {
        Error error = targets.error();
        if (error.where.find(".csv") == std::string::npos)
            error.where = study->file.string() + ": " + error.where;
        problems.push_back(std::move(error));
    }
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    return StudySetup{std::move(*study), std::move(*targets)};
}

Result<StudySetup> loadStudySetup(const std::string& name, const std::string& language) {
    auto setup = checkStudySetup(name, language);
    if (setup) return std::move(*setup);
    Error first = setup.error().front();
    if (const std::size_t others = setup.error().size() - 1; others > 0) {
        if (!first.mend.empty()) first.mend += ". ";
        first.mend += fmt::format("'deixis check {}' lists {} more {}", name, others,
                                  others == 1 ? "problem" : "problems");
    }
    return tl::unexpected(std::move(first));
}

Result<assets::Avatar> loadShippedAvatar() {
    return assets::loadAvatar(assets::dataFile("avatar.glb"));
}

Result<assets::Avatar> loadAvatarOrShipped(const std::filesystem::path& file,
                                           const assets::AvatarOptions& options) {
    return file.empty() ? loadShippedAvatar() : assets::loadAvatar(file, options);
}

Result<assets::Avatar> loadStudyAvatar(const studies::Study& study) {
    auto avatar = loadAvatarOrShipped(study.avatar, {study.avatar_height_m});
    if (!avatar) {
        Error error = avatar.error();
        error.where = study.file.string() + ": study.avatar: " + error.where;
        return tl::unexpected(std::move(error));
    }
    return avatar;
}

}  // namespace deixis::app
