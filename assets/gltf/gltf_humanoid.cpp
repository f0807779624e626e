// VRM's extensions: VRM 0.x (extensions.VRM), VRM 1.0 (VRMC_vrm) and VRM animations (VRMC_vrm_animation-1.0).
#include <fmt/format.h>

#include <algorithm>

#include "gltf_reading.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr int absent_node = -1;  // some exporters list the bones that a figure lacks, with this node

/// VRM 0.x calls the thumb's bones proximal, intermediate and distal (VRM 1.0: metacarpal, proximal, distal).
std::optional<motion::Bone> boneOfVrm0(std::string_view name) {
    using enum motion::Bone;
    if (name == "leftThumbProximal") return leftThumbMetacarpal;
    if (name == "leftThumbIntermediate") return leftThumbProximal;
    if (name == "rightThumbProximal") return rightThumbMetacarpal;
    if (name == "rightThumbIntermediate") return rightThumbProximal;
    return motion::boneFromName(name);
}

class HumanoidReader {
  public:
    HumanoidReader(std::size_t node_count, std::vector<std::string>& remarks)
        : node_count_(node_count), remarks_(remarks) {}

    Humanoid readVrm0(const Cursor& extension) {
        found_.source = "VRM 0.x";
        found_.faces_minus_z = true;
        if (!extension.has("humanoid") || !extension.at("humanoid").has("humanBones")) return found_;
        for (const Cursor& bone : extension.at("humanoid").elements("humanBones"))
            add(boneOfVrm0(bone.at("bone").text()), bone.at("node"));
        return found_;
    }

    Humanoid readVrm1(const Cursor& extension, const char* source) {
        found_.source = source;
        if (!extension.has("humanoid") || !extension.at("humanoid").has("humanBones")) return found_;
        const Cursor bones = extension.at("humanoid").at("humanBones");
        for (const std::string& name : bones.keys())
            add(motion::boneFromName(name), bones.at(name.c_str()).at("node"));
        return found_;
    }

    Humanoid readAnimation(const Cursor& extension) {
        readVrm1(extension, "VRMC_vrm_animation");
        if (extension.has("expressions"))
            for (const char* kind : {"preset", "custom"}) {
                if (!extension.at("expressions").has(kind)) continue;
                const Cursor group = extension.at("expressions").at(kind);
                for (const std::string& name : group.keys()) addOther(group.at(name.c_str()).at("node"));
            }
        if (extension.has("lookAt")) addOther(extension.at("lookAt").at("node"));
        return found_;
    }

  private:
    void add(const std::optional<motion::Bone>& bone, const Cursor& node) {
        if (node.json() == absent_node) return;
        const int index = node.index(node_count_, "node");
        if (!bone) {
            remarks_.push_back(
                fmt::format("{} is not the name of a humanoid bone; it is ignored", node.path()));
            return;
        }
        const auto taken = std::find_if(found_.nodes.begin(), found_.nodes.end(), [&](const auto& other) {
            return other.first == *bone || other.second == index;
        });
        if (taken == found_.nodes.end())
            found_.nodes.emplace_back(*bone, index);
        else
            remarks_.push_back(
                fmt::format("{} names a bone or node that is already taken; it is ignored", node.path()));
    }

    void addOther(const Cursor& node) { found_.other_nodes.push_back(node.index(node_count_, "node")); }

    std::size_t node_count_;
    std::vector<std::string>& remarks_;
    Humanoid found_;
};

}  // namespace

std::optional<Humanoid> readHumanoid(const Cursor& root, std::size_t node_count,
                                     std::vector<std::string>& remarks) {
    if (!root.has("extensions")) return std::nullopt;
    const Cursor extensions = root.at("extensions");
    HumanoidReader reader(node_count, remarks);
    std::optional<Humanoid> found;
    if (extensions.has("VRMC_vrm_animation"))
        found = reader.readAnimation(extensions.at("VRMC_vrm_animation"));
    else if (extensions.has("VRMC_vrm"))
        found = reader.readVrm1(extensions.at("VRMC_vrm"), "VRMC_vrm");
    else if (extensions.has("VRM"))
        found = reader.readVrm0(extensions.at("VRM"));
    if (found) std::sort(found->nodes.begin(), found->nodes.end());
    return found;
}

}  // namespace deixis::assets::gltf
