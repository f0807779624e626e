#include "stimuli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "assets/bvh.hpp"
#include "assets/data_paths.hpp"
#include "assets/demonstrations.hpp"
#include "assets/humanoid_file.hpp"
#include "assets/manifest.hpp"
#include "clip_files.hpp"
#include "clip_retargeting.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "generation.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

// The manifest of a built-in system's clips, made now where it is not there yet. `maker` is the product's own
// avatar, for which they are made whichever one the study shows. Once made, the clips stay as
// they are: a later version of the program must not change what a running study shows.
Result<fs::path> builtInManifest(const studies::SystemSource& system, const StudySetup& setup,
                                 const assets::Avatar& maker, const fs::path& folder) {
    const fs::path parameters_file = assets::dataFile("demonstrations.toml");
    const auto parameter_bytes = readFile(parameters_file);
    if (!parameter_bytes) return tl::unexpected(parameter_bytes.error());
    const motion::HoldManner manner{system.hold_s, system.unsteadiness_m};
    std::vector<assets::ListedTarget> targets;
    std::string made_from = fmt::format("{}\n{}\n{}\n{}\n", system.generator, setup.study.seed,
                                        *parameter_bytes, maker.content_hash);
    if (manner.hold_s) made_from += fmt::format("hold {}\n", *manner.hold_s);
    if (manner.unsteadiness_m) made_from += fmt::format("unsteadiness {}\n", *manner.unsteadiness_m);
    for (const auto& item : setup.targets) {
        if (!item.placed)
            return fail(
                setup.study.targets.from_manifest,
                fmt::format("item {} has no target, but the system '{}' points at targets", item.id,
                            system.name),
                "A built-in system can stand beside a lab's clips only where these point at something");
        targets.push_back({item.id, item.target});
        made_from += fmt::format("{} {} {} {}\n", item.id, item.target.x, item.target.y, item.target.z);
    }
    const std::string key = sha256Hex(made_from);
    const fs::path clips = folder / fmt::format("{}-{}", system.generator, key.substr(0, 12));
    const fs::path manifest = clips / "manifest.csv";
    std::error_code code;
    if (fs::exists(manifest, code)) return manifest;

    const auto parameters = assets::loadDemonstrationParameters(parameters_file);
    if (!parameters) return tl::unexpected(parameters.error());
    const auto generator = motion::makeGenerator(system.generator, maker.skeleton, *parameters);
    if (!generator) return tl::unexpected(generator.error());
    const auto rows = generateClips(**generator, targets, setup.study.seed, manner, clips, true);
    if (!rows) return tl::unexpected(rows.error());
    return manifest;
}

using RowsByTarget = std::map<std::string, const assets::ManifestRow*>;

// The rows of one of the study's systems: those that carry its name, or all where the manifest is of one
// system only.
Result<RowsByTarget> rowsOfSystem(const assets::Manifest& manifest, const studies::SystemSource& system) {
    std::set<std::string> names;
    for (const auto& row : manifest.rows) names.insert(row.system);
    if (!names.contains(system.name) && names.size() > 1)
        return fail(manifest.file.string(),
                    fmt::format("has clips of the systems {}, but none named '{}' as the study does",
                                fmt::join(names, ", "), system.name));
    RowsByTarget rows;
    for (const auto& row : manifest.rows) {
        if (names.size() > 1 && row.system != system.name) continue;
        if (!rows.emplace(row.target_id, &row).second)
            return fail(manifest.file.string(),
                        fmt::format("has two clips of system '{}' for target {}", row.system, row.target_id));
    }
    return rows;
}

// The clip for a target: its row and its file are there, and it was made for where the study's target is.
Result<void> checkTarget(const assets::Manifest& manifest, const RowsByTarget& rows,
                         const studies::SystemSource& system, const studies::TargetItem& item) {
    const auto found = rows.find(item.id);
    if (found == rows.end())
        return fail(
            manifest.file.string(),
            fmt::format("has no clip for target {}, which the system '{}' needs", item.id, system.name));
    const assets::ManifestRow& row = *found->second;
    const std::string where = manifest.file.string() + ": clip " + row.clip;
    const Vec3& target = item.target;
    if (item.placed && !row.target)
        return fail(where, fmt::format("has no target, but the study's {} is at ({:.4f}, {:.4f}, {:.4f})",
                                       row.target_id, target.x, target.y, target.z));
    if (item.placed && glm::length(*row.target - target) > 0.001)
        return fail(
            where,
            fmt::format("was made for the target ({:.4f}, {:.4f}, {:.4f}), but the study's {} is at ({:.4f}, "
                        "{:.4f}, {:.4f})",
                        row.target->x, row.target->y, row.target->z, row.target_id, target.x, target.y,
                        target.z),
            "Make the clips for the targets that 'deixis targets' prints for this study");
    std::error_code code;
    if (!fs::is_regular_file(manifest.file.parent_path() / row.clip, code))
        return fail(where, "No such file", "Clips are looked for beside their manifest");
    return {};
}

Result<void> checkFrames(const assets::Manifest& manifest, const assets::ManifestRow& row,
                         const motion::Clip& clip) {
    const std::string where = manifest.file.string() + ": clip " + row.clip;
    if (row.phases && row.phases->end_frame >= clip.frameCount())
        return fail(where, fmt::format("end frame {} lies outside the clip, which has frames 0 to {}",
                                       row.phases->end_frame, clip.frameCount() - 1));
    if (std::abs(row.fps - clip.framesPerSecond()) > 0.01 * row.fps)
        return fail(where, fmt::format("fps is {:g}, but the clip has {:.4g} frames per second", row.fps,
                                       clip.framesPerSecond()));
    return {};
}

struct LabClip {
    const assets::ImportedClip& imported;
    const fs::path& file;
    const std::string& bytes;
};

struct ShownClip {
    motion::Clip clip;
    results::ClipRecord record;
};

// A lab's clip on the avatar. One of another figure is retargeted once and kept as a file, which is what the
// session shows and records: a later version of the program must not change what a running study shows.
Result<ShownClip> onAvatar(const LabClip& lab, const assets::ManifestRow& row,
                           const studies::SystemSource& system, const assets::Avatar& avatar,
                           const fs::path& folder) {
    if (isOnAvatar(lab.imported.clip, avatar)) {
        auto clip = clipOnAvatar(lab.imported, lab.file.string(), avatar);
        if (!clip) return tl::unexpected(clip.error());
        return ShownClip{std::move(*clip), {lab.file.string(), sha256Hex(lab.bytes)}};
    }
    const RetargetManner manner{system.keep, system.pointing_fingers};
    std::string made_from = lab.bytes + avatar.content_hash + assets::manifestCsv({row}) +
                            fmt::format("{} {}", motion::keepName(manner.keep), manner.close_hand);
    if (const auto words = readFile(assets::humanoidFileOf(lab.file))) made_from += *words;
    const fs::path made = folder / fmt::format("{}-on-avatar", system.name) /
                          fmt::format("{}.bvh", sha256Hex(made_from).substr(0, 16));
    std::error_code code;
    if (!fs::exists(made, code)) {
        assets::ManifestRow measured = row;
        const auto clip = retargetRow(lab.imported, lab.file.string(), avatar, manner, measured);
        if (!clip) return tl::unexpected(clip.error());
        if (auto written = writeFile(made, assets::writeBvh(*clip)); !written)
            return tl::unexpected(written.error());
    }
    const auto bytes = readFile(made);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto read = assets::importClip(made);
    if (!read) return tl::unexpected(read.error());
    auto clip = clipOnAvatar(*read, made.string(), avatar);
    if (!clip) return tl::unexpected(clip.error());
    return ShownClip{std::move(*clip), {made.string(), sha256Hex(*bytes)}};
}

}  // namespace

Result<StimulusLibrary> StimulusLibrary::load(const StudySetup& setup,
                                              const std::vector<studies::StudyPlan>& plans,
                                              const assets::Avatar& avatar, const fs::path& folder) {
    std::set<studies::Stimulus> wanted;
    for (const auto& plan : plans)
        for (const auto& trial : plan.trials) wanted.insert(trial.stimuli.begin(), trial.stimuli.end());
    std::optional<assets::Avatar> own;
    if (!setup.study.avatar.empty()) {
        auto loaded = loadShippedAvatar();
        if (!loaded) return tl::unexpected(loaded.error());
        own = std::move(*loaded);
    }
    const assets::Avatar& maker = own ? *own : avatar;
    // Systems do not depend on each other, and making and reading their clips is most of a start's work.
    using Part = std::map<studies::Stimulus, Loaded>;
    const auto loadSystem = [&](const studies::SystemSource& system) -> Result<Part> {
        Result<fs::path> manifest_file = fs::path(system.manifest);
        if (!system.generator.empty()) manifest_file = builtInManifest(system, setup, maker, folder);
        if (!manifest_file) return tl::unexpected(manifest_file.error());
        const auto manifest = assets::readManifest(*manifest_file);
        if (!manifest) return tl::unexpected(manifest.error());
        const auto rows = rowsOfSystem(*manifest, system);
        if (!rows) return tl::unexpected(rows.error());
        // What any participant may meet must be there before the first one starts.
        for (const auto& item : setup.targets)
            if (auto checked = checkTarget(*manifest, *rows, system, item); !checked)
                return tl::unexpected(checked.error());
        Part part;
        for (const studies::Stimulus& stimulus : wanted) {
            if (stimulus.system != system.name) continue;
            const auto found = rows->find(stimulus.item);
            if (found == rows->end())
                return fail(manifest_file->string(),
                            fmt::format("has no clip for item {}, which a stored plan shows", stimulus.item));
            const assets::ManifestRow& row = *found->second;
            const fs::path file = manifest_file->parent_path() / row.clip;
            const auto bytes = readFile(file);
            if (!bytes) return tl::unexpected(bytes.error());
            const auto read = assets::importClip(file);
            if (!read) return tl::unexpected(read.error());
            if (auto checked = checkFrames(*manifest, row, read->clip); !checked)
                return tl::unexpected(checked.error());
            auto loaded = onAvatar({*read, file, *bytes}, row, system, avatar, folder);
            if (!loaded) return tl::unexpected(loaded.error());
            part.emplace(stimulus, Loaded{std::move(loaded->clip), std::move(loaded->record)});
        }
        return part;
    };

    std::vector<std::future<Result<Part>>> parts;
    for (const auto& system : setup.study.systems)
        parts.push_back(std::async(std::launch::async, loadSystem, std::cref(system)));
    StimulusLibrary library;
    std::optional<Error> first_error;
    for (auto& future : parts) {
        auto part = future.get();
        if (!part) {
            if (!first_error) first_error = part.error();
            continue;
        }
        library.clips_.merge(*part);
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

results::ClipRecords StimulusLibrary::records() const {
    results::ClipRecords out;
    for (const auto& [stimulus, loaded] : clips_) out.emplace(stimulus, loaded.record);
    return out;
}

}  // namespace deixis::app
