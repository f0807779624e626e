// Any bytes as an avatar: a figure that can be drawn and posed, or an error.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "assets/avatar/avatar.hpp"

using namespace deixis;

namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check(const assets::Avatar& avatar) {
    const std::size_t joints = avatar.skeleton.joints.size();
    require(joints > 0 && joints <= assets::max_avatar_joints, "joints that can be drawn");
    require(avatar.joint_from_bind.size() == joints, "a bind pose for each joint");
    for (std::size_t j = 0; j < joints; ++j) {
        require(avatar.skeleton.joints[j].parent < static_cast<int>(j), "parents first");
        require(finite(glm::vec3(avatar.skeleton.joints[j].rest.position)), "finite joints");
        require(finite(glm::vec3(avatar.joint_from_bind[j].position)), "finite bind poses");
    }
    for (const int joint : avatar.humanoid.joint)
        require(joint >= -1 && joint < static_cast<int>(joints), "bones that are joints");
    require(std::abs(avatar.height_m - 1.7) < 1e-2, "the height that was asked for");
    for (const assets::SkinnedVertex& v : avatar.vertices) {
        require(finite(v.position) && finite(v.normal), "finite vertices");
        require(finite(v.colour) && std::isfinite(v.uv.x) && std::isfinite(v.uv.y), "finite colours and uvs");
        float sum = 0.0F;
        for (std::size_t i = 0; i < 4; ++i) {
            require(v.joints[i] < joints, "vertices that follow joints");
            sum += v.weights[i];
        }
        require(std::abs(sum - 1.0F) < 1e-3F, "weights that sum to 1");
    }
    for (const std::uint32_t index : avatar.indices)
        require(index < avatar.vertices.size(), "indices of vertices");
    for (const assets::AvatarPart& part : avatar.parts) {
        require(part.texture < static_cast<int>(avatar.textures.size()), "textures that are there");
        require(std::size_t{part.first_index} + part.index_count <= avatar.indices.size(),
                "parts of indices");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto avatar = assets::readAvatar(bytes, "fuzz.glb", {1.7});
    if (avatar)
        check(*avatar);
    else
        require(!avatar.error().text().empty(), "an error with words");
    return 0;
}
