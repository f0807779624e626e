// VRM's extensions: VRM 0.x (extensions.VRM), VRM 1.0 (VRMC_vrm) and VRM animations (VRMC_vrm_animation-1.0).
#include <fmt/format.h>

#include <algorithm>

#include "assets/gltf/vrm_bones.hpp"
#include "gltf_document.hpp"

namespace deixis::assets::gltf {

namespace {

class HumanoidReader {
  public:
    HumanoidReader(std::size_t node_count, std::vector<std::string>& remarks)
        : node_count_(node_count), remarks_(remarks) {}

    Humanoid readVrm0(const Cursor& extension) {
        found_.source = "VRM 0.x";
        found_.faces_minus_z = true;
        if (!extension.has("humanoid") || !extension.at("humanoid").has("humanBones")) return found_;
        const Cursor bones = extension.at("humanoid").at("humanBones");
        for (std::size_t i = 0; i < bones.size(); ++i) {
            const Cursor bone = bones.at(i);
            add(boneOfVrm0(bone.at("bone").text()), bone.at("node"));
        }
        return found_;
    }

    Humanoid readVrm1(const Cursor& extension, const char* source) {
        found_.source = source;
        if (!extension.has("humanoid") || !extension.at("humanoid").has("humanBones")) return found_;
        const Cursor bones = extension.at("humanoid").at("humanBones");
        if (!bones.json().is_object()) bones.expected("an object");
        for (const auto& [name, value] : bones.json().items())
            add(motion::boneFromName(name), bones.at(name.c_str()).at("node"));
        return found_;
    }

    Humanoid readAnimation(const Cursor& extension) {
        readVrm1(extension, "VRMC_vrm_animation");
        if (extension.has("expressions"))
            for (const char* kind : {"preset", "custom"}) {
                if (!extension.at("expressions").has(kind)) continue;
                const Cursor group = extension.at("expressions").at(kind);
                if (!group.json().is_object()) group.expected("an object");
                for (const auto& [name, value] : group.json().items())
                    addOther(group.at(name.c_str()).at("node"));
            }
        if (extension.has("lookAt")) addOther(extension.at("lookAt").at("node"));
        return found_;
    }

  private:
    void add(const std::optional<motion::Bone>& bone, const Cursor& node) {
        if (node.json() == vrm_absent_node) return;
        const int index = node.index(node_count_, "node");
        if (!bone) {
            remarks_.push_back(fmt::format("{} is no humanoid bone's name; it is passed over", node.path()));
            return;
        }
        const auto taken = std::find_if(found_.nodes.begin(), found_.nodes.end(), [&](const auto& other) {
            return other.first == *bone || other.second == index;
        });
        if (taken == found_.nodes.end())
            found_.nodes.emplace_back(*bone, index);
        else
            remarks_.push_back(fmt::format(
                "{} names a bone or a node that is taken already; it is passed over", node.path()));
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
    if (extensions.has("VRMC_vrm_animation"))
        return reader.readAnimation(extensions.at("VRMC_vrm_animation"));
    if (extensions.has("VRMC_vrm")) return reader.readVrm1(extensions.at("VRMC_vrm"), "VRMC_vrm");
    if (extensions.has("VRM")) return reader.readVrm0(extensions.at("VRM"));
    return std::nullopt;
}

}  // namespace deixis::assets::gltf
