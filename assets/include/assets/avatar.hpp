// An avatar as CPU data: skeleton, humanoid map and skinned mesh, read from a glTF 2.0 binary.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton.hpp"

namespace deixis::assets {

struct SkinnedVertex {
    glm::vec3 position{0.0F};  ///< bind pose, metres
    glm::vec3 normal{0.0F};
    glm::vec3 colour{1.0F};                 ///< linear
    std::array<std::uint16_t, 4> joints{};  ///< indices into the skeleton
    std::array<float, 4> weights{};         ///< sum 1
};

struct Avatar {
    motion::Skeleton skeleton;
    motion::HumanoidMap humanoid;
    std::vector<SkinnedVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< triangles
    /// joint_from_bind of each skeleton joint (the inverse bind matrix as a rigid transform).
    std::vector<Pose> joint_from_bind;
    std::string content_hash;  ///< SHA-256 of the file
};

[[nodiscard]] Result<Avatar> loadAvatar(const std::filesystem::path& path);

}  // namespace deixis::assets
