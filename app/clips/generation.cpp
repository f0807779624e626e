#include "app/clips/generation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/clips/clip_output.hpp"
#include "assets/joints/bvh.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"

namespace deixis::app {

namespace {

struct MadeClip {
    assets::ManifestRow row;
    std::string text;  ///< BVH
};

MadeClip makeClip(const System& system, const assets::ListedTarget& target, std::uint64_t seed,
                  const motion::HoldSettings& settings, std::string file) {
    const motion::GeneratedClip made =
        system.generator->generate({target.id, target.position, seed, settings});
    MadeClip out;
    out.row.clip = std::move(file);
    out.row.system = std::string(system.generator->name());
    out.row.target_id = target.id;
    out.row.target = target.position;
    out.row.phases = made;
    out.row.fps = made.clip.framesPerSecond();
    out.row.seed = seed;
    out.row.processing = system.processing;
    out.text = assets::writeBvh(made.clip);
    return out;
}

}  // namespace

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
    // A portion after another, so that not all of the clips are in memory.
    constexpr std::size_t portion = 64, worth_a_thread = 4;
    for (std::size_t begin = 0; begin < targets.size(); begin += portion) {
        const std::size_t count = std::min(portion, targets.size() - begin);
        std::vector<MadeClip> made(count);
        forRanges(count, worth_a_thread, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const auto& target = targets[begin + i];
                made[i] = makeClip(system, target, deriveSeed(seed, target.id), settings, fileOf(target.id));
            }
        });
        for (MadeClip& one : made) {
            if (auto added = output.add(one.row.clip, one.text); !added) return tl::unexpected(added.error());
            rows.push_back(std::move(one.row));
        }
    }
    if (auto added = output.add("manifest.csv", assets::manifestCsv(rows)); !added)
        return tl::unexpected(added.error());
    if (auto finished = output.finish(); !finished) return tl::unexpected(finished.error());
    return rows;
}

}  // namespace deixis::app
