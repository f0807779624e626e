// The meshes of a figure, bound to the joints of its rig; private to reading avatars.
#pragma once

#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "assets/gltf/gltf_values.hpp"
#include "rig.hpp"

namespace deixis::assets {

/// How the vertices of one binding follow a joint. `rest_from_bind` takes a vertex to where the joint holds
/// it in the file's rest pose, in the avatar's axes and the file's unit.
struct BindSlot {
    int joint = -1;
    Pose rest_from_bind{};
};

struct FigureMesh {
    std::vector<SkinnedVertex> vertices;  ///< joints are indices of slots
    std::vector<BindSlot> slots;
    std::vector<AvatarPart> parts;
    std::vector<std::vector<std::uint32_t>> indices;  ///< of each part
    std::vector<AvatarTexture> textures;
};

/// All that the scene shows of meshes. What follows no joint is left out, with a remark.
[[nodiscard]] FigureMesh readFigureMesh(const gltf::Document& document, const gltf::Values& values,
                                        const NodeTree& tree, const Rig& rig,
                                        std::vector<std::string>& remarks);

}  // namespace deixis::assets
