#include "assets/gltf/gltf_clip.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/files.hpp"
#include "gltf_container.hpp"
#include "gltf_skeleton.hpp"

namespace deixis::assets {

namespace {

using gltf::reject;

constexpr std::size_t max_poses = 20'000'000;  // of single joints: about 1 GB
constexpr std::size_t max_frames_always = 20'000;
constexpr std::size_t max_frames_per_key = 100;

class Importer {
  public:
    Importer(const gltf::Document& document, const GltfClipOptions& options,
             const std::optional<std::filesystem::path>& folder)
        : doc_(document), options_(options), values_(document, folder) {
        out_.remarks = document.remarks;
    }

    GltfClipFile run() {
        checkOptions();
        const int animation = chooseAnimation();
        std::vector<gltf::Track> tracks;
        if (animation >= 0) {
            const auto left_out = doc_.humanoid ? doc_.humanoid->other_nodes : std::vector<int>{};
            tracks = gltf::readTracks(doc_, animation, left_out, values_, out_.remarks);
            tellOthers(doc_.animations[static_cast<std::size_t>(animation)], left_out);
        }
        const gltf::FrameGrid grid = chooseGrid(tracks);
        const gltf::JointNodes joints = gltf::chooseJoints(doc_, tracks, out_.remarks);
        if (grid.frames * joints.nodes.size() > max_poses)
            reject(doc_.file,
                   fmt::format("{} frames of {} joints are too many", grid.frames, joints.nodes.size()),
                   "Export a shorter animation, or use fewer frames per second");
        const gltf::Poser poser(doc_, joints, tracks, out_.metres_per_unit, facing());
        out_.clip.skeleton = poser.skeleton();
        out_.clip.frame_time_s = grid.frame_time_s;
        out_.clip.frames.reserve(grid.frames);
        for (std::size_t k = 0; k < grid.frames; ++k)
            out_.clip.frames.push_back(
                poser.at(grid.start_s + static_cast<double>(k) * grid.frame_time_s, grid.snap_s));
        if (auto remark = poser.scaleRemark(); !remark.empty()) out_.remarks.push_back(std::move(remark));
        fillHumanoid(joints);
        checkSize();
        return std::move(out_);
    }

  private:
    void checkOptions() {
        if (options_.fps && !(*options_.fps > 0.0 && *options_.fps <= 1000.0))
            reject("fps", fmt::format("found {}, expected more than 0 and at most 1000", *options_.fps), "");
        const double metres = options_.metres_per_unit.value_or(1.0);
        if (!(metres > 0.0 && metres < 1e6))
            reject("metres per unit", fmt::format("found {}, expected more than 0", metres), "");
        out_.metres_per_unit = metres;
        out_.unit = options_.metres_per_unit ? "as given" : "metre (as in glTF)";
    }

    /// -1 where the file has none.
    int chooseAnimation() {
        for (std::size_t i = 0; i < doc_.animations.size(); ++i)
            out_.animations.push_back(doc_.animations[i].name.empty() ? fmt::format("animation {}", i)
                                                                      : doc_.animations[i].name);
        const auto& names = out_.animations;
        const auto listed = [&] {
            return names.empty() ? std::string("no animation") : fmt::format("{}", fmt::join(names, ", "));
        };
        std::size_t chosen = 0;
        if (!options_.animation.empty()) {
            const auto found = std::find(names.begin(), names.end(), options_.animation);
            if (found == names.end())
                reject(doc_.file, fmt::format("has no animation \"{}\"", options_.animation),
                       fmt::format("It has: {}", listed()));
            chosen = static_cast<std::size_t>(found - names.begin());
        } else {
            if (options_.animation_index < 0 ||
                (options_.animation_index > 0 &&
                 static_cast<std::size_t>(options_.animation_index) >= names.size()))
                reject(doc_.file,
                       fmt::format("has no animation {} (counted from 0)", options_.animation_index),
                       fmt::format("It has: {}", listed()));
            chosen = static_cast<std::size_t>(options_.animation_index);
            if (options_.animation_index == 0 && names.size() > 1)
                out_.remarks.push_back(
                    fmt::format("it has {} animations; the first is used: {}", names.size(), listed()));
        }
        if (names.empty()) {
            out_.remarks.emplace_back("it has no animation: the clip is its rest pose, one frame");
            return -1;
        }
        out_.animation = names[chosen];
        return static_cast<int>(chosen);
    }

    void tellOthers(const gltf::Animation& animation, const std::vector<int>& left_out) {
        if (animation.has_others)
            out_.remarks.emplace_back(
                "what the animation moves besides nodes (such as morph weights) is left out");
        if (!left_out.empty())
            out_.remarks.emplace_back("expressions and gaze of the VRM animation are left out");
        if (animation.channels.empty())
            out_.remarks.emplace_back("the animation moves no node: the clip is the rest pose, one frame");
    }

    gltf::FrameGrid chooseGrid(const std::vector<gltf::Track>& tracks) {
        gltf::FrameGrid grid = gltf::frameGrid(tracks, options_.fps.value_or(0.0));
        out_.frame_rate = grid.words;
        std::size_t keys = 0;
        for (const auto& track : tracks) keys = std::max(keys, track.times->size());
        if (grid.frames > max_frames_always + max_frames_per_key * keys)
            reject(doc_.file,
                   fmt::format("its keys, at most {} per node, stretch over {} frames", keys, grid.frames),
                   "Give a lower number of frames per second");
        if (grid.uneven)
            out_.remarks.push_back(
                fmt::format("keys are at uneven times: resampled at {:.7g} fps", 1.0 / grid.frame_time_s));
        if (grid.start_s > 1e-6)
            out_.remarks.push_back(
                fmt::format("its first key is at {:.4g} s: the clip begins there", grid.start_s));
        return grid;
    }

    /// VRM 0.x models face -z.
    Quat facing() {
        if (!doc_.humanoid || !doc_.humanoid->faces_minus_z) return no_rotation;
        out_.remarks.emplace_back("a VRM 0.x model faces -z: it is turned to face +z");
        return {0.0, 0.0, 1.0, 0.0};
    }

    void fillHumanoid(const gltf::JointNodes& joints) {
        if (!doc_.humanoid) return;
        motion::HumanoidMap map;
        for (const auto& [bone, node] : doc_.humanoid->nodes) map[bone] = joints.jointOf(node);
        out_.humanoid = map;
        out_.humanoid_source = doc_.humanoid->source;
    }

    /// Tells a figure that no person's size would fit by far: its unit may not be the metre.
    void checkSize() {
        if (options_.metres_per_unit) return;
        const auto world = motion::worldPose(out_.clip.skeleton, out_.clip.frames.front());
        Vec3 min = world.front().position;
        Vec3 max = min;
        for (const Pose& joint : world) {
            min = glm::min(min, joint.position);
            max = glm::max(max, joint.position);
        }
        const Vec3 size = max - min;
        const double longest = std::max({size.x, size.y, size.z});
        if (longest > 10.0 || (longest > 0.0 && longest < 0.1))
            out_.remarks.push_back(fmt::format(
                "the figure measures {:.3g} m; if its unit is not the metre, give metres per unit", longest));
    }

    const gltf::Document& doc_;
    const GltfClipOptions& options_;
    gltf::Values values_;
    GltfClipFile out_;
};

}  // namespace

Result<GltfClipFile> parseGltfClip(std::string_view bytes, const std::string& name,
                                   const GltfClipOptions& options,
                                   const std::optional<std::filesystem::path>& folder) {
    try {
        const gltf::Document document = gltf::readDocument(bytes, name, gltf::Content::clip);
        return Importer(document, options, folder).run();
    } catch (const gltf::Rejection& rejection) {
        return tl::unexpected(rejection.error);
    }
}

Result<GltfClipFile> readGltfClip(const std::filesystem::path& path, const GltfClipOptions& options) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return parseGltfClip(*bytes, path.string(), options, path.parent_path());
}

std::vector<std::filesystem::path> gltfBufferFiles(std::string_view bytes,
                                                   const std::filesystem::path& path) {
    std::vector<std::filesystem::path> files;
    try {
        for (const auto& buffer : gltf::readDocument(bytes, path.string(), gltf::Content::clip).buffers) {
            auto file = path.parent_path() / buffer.outside.file;
            if (!buffer.outside.file.empty() && std::find(files.begin(), files.end(), file) == files.end())
                files.push_back(std::move(file));
        }
    } catch (const gltf::Rejection&) {
        return {};  // whoever reads the clip tells why
    }
    return files;
}

}  // namespace deixis::assets
