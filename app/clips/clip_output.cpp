#include "app/clips/clip_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "app/program/written_output.hpp"
#include "assets/gltf/gltf_clip.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/joints/joint_positions.hpp"
#include "core/files.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

bool isManifest(const fs::path& name) {
    return name.extension() == ".csv";
}

/// With a number where the name is taken; adds it to those.
fs::path bvhBelow(const std::string& clip, std::set<fs::path>& taken) {
    fs::path name = fs::path(clip).lexically_normal();
    if (name.is_absolute() || name.begin()->string() == "..") name = name.filename();
    if (name.extension() == ".gz") name.replace_extension();
    const fs::path stem = fs::path(name).replace_extension();
    fs::path unique = stem.string() + ".bvh";
    for (int number = 2; !taken.insert(unique).second; ++number)
        unique = fmt::format("{}-{}.bvh", stem.string(), number);
    return unique;
}

}  // namespace

bool isClipFile(const fs::path& file) {
    return file.extension() == ".csv" || file.extension() == ".glb" || file.extension() == ".bvh";
}

Result<std::string> clipBytes(const motion::Clip& clip, const fs::path& file) {
    if (file.extension() == ".csv") return assets::writeJointCsv(clip);
    if (file.extension() == ".glb") return assets::writeGlb(clip);
    if (file.extension() != ".bvh")
        return fail(file.string(), fmt::format("found the ending '{}', expected .bvh, .glb or .csv",
                                               file.extension().string()));
    const auto& joints = clip.skeleton.joints;
    if (std::count_if(joints.begin(), joints.end(), [](const auto& joint) { return joint.parent < 0; }) != 1)
        return fail(file.string(), "BVH holds one root joint, and this skeleton has more");
    return assets::writeBvh(clip);
}

Result<void> writeClip(const motion::Clip& clip, const fs::path& file) {
    const auto bytes = clipBytes(clip, file);
    if (!bytes) return tl::unexpected(bytes.error());
    return writeFile(file, *bytes);
}

std::string clipStem(const fs::path& file) {
    const fs::path name = file.extension() == ".gz" ? file.stem() : file.filename();
    return name.stem().string();
}

OutputFolder::OutputFolder(fs::path folder, bool force, bool durable)
    : folder_(std::move(folder)), force_(force), durable_(durable) {}

Result<void> OutputFolder::expect(const std::vector<fs::path>& names) const {
    for (const fs::path& name : names)
        if (auto free = checkFree((folder_ / name).string(), force_); !free) return free;
    return {};
}

Result<std::vector<fs::path>> OutputFolder::expectClipsOf(const assets::Manifest& manifest) const {
    std::error_code code;
    if (fs::equivalent(fs::absolute(manifest.file).parent_path(), folder_, code))
        return fail(folder_.string(), "is the folder of the clips themselves, expected another one");
    std::set<fs::path> taken;
    std::vector<fs::path> names;
    for (const assets::ManifestRow& row : manifest.rows) names.push_back(bvhBelow(row.clip, taken));
    names.emplace_back("manifest.csv");
    if (auto free = expect(names); !free) return tl::unexpected(free.error());
    names.pop_back();
    return names;
}

Result<void> OutputFolder::add(const fs::path& name, std::string_view bytes) {
    if (auto free = expect({name}); !free) return free;
    if (!names_.insert(name).second)
        return fail((folder_ / name).string(), "two clips would have this name",
                    "Give the clips names of their own");
    if (!staging_) {
        auto made = Staging::within(folder_);
        if (!made) return tl::unexpected(made.error());
        staging_.emplace(std::move(*made));
    }
    return staging_->add(name, bytes);
}

Result<void> OutputFolder::finish() {
    if (!staging_) return {};
    std::vector<fs::path> order(names_.begin(), names_.end());
    const auto manifests = std::stable_partition(order.begin(), order.end(),
                                                 [](const fs::path& name) { return !isManifest(name); });
    // No manifest speaks of clips that are being replaced.
    return staging_->moveHome(order, {manifests, order.end()}, durable_);
}

}  // namespace deixis::app
