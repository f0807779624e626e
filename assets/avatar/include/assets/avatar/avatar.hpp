// An avatar as CPU data: any humanoid glTF 2.0 or VRM figure, converted to one form.
//
// Whatever the file's rest pose, bone axes, scales and facing are, the resulting skeleton is in the T pose
// in metres, y up, facing +z, its lowest vertex on the floor, and its joints have no rest rotations.
// Joints that are a bone have that bone's VRM name. How the skin is transferred: docs/avatar.md.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::assets {

struct SkinnedVertex {
    glm::vec3 position{0.0F};  ///< bind pose, metres
    glm::vec3 normal{0.0F};
    glm::vec3 colour{1.0F};                 ///< linear; the material's base colour factor is in it
    std::array<std::uint16_t, 4> joints{};  ///< indices into the skeleton
    std::array<float, 4> weights{};         ///< sum 1
    glm::vec2 uv{0.0F};                     ///< (0, 0) is the upper left corner of the texture
};

enum class TextureWrap : unsigned char { repeat, clamp, mirror };

/// A base colour texture, sRGB, rows from the top, 4 bytes a pixel.
struct AvatarTexture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    bool nearest = false;  ///< texels stay square, for palettes and pixel art
};

/// Triangles that are drawn in the same way.
struct AvatarPart {
    std::uint32_t first_index = 0, index_count = 0;  ///< of Avatar::indices
    int texture = -1;                                ///< of Avatar::textures; -1: vertex colours alone
    float alpha_cutoff = 0.0F;                       ///< texels of less alpha are holes; 0: none are
    bool double_sided = false;
};

/// As many joints as can be drawn.
constexpr std::size_t max_avatar_joints = 340;

struct Avatar {
    motion::Skeleton skeleton;
    motion::HumanoidMap humanoid;
    std::vector<SkinnedVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< triangles
    std::vector<AvatarPart> parts{};     ///< in the order of their indices; none: all triangles, plain
    std::vector<AvatarTexture> textures{};
    /// joint_from_bind of each skeleton joint (the inverse bind matrix as a rigid transform).
    std::vector<Pose> joint_from_bind;
    double height_m = 0.0;  ///< of the mesh in the T pose
    /// SHA-256 of the file; of more where the figure hangs on more: files that it names, NAME.humanoid.toml,
    /// the height asked for.
    std::string content_hash;
    std::vector<std::filesystem::path>
        files{};                         ///< the file, then those that it names; none: read from bytes
    std::vector<std::string> remarks{};  ///< for people: what was adapted or left out
};

struct AvatarOptions {
    /// Of the mesh in the T pose, to which the figure is scaled; none: as NAME.humanoid.toml says, else as
    /// the file has it.
    std::optional<double> height_m{};
};

/// As tall as people are: an avatar that is not, and of which nobody says how tall it is to be, is rejected.
constexpr double shortest_avatar_m = 1.2, tallest_avatar_m = 2.2;

/// Reads .glb, .vrm (0.x and 1.0) and .gltf with the files beside it, its bones as NAME.humanoid.toml says
/// where that is there (assets/humanoid_file.hpp). Fails, naming the file, where it is not readable, where it
/// is not a humanoid (naming the bones that lack: hips, head, both arms to the hand, both legs to the foot),
/// where it needs an extension that is not known here, where a file that it names lies outside its folder,
/// and where it is not as tall as people are.
[[nodiscard]] Result<Avatar> loadAvatar(const std::filesystem::path& path, const AvatarOptions& options = {});
/// The same from bytes, without other files; `name` stands for the file in errors.
[[nodiscard]] Result<Avatar> readAvatar(std::string_view bytes, const std::string& name,
                                        const AvatarOptions& options = {});

}  // namespace deixis::assets
