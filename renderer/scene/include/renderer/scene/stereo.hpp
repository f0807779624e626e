// What a headset's two eyes need besides a scene: views, and the textures to draw into.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "core/pose.hpp"

namespace deixis::renderer {

/// Angles from the view axis, radians; left and down are negative (as XrFovf).
struct EyeFov {
    double left_rad = 0.0, right_rad = 0.0, up_rad = 0.0, down_rad = 0.0;
};

struct Eye {
    Pose stage_from_eye{};  ///< -z looks forward, +y up
    EyeFov fov{};
};

/// Left, then right.
using Eyes = std::array<Eye, 2>;

/// GL names of 2D textures of one size, left and right: one for each eye, since not every runtime lends
/// layers.
struct StereoTarget {
    std::array<unsigned int, 2> colour{};  ///< sRGB8_ALPHA8
    std::array<unsigned int, 2> depth{};   ///< DEPTH_COMPONENT32F; 0: depth is not wanted
    int width = 0;
    int height = 0;
};

/// The part of an eye's picture that its lens never shows, as triangles in tangents of the view's angles (x
/// to the right, y up: the plane one metre before the eye). Empty: all is seen.
struct HiddenArea {
    std::vector<glm::vec2> corners;
    std::vector<unsigned int> indices;
};

/// How the two eyes are drawn.
enum class StereoMode : unsigned char {
    multiview,  ///< in one pass (GL_OVR_multiview2)
    two_passes,
};

}  // namespace deixis::renderer
