#include "generation.hpp"

#include <fmt/format.h>

#include "assets/bvh.hpp"
#include "core/files.hpp"
#include "core/random.hpp"

namespace deixis::app {

Result<std::vector<assets::ManifestRow>> generateClips(const motion::Generator& generator,
                                                       const std::vector<assets::ListedTarget>& targets,
                                                       std::uint64_t seed, const motion::HoldManner& manner,
                                                       const std::filesystem::path& folder) {
    std::error_code code;
    if (const auto manifest = folder / "manifest.csv"; std::filesystem::exists(manifest, code)) {
        const auto before = assets::readManifest(manifest);
        if (!before) return tl::unexpected(before.error());
        for (const auto& row : before->rows)
            if (row.system != generator.name())
                return fail(manifest.string(),
                            fmt::format("lists clips of the system '{}'; those of {} would take their place",
                                        row.system, generator.name()),
                            "Give each system a folder of its own");
    }
    std::vector<assets::ManifestRow> rows;
    for (const auto& [id, position] : targets) {
        const std::uint64_t clip_seed = deriveSeed(seed, id);
        const motion::GeneratedClip made = generator.generate({id, position, clip_seed, manner});
        assets::ManifestRow row;
        row.clip = fmt::format("{}_{}.bvh", generator.name(), id);
        row.system = std::string(generator.name());
        row.target_id = id;
        row.target = position;
        row.phases = assets::PointingPhases{made.onset_frame, made.peak_frame, made.hold_frame,
                                            made.end_frame, made.hand};
        row.fps = made.clip.framesPerSecond();
        row.seed = clip_seed;
        if (auto written = writeFile(folder / row.clip, assets::writeBvh(made.clip)); !written)
            return tl::unexpected(written.error());
        rows.push_back(std::move(row));
    }
    if (auto written = writeFile(folder / "manifest.csv", assets::manifestCsv(rows)); !written)
        return tl::unexpected(written.error());
    return rows;
}

}  // namespace deixis::app
