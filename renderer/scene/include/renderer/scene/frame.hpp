// What every pass needs for one frame: the uniform blocks, and the shader text that reads them and lights
// surfaces.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string_view>

#include "core/pose.hpp"
#include "core/room.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

constexpr int max_shadow_balls = 64;  ///< balls beyond these are drawn, but cast no shadow
constexpr std::size_t foot_count = 2 * max_avatars;

/// Laid out as std140 has it; bound at uniform block 0.
struct FrameBlock {
    /// By avatar: to texture coordinates and depth, 0..1.
    std::array<glm::mat4, max_avatars> shadow_from_stage{glm::mat4(1.0F), glm::mat4(1.0F)};
    glm::vec4 to_light{0.0F};  ///< w: number of balls that cast a shadow
    glm::vec4 shadow{0.0F};    ///< x: texture units a metre; y: depth range, m; z: number of avatars
    /// By avatar: its extent in texture coordinates, low u v, high u v.
    std::array<glm::vec4, max_avatars> shadow_box{};
    std::array<glm::vec4, foot_count * 2> feet{};     ///< heel and toe of each foot; w: radius, 0 for none
    std::array<glm::vec4, max_shadow_balls> balls{};  ///< centre, radius
    std::array<ViewBlock, 2> views{};                 ///< of this buffer, bound at view_block_binding
};

constexpr unsigned int frame_block_binding = 0;
constexpr unsigned int shadow_texture_unit = 0;

/// The direction to the key light: 10 degrees off the vertical, so that a ball's shadow falls below it.
[[nodiscard]] Vec3 directionToLight();

[[nodiscard]] glm::mat4 matrixFromPose(const Pose& pose);

/// GLSL: the block.
extern const std::string_view frame_glsl;
/// GLSL, after frame_glsl: ballLight() and avatarLight(), what shadows leave of the key light. `noise` (0..1)
/// turns the places where the shadow map is read.
extern const std::string_view shadow_glsl;
/// GLSL for fragment shaders, after frame_glsl: lit(), pixelNoise(), and finish(), which gives the colour to
/// write.
extern const std::string_view lighting_glsl;

}  // namespace deixis::renderer
