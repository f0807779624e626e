#include "app/clips/study_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/vector_relational.hpp>
#include <map>
#include <utility>

#include "app/clips/project_folder.hpp"
#include "app/clips/study_clips.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/tables/manifest.hpp"
#include "core/room.hpp"
#include "motion/synthesis/generator.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::app {

namespace {

// Which generators there are is not the study's to know.
void checkGenerators(const studies::Study& study, std::vector<Error>& problems) {
    const auto& known = motion::systemNames();
    for (const auto& system : study.systems)
        if (!system.generator.empty() &&
            std::find(known.begin(), known.end(), system.generator) == known.end())
            problems.push_back(
                {fmt::format("{}: systems.{}.generator", study.file.string(), system.name),
                 fmt::format("found \"{}\", expected one of {}", system.generator, fmt::join(known, ", "))});
}

// A manifest that the study names; its problems with the study's line and key.
tl::expected<assets::Manifest, std::vector<Error>> manifestNamed(const studies::Study& study,
                                                                 const std::string& key,
                                                                 const std::string& file) {
    auto manifest = assets::checkManifest(file);
    if (manifest) return manifest;
    for (Error& error : manifest.error()) error.where = study.place(key) + ": " + error.where;
    return manifest;
}

// The items of a manifest, each once, in its order.
tl::expected<std::vector<studies::TargetItem>, std::vector<Error>> itemsOfManifest(
    const studies::Study& study) {
    const std::string key = "targets.from_manifest";
    const std::string& file = study.targets.from_manifest;
    const auto manifest = manifestNamed(study, key, file);
    if (!manifest) return tl::unexpected(manifest.error());
    std::vector<studies::TargetItem> items;
    std::vector<Error> problems;
    const std::string where = study.place(key) + ": " + file;
    for (const auto& row : manifest->rows) {
        const auto known = std::find_if(items.begin(), items.end(),
                                        [&](const auto& item) { return item.id == row.target_id; });
        if (known == items.end())
            items.push_back({row.target_id, row.target.value_or(Vec3(0.0)), row.target.has_value(), {}});
        else if (known->placed != row.target.has_value() || (row.target && known->target != *row.target))
            problems.push_back({fmt::format("{}:{}: target_x", where, row.line),
                                fmt::format("item {} has different targets in different rows", row.target_id),
                                "The clips of one item are made for one target"});
    }
    if (items.empty()) problems.push_back({where, "lists no clips"});
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    return items;
}

// Those of a folder of projects, which have no places.
tl::expected<std::vector<studies::TargetItem>, std::vector<Error>> itemsOfFolder(
    const studies::Study& study) {
    const auto names = itemsOfProjects(study.targets.from_projects);
    if (!names) {
        Error error = names.error();
        error.where = study.place("targets.from_projects") + ": " + error.where;
        return tl::unexpected(std::vector<Error>{std::move(error)});
    }
    std::vector<studies::TargetItem> items;
    for (const std::string& name : *names) items.push_back({name, Vec3(0.0), false, {}});
    return items;
}

tl::expected<void, std::vector<Error>> fillTargetSpace(studies::Study& study) {
    const std::string key = "targets.fit_manifest";
    const std::string file = study.targets.fit_manifest;
    if (file.empty()) return {};
    const auto manifest = manifestNamed(study, key, file);
    if (!manifest) return tl::unexpected(manifest.error());
    std::vector<Vec3> positions;
    for (const auto& row : manifest->rows)
        if (row.target) positions.push_back(*row.target);
    const auto fitted = studies::fitTargetSpace(study.targets, positions);
    if (!fitted)
        return tl::unexpected(std::vector<Error>{
            {study.place(key) + ": " + file, fitted.error().message, fitted.error().hint}});
    study.targets = *fitted;
    return {};
}

tl::expected<std::vector<studies::TargetItem>, std::vector<Error>> targetsOf(studies::Study& study) {
    const auto inStudy = [&](Error error) {
        error.where = study.file.string() + ": " + error.where;
        return tl::unexpected(std::vector<Error>{std::move(error)});
    };
    if (auto filled = fillTargetSpace(study); !filled) return tl::unexpected(filled.error());
    const bool from_projects = !study.targets.from_projects.empty();
    if (study.targets.from_manifest.empty() && !from_projects) {
        auto targets = studies::sampleTargets(study);
        if (!targets) return inStudy(targets.error());
        return std::move(*targets);
    }
    auto items = from_projects ? itemsOfFolder(study) : itemsOfManifest(study);
    if (!items) return items;
    study.targets.count = static_cast<int>(items->size());
    if (study.distances.empty()) return items;
    auto targets = studies::drawDistractors(std::move(*items), study);
    if (!targets) return inStudy(targets.error());
    return std::move(*targets);
}

// How many clips a system has for an item, where they are several. What else is wrong with its manifest,
// whoever reads the clips tells: targets are printed before there are any.
void countClips(const studies::Study& study, std::vector<studies::TargetItem>& targets) {
    for (const auto& system : study.systems) {
        if (system.manifest.empty()) continue;
        const auto manifest = assets::readManifest(system.manifest);
        if (!manifest) continue;
        std::map<std::string, int> clips;
        for (const auto* row : rowsOfSystem(*manifest, system.name)) ++clips[row->target_id];
        for (auto& item : targets)
            if (const auto of = clips.find(item.id); of != clips.end() && of->second > 1)
                item.clips[system.name] = of->second;
    }
}

// Where there are no targets to look for clips of, the manifests of the systems are still read.
void checkManifests(const studies::Study& study, std::vector<Error>& problems) {
    for (const auto& system : study.systems) {
        if (system.manifest.empty()) continue;
        const auto manifest = manifestNamed(study, "systems." + system.name, system.manifest);
        if (!manifest) problems.insert(problems.end(), manifest.error().begin(), manifest.error().end());
    }
}

/// Balls behind a wall, under the floor or over the ceiling are never seen, and cannot be chosen.
void checkRoom(const studies::Study& study, const std::vector<studies::TargetItem>& targets,
               std::vector<Error>& problems) {
    const bool shows_balls =
        std::any_of(study.stages.begin(), study.stages.end(),
                    [](const studies::Stage& stage) { return studies::declarationOf(stage.kind).placed; });
    if (!shows_balls) return;
    const double radius_m = study.targets.ball_diameter_m / 2.0;
    const auto inside = [radius_m](const Vec3& centre) {
        constexpr double rounding_m = 1e-6;
        return glm::all(glm::greaterThanEqual(centre, room_low + radius_m - rounding_m)) &&
               glm::all(glm::lessThanEqual(centre, room_high - radius_m + rounding_m));
    };
    int outside = 0;
    std::string first;
    const auto visit = [&](const std::string& name, const Vec3& centre) {
        if (inside(centre)) return;
        if (outside++ == 0)
            first = fmt::format("{} at ({:.2f}, {:.2f}, {:.2f}) m", name, centre.x, centre.y, centre.z);
    };
    for (const studies::TargetItem& item : targets) {
        if (!item.placed) continue;
        visit(item.id, item.target);
        for (const auto& band : item.distractors)
            for (const Vec3& distractor : band) visit("a distractor of " + item.id, distractor);
    }
    if (outside == 0) return;
    problems.push_back(
        {study.file.string() + ": targets",
         fmt::format(
             "{} of the balls that can be drawn {} outside the room, where nobody can see or choose {}: "
             "{}. Expected x from {:g} to {:g}, y from {:g} to {:g}, z from {:g} to {:g} m",
             outside, outside == 1 ? "stands" : "stand", outside == 1 ? "it" : "them", first, room_low.x,
             room_high.x, room_low.y, room_high.y, room_low.z, room_high.z),
         "Lower radius_m or height_m, or narrow arc_deg; the avatar stands at (0, 0, 0) and faces +z"});
}

}  // namespace

tl::expected<StudySetup, std::vector<Error>> checkStudySetup(const std::string& name,
                                                             const std::string& language) {
    const studies::StudyFolders folders{
        assets::dataFile("languages"), assets::dataFile("questionnaires"), {}, assets::dataFile("speeches")};
    auto study = studies::loadStudy(assets::fileOrShipped(name, "studies"), folders, language);
    if (!study) return tl::unexpected(study.error());
    std::vector<Error> problems;
    checkGenerators(*study, problems);
    auto targets = targetsOf(*study);
    if (!targets) {
        problems.insert(problems.end(), targets.error().begin(), targets.error().end());
        checkManifests(*study, problems);
    } else {
        checkRoom(*study, *targets, problems);
        countClips(*study, *targets);
    }
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    return StudySetup{std::move(*study), std::move(*targets)};
}

Error firstOf(const std::vector<Error>& problems, const std::string& study) {
    Error first = problems.front();
    if (const std::size_t others = problems.size() - 1; others > 0) {
        if (!first.hint.empty()) first.hint += ". ";
        first.hint += fmt::format("'deixis check {}' lists {} more {}", study, others,
                                  others == 1 ? "problem" : "problems");
    }
    return first;
}

Result<StudySetup> loadStudySetup(const std::string& name, const std::string& language) {
    auto setup = checkStudySetup(name, language);
    if (setup) return std::move(*setup);
    return tl::unexpected(firstOf(setup.error(), name));
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
        error.where = study.place("study.avatar") + ": " + error.where;
        return tl::unexpected(std::move(error));
    }
    return avatar;
}

}  // namespace deixis::app
