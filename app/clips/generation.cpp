#include "app/clips/generation.hpp"

#include <fmt/format.h>

#include "app/clips/clip_output.hpp"
#include "assets/joints/bvh.hpp"
#include "core/random.hpp"

namespace deixis::app {

Result<std::vector<assets::ManifestRow>> generateClips(
    const System& system, const std::vector<assets::ListedTarget>& targets, std::uint64_t seed,
    const motion::HoldSettings& settings, const std::filesystem::path& folder, bool force, bool durable) {
    const motion::Generator& generator = *system.generator;
    OutputFolder output(folder, force, durable);
    const auto fileOf = [&](const std::string& id) { return fmt::format("{}_{}.bvh", generator.name(), id); };
    std::vector<std::filesystem::path> names;
    for (const auto& target : targets) names.emplace_back(fileOf(target.id));
    names.emplace_back("manifest.csv");
    if (auto free = output.expect(names); !free) return tl::unexpected(free.error());
    std::vector<assets::ManifestRow> rows;
    for (const auto& [id, position] : targets) {
        const std::uint64_t clip_seed = deriveSeed(seed, id);
        const motion::GeneratedClip made = generator.generate({id, position, clip_seed, settings});
        assets::ManifestRow row;
        row.clip = fileOf(id);
        row.system = std::string(generator.name());
        row.target_id = id;
        row.target = position;
        row.phases = made;
        row.fps = made.clip.framesPerSecond();
        row.seed = clip_seed;
        row.processing = system.processing;
        if (auto added = output.add(row.clip, assets::writeBvh(made.clip)); !added)
            return tl::unexpected(added.error());
        rows.push_back(std::move(row));
    }
    if (auto added = output.add("manifest.csv", assets::manifestCsv(rows)); !added)
        return tl::unexpected(added.error());
    if (auto finished = output.finish(); !finished) return tl::unexpected(finished.error());
    return rows;
}

}  // namespace deixis::app
