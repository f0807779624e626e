// A context, a small skinned figure made by hand, and ways to look at pictures.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "assets/avatar/avatar.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::tests {

constexpr int picture_width = 320;
constexpr int picture_height = 240;

/// An upright post of 1.6 m by the avatar's z axis, in two joints: "hips" holds its lower half, "spine",
/// 0.8 m up, its upper half. Red, so that it stands out from the room.
inline assets::Avatar postAvatar() {
    assets::Avatar avatar;
    avatar.skeleton.joints.push_back({"hips", -1, {}, {}});
    avatar.skeleton.joints.push_back({"spine", 0, {Vec3(0.0, 0.8, 0.0), no_rotation}, {}});
    avatar.humanoid[motion::Bone::hips] = 0;
    avatar.humanoid[motion::Bone::spine] = 1;
    avatar.joint_from_bind = {{}, {Vec3(0.0, -0.8, 0.0), no_rotation}};
    constexpr int sides = 16;
    constexpr int rows = 32;
    for (int row = 0; row <= rows; ++row)
        for (int side = 0; side < sides; ++side) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(side) / sides;
            const glm::vec3 normal(std::sin(angle), 0.0F, std::cos(angle));
            const float height = 1.6F * static_cast<float>(row) / rows;
            const bool upper = row > rows / 2;
            avatar.vertices.push_back({0.12F * normal + glm::vec3(0.0F, height, 0.0F),
                                       normal,
                                       {0.6F, 0.02F, 0.02F},
                                       {static_cast<std::uint16_t>(upper ? 1 : 0), 0, 0, 0},
                                       {1.0F, 0.0F, 0.0F, 0.0F}});
            if (row == rows) continue;
            const auto at = [&](int r, int s) { return static_cast<std::uint32_t>(r * sides + s % sides); };
            for (const std::uint32_t index : {at(row, side), at(row, side + 1), at(row + 1, side),
                                              at(row + 1, side), at(row, side + 1), at(row + 1, side + 1)})
                avatar.indices.push_back(index);
        }
    return avatar;
}

inline std::vector<Pose> postPose() {
    return {{}, {Vec3(0.0, 0.8, 0.0), no_rotation}};
}

inline renderer::Camera lookingFrom(const Vec3& from, const Vec3& to) {
    renderer::Camera camera;
    camera.stage_from_eye = {from, glm::quatLookAt(glm::normalize(to - from), up)};
    return camera;
}

/// A scene without the avatar, seen from 3 m before the origin.
inline renderer::Scene emptyScene() {
    renderer::Scene scene;
    scene.camera = lookingFrom({0.0, 1.5, 3.0}, {0.0, 1.2, 0.0});
    return scene;
}

struct Bytes {
    int r = 0, g = 0, b = 0;
    [[nodiscard]] int sum() const { return r + g + b; }
};

inline Bytes pixel(const renderer::Image& image, int x, int y) {
    const auto at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
        3U;
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// Where a point of the stage lies in a picture, pixels from the top left; computed from angles, without the
/// renderer's matrices.
inline std::pair<int, int> project(const renderer::Camera& camera, const Vec3& point, int width, int height) {
    const Vec3 seen = transformPoint(inverse(camera.stage_from_eye), point);
    const double pixels_per_slope = 0.5 * height / std::tan(0.5 * camera.vertical_fov_rad);
    return {static_cast<int>(0.5 * width + pixels_per_slope * seen.x / -seen.z),
            static_cast<int>(0.5 * height - pixels_per_slope * seen.y / -seen.z)};
}

inline Bytes pixelAt(const renderer::Image& image, const renderer::Camera& camera, const Vec3& point) {
    const auto [x, y] = project(camera, point, image.width, image.height);
    REQUIRE(x >= 0);
    REQUIRE(x < image.width);
    REQUIRE(y >= 0);
    REQUIRE(y < image.height);
    return pixel(image, x, y);
}

/// One context and renderer for a test case.
struct Gl {
    explicit Gl(int samples = 1, const assets::Avatar& avatar = postAvatar()) {
        auto made = renderer::OffscreenContext::create();
        REQUIRE_MESSAGE(made.has_value(), (made ? std::string() : made.error().text()));
        context.emplace(std::move(*made));
        renderer::Quality quality;
        quality.samples = samples;
        quality.shadow_resolution = 512;
        auto drawing = renderer::Renderer::create(avatar, quality);
        REQUIRE_MESSAGE(drawing.has_value(), (drawing ? std::string() : drawing.error().text()));
        renderer.emplace(std::move(*drawing));
    }
    std::optional<renderer::OffscreenContext> context;
    std::optional<renderer::Renderer> renderer;
};

}  // namespace deixis::tests
