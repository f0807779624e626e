#include "demonstrations.hpp"

#include <fmt/format.h>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_retargeting.hpp"
#include "app/clips/synthetic_demonstrations.hpp"
#include "app/clips/systems.hpp"
#include "app/program/version.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

Result<learning::DemonstrationSets> synthetic(bool mirrored) {
    auto library = syntheticDemonstrations();
    if (!library) return tl::unexpected(library.error());
    auto out = learning::splitDemonstrations(std::move(library->made), mirrored);
    out.sha256 = library->sha256;
    return out;
}

/// As the row says, or as the clip shows.
Result<motion::GesturePhases> phasesOf(const motion::Clip& clip, const assets::ManifestRow& row,
                                       const std::string& file) {
    if (row.phases) return *row.phases;
    const auto map = motion::mapByVrmNames(clip.skeleton);
    const auto world = motion::worldPoses(clip);
    const motion::Side hand = motion::recognisedHand(world, map).hand;
    const auto found = motion::detectPhases(motion::jointTrajectory(world, map[motion::armBones(hand).hand]),
                                            hand, clip.frame_time_s);
    if (!found) return tl::unexpected(inFile(found.error(), file));
    return found->phases;
}

}  // namespace

Error inFile(Error error, const std::string& file) {
    if (error.where.empty()) error.where = file;
    return error;
}

Result<assets::Manifest> readDemonstrations(const std::string& file) {
    auto manifest = assets::readManifest(file);
    if (!manifest) return manifest;
    if (manifest->rows.empty()) return fail(file, "lists no clips, expected at least one");
    for (const assets::ManifestRow& row : manifest->rows)
        if (!row.target)
            return fail(fmt::format("{}:{}: target_x", file, row.line),
                        fmt::format("clip {} has no target, expected one for every clip", row.clip),
                        "A demonstration shows how to point at its target");
    return manifest;
}

/// The row's clip on the avatar; the row then is of that.
Result<motion::Clip> demonstrationClip(const fs::path& file, const assets::Avatar& avatar,
                                       assets::ManifestRow& row) {
    auto imported = assets::importClip(file);
    if (!imported) return tl::unexpected(imported.error());
    auto clip = isOnAvatar(imported->clip, avatar)
                    ? clipOnAvatar(*imported, file.string(), avatar)
                    : retargetRow(std::move(*imported), file.string(), avatar, {}, row);
    if (clip && row.phases)
        if (const auto fits = motion::checkPhases(*row.phases, clip->frameCount()); !fits)
            return tl::unexpected(inFile(fits.error(), file.string()));
    return clip;
}

Result<learning::DemonstrationSets> demonstrationSets(const std::string& file, const assets::Avatar& avatar,
                                                      bool mirrored) {
    if (file.empty()) return synthetic(mirrored);
    const auto manifest = readDemonstrations(file);
    if (!manifest) return tl::unexpected(manifest.error());
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    std::string made_from = *bytes;
    bool all_synthetic = true;
    std::vector<motion::Demonstration> demonstrations;
    for (assets::ManifestRow row : manifest->rows) {
        const fs::path path = fs::absolute(manifest->file).parent_path() / row.clip;
        const auto clip_bytes = readFile(path);
        if (!clip_bytes) return tl::unexpected(clip_bytes.error());
        made_from += sha256Hex(*clip_bytes);
        const auto clip = demonstrationClip(path, avatar, row);
        if (!clip) return tl::unexpected(clip.error());
        const auto phases = phasesOf(*clip, row, path.string());
        if (!phases) return tl::unexpected(phases.error());
        all_synthetic = all_synthetic && isSynthetic(row);
        demonstrations.push_back({*row.target, {*phases, *clip}});
    }
    auto out = learning::splitDemonstrations(std::move(demonstrations), mirrored);
    out.sha256 = sha256Hex(made_from);
    out.synthetic = all_synthetic;
    return out;
}

learning::Provenance programProvenance() {
    learning::Provenance out{programVersion(), {}};
    for (const auto& [name, value] : buildProperties())
        if (name == "commit") out.commit = value;
    return out;
}

}  // namespace deixis::app
