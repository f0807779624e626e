#include "avatar_humanoid.hpp"

#include <fmt/format.h>

#include <string_view>

#include "assets/gltf/vrm_bones.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::assets {

namespace {

using motion::Bone;
using enum motion::Bone;

class VrmMap {
  public:
    VrmMap(const tinygltf::Model& model, const std::string& file) : model_(model), file_(file) {
        nodes_.fill(-1);
    }

    Result<void> add(std::string_view name, std::optional<Bone> bone, const tinygltf::Value& node) {
        if (!bone) return {};  // a bone of a later version
        const int index = node.IsInt() ? node.GetNumberAsInt() : -2;
        if (index == vrm_absent_node) return {};
        if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
            return fail(file_, fmt::format("VRM's bone {} is no node of the file", name),
                        "Export the file anew");
        nodes_[static_cast<std::size_t>(*bone)] = index;
        return {};
    }
    [[nodiscard]] const BoneNodes& nodes() const { return nodes_; }

  private:
    const tinygltf::Model& model_;
    const std::string& file_;
    BoneNodes nodes_{};
};

const tinygltf::Value* humanBones(const tinygltf::Model& model, const char* extension) {
    const auto found = model.extensions.find(extension);
    if (found == model.extensions.end() || !found->second.IsObject()) return nullptr;
    const tinygltf::Value& humanoid = found->second.Get("humanoid");
    if (!humanoid.IsObject()) return nullptr;
    return &humanoid.Get("humanBones");
}

}  // namespace

Result<std::optional<BoneNodes>> vrmHumanoid(const tinygltf::Model& model, const std::string& file) {
    if (const auto* bones = humanBones(model, "VRMC_vrm"); bones != nullptr && bones->IsObject()) {
        VrmMap map(model, file);
        for (const std::string& name : bones->Keys()) {
            const tinygltf::Value& bone = bones->Get(name);
            if (!bone.IsObject()) continue;
            if (auto added = map.add(name, motion::boneFromName(name), bone.Get("node")); !added)
                return tl::unexpected(added.error());
        }
        return map.nodes();
    }
    if (const auto* bones = humanBones(model, "VRM"); bones != nullptr && bones->IsArray()) {
        VrmMap map(model, file);
        for (int i = 0; i < static_cast<int>(bones->ArrayLen()); ++i) {
            const tinygltf::Value& bone = bones->Get(i);
            if (!bone.IsObject() || !bone.Get("bone").IsString()) continue;
            const auto& name = bone.Get("bone").Get<std::string>();
            if (auto added = map.add(name, boneOfVrm0(name), bone.Get("node")); !added)
                return tl::unexpected(added.error());
        }
        return map.nodes();
    }
    return std::nullopt;
}

motion::HumanoidMap humanoidByNames(const motion::Skeleton& skeleton) {
    const motion::HumanoidMap exact = motion::mapByVrmNames(skeleton);
    return motion::missingBones(exact).empty() ? exact : motion::detectHumanoid(skeleton);
}

}  // namespace deixis::assets
