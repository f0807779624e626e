#include "app/study/stimuli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <glm/geometric.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/clips/clip_files.hpp"
#include "app/clips/study_clips.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/tables/manifest.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

/// What the plans show, and where the targets then are; zero of an item without one.
Result<std::map<studies::Stimulus, Vec3>> wantedBy(const std::vector<studies::StudyPlan>& plans) {
    std::map<studies::Stimulus, Vec3> wanted;
    for (const auto& plan : plans)
        for (const auto& trial : plan.trials)
            for (const auto& stimulus : trial.stimuli) {
                const auto [known, is_new] = wanted.emplace(stimulus, trial.target);
                if (!is_new && glm::length(known->second - trial.target) > 0.001)
                    return fail(plan.participant,
                                fmt::format("{} has two targets in the plans shown together", stimulus.item));
            }
    return wanted;
}

/// What is shown in a stage that is not muted.
std::set<studies::Stimulus> heardIn(const studies::Study& study,
                                    const std::vector<studies::StudyPlan>& plans) {
    std::set<std::string> muted;
    for (const auto& stage : study.stages)
        if (stage.muted) muted.insert(stage.name);
    std::set<studies::Stimulus> heard;
    for (const auto& plan : plans)
        for (const auto& trial : plan.trials)
            if (!muted.contains(trial.stage)) heard.insert(trial.stimuli.begin(), trial.stimuli.end());
    return heard;
}

/// A file of the locked set, as it was locked, to the byte, whatever was remembered of it.
struct LockedBytes {
    std::string name;
    std::string hash;
    std::string bytes;
};
Result<LockedBytes> lockedBytes(const LockedStudy& locked, const fs::path& file) {
    auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    LockedBytes out{file.lexically_relative(locked.folder).generic_string(), sha256Hex(*bytes),
                    std::move(*bytes)};
    if (const auto kept = locked.files.find(out.name); kept == locked.files.end() || kept->second != out.hash)
        return tl::unexpected(damaged(locked.folder, out.name + " was changed"));
    return out;
}

}  // namespace

Result<StimulusLibrary> StimulusLibrary::load(const LockedStudy& locked,
                                              const std::vector<studies::StudyPlan>& plans,
                                              const assets::Avatar& avatar) {
    const auto wanted = wantedBy(plans);
    if (!wanted) return tl::unexpected(wanted.error());
    const auto heard = heardIn(locked.setup.study, plans);
    struct Part {
        std::map<studies::Stimulus, Loaded> clips;
        std::map<std::string, speech::Sound> sounds;
    };
    const auto loadSystem = [&](const studies::SystemSource& system) -> Result<Part> {
        const auto manifest = assets::readManifest(locked.manifest(system.name));
        if (!manifest) return tl::unexpected(manifest.error());
        Part part;
        for (const auto& [stimulus, target] : *wanted) {
            if (stimulus.system != system.name) continue;
            const studies::TargetItem item{stimulus.item, target, target != Vec3(0.0)};
            int before = stimulus.clip;
            const auto row = std::find_if(manifest->rows.begin(), manifest->rows.end(), [&](const auto& one) {
                return one.target_id == item.id && madeFor(one, item) && before-- == 0;
            });
            if (row == manifest->rows.end())
                return fail(
                    manifest->file.string(),
                    fmt::format("has no clip{} for {} at ({:.4f}, {:.4f}, {:.4f}), which a plan shows",
                                stimulus.clip > 0 ? fmt::format(" {}", stimulus.clip + 1) : "", item.id,
                                target.x, target.y, target.z));
            const fs::path folder = manifest->file.parent_path();
            const fs::path file = folder / row->clip;
            const auto kept = lockedBytes(locked, file);
            if (!kept) return tl::unexpected(kept.error());
            const auto read = assets::importClipBytes(kept->bytes, file.string());
            if (!read) return tl::unexpected(read.error());
            auto clip = clipOnAvatar(*read, file.string(), avatar);
            if (!clip) return tl::unexpected(clip.error());
            Loaded loaded{std::move(*clip), {kept->name, kept->hash, row->author, row->trial}};
            if (!row->sound.empty() && heard.contains(stimulus)) {
                const auto kept_sound = lockedBytes(locked, folder / row->sound);
                if (!kept_sound) return tl::unexpected(kept_sound.error());
                auto sound = speech::readWavBytes(kept_sound->bytes, (folder / row->sound).string());
                if (!sound) return tl::unexpected(sound.error());
                loaded.sound = {kept_sound->name, durationOf(*sound)};
                part.sounds.emplace(kept_sound->name, std::move(*sound));
            }
            if (const fs::path project = projectBeside(file);
                locked.files.contains(project.lexically_relative(locked.folder).generic_string())) {
                auto kept_project = lockedBytes(locked, project);
                if (!kept_project) return tl::unexpected(kept_project.error());
                loaded.project = std::move(kept_project->bytes);
            }
            part.clips.emplace(stimulus, std::move(loaded));
        }
        return part;
    };

    std::vector<std::future<Result<Part>>> parts;
    for (const auto& system : locked.setup.study.systems)
        parts.push_back(std::async(std::launch::async, loadSystem, std::cref(system)));
    StimulusLibrary library;
    std::optional<Error> first_error;
    for (auto& future : parts) {
        auto part = future.get();
        if (part) {
            library.clips_.merge(part->clips);
            library.sounds_.merge(part->sounds);
        } else if (!first_error) {
            first_error = part.error();
        }
    }
    if (first_error) return tl::unexpected(*first_error);
    return library;
}

const motion::Clip& StimulusLibrary::clip(const studies::Stimulus& stimulus) const {
    const auto found = clips_.find(stimulus);
    if (found == clips_.end())
        throw std::logic_error("clip of " + stimulus.system + " for " + stimulus.item + " was not loaded");
    return found->second.clip;
}

const studies::ClipSound* StimulusLibrary::sound(const studies::Stimulus& stimulus) const {
    const auto found = clips_.find(stimulus);
    return found == clips_.end() || found->second.sound.id.empty() ? nullptr : &found->second.sound;
}

const std::string* StimulusLibrary::project(const studies::Stimulus& stimulus) const {
    const auto found = clips_.find(stimulus);
    return found == clips_.end() || found->second.project.empty() ? nullptr : &found->second.project;
}

results::ClipRecords StimulusLibrary::records() const {
    results::ClipRecords out;
    for (const auto& [stimulus, loaded] : clips_) out.emplace(stimulus, loaded.record);
    return out;
}

}  // namespace deixis::app
