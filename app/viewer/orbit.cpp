#include "orbit.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>
#include <vector>

#include "app/window/picture_point.hpp"
#include "app/window/pressed_keys.hpp"
#include "core/room.hpp"
#include "frames.hpp"
#include "motion/skeleton/kinematics.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::app {

namespace {

struct NamedView {
    const char* name;
    double azimuth_deg;
};
constexpr double vertical_fov_rad = radiansFromDegrees(42.0);
constexpr std::array<NamedView, 5> named_views{
    {{"front", 0.0}, {"left", 90.0}, {"right", -90.0}, {"back", 180.0}, {"three-quarter", 35.0}}};

// Who walks farther than this goes on on the spot: the room is small.
void keepInRoom(std::vector<Pose>& joints, std::size_t hips) {
    constexpr double farthest_m = 1.0;
    const Vec3 away(joints[hips].position.x, 0.0, joints[hips].position.z);
    const double distance_m = glm::length(away);
    if (distance_m <= farthest_m) return;
    for (Pose& joint : joints) joint.position -= away * (1.0 - farthest_m / distance_m);
}

/// How far from a place in the room one can go before a wall, the floor or the ceiling is near.
double withinRoom_m(const Vec3& from, const Vec3& direction) {
    constexpr double margin_m = 0.15;
    double out = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double wall = direction[axis] > 0.0 ? room_high[axis] - margin_m : room_low[axis] + margin_m;
        if (direction[axis] != 0.0) out = std::min(out, (wall - from[axis]) / direction[axis]);
    }
    return std::max(0.0, out);
}

}  // namespace

Pose Orbit::stageFromEye(const Vec3& hips, double height_m) const {
    const double size = std::max(1.0, height_m / 1.9);
    const Vec3 middle(hips.x, 0.83 * size, hips.z);
    const Quat turn = yawRotation(azimuth_rad) * glm::angleAxis(-elevation_rad, Vec3(1, 0, 0));
    const Vec3 back = turn * Vec3(0, 0, 1);
    return {middle + std::min(distance_m * size, withinRoom_m(middle, back)) * back, turn};
}

void Orbit::follow(const ImGuiIO& io, bool dragging) {
    if (dragging) {
        azimuth_rad -= 0.006 * static_cast<double>(io.MouseDelta.x);
        elevation_rad = std::clamp(elevation_rad + 0.006 * static_cast<double>(io.MouseDelta.y),
                                   radiansFromDegrees(-5.0), radiansFromDegrees(85.0));
    }
    distance_m = std::clamp(distance_m * std::pow(0.9, static_cast<double>(io.MouseWheel)), 0.4, 7.0);
}

Result<Orbit> orbitFrom(const std::string& name) {
    for (const NamedView& view : named_views)
        if (name == view.name || (name.empty() && view.name == std::string_view("three-quarter"))) {
            Orbit orbit;
            orbit.azimuth_rad = radiansFromDegrees(view.azimuth_deg);
            return orbit;
        }
    return fail("--from",
                fmt::format("unknown view '{}'; expected front, left, right, back or three-quarter", name));
}

renderer::Scene sceneAround(const assets::Avatar& avatar, const motion::LocalPose& pose, const Orbit& orbit) {
    renderer::Scene scene;
    std::vector<Pose>& joints = scene.avatars.emplace_back();
    motion::worldPose(avatar.skeleton, pose, joints);
    const auto hips = static_cast<std::size_t>(std::max(0, avatar.humanoid[motion::Bone::hips]));
    keepInRoom(joints, hips);
    scene.camera.stage_from_eye = orbit.stageFromEye(joints[hips].position, avatar.height_m);
    scene.camera.vertical_fov_rad = vertical_fov_rad;
    return scene;
}

Orbit orbitShowing(const Orbit& orbit, const assets::Avatar& avatar, const Vec3& place_m, double aspect) {
    constexpr double within = 0.92;  // of the picture's half width and height
    const Vec3 hips(0.0, 0.5 * avatar.height_m, 0.0);
    const std::array<Vec3, 3> places{place_m, Vec3(0.0), Vec3(0.0, avatar.height_m, 0.0)};
    const auto shown = [&](const Orbit& from) {
        const Pose eye = from.stageFromEye(hips, avatar.height_m);
        return std::all_of(places.begin(), places.end(), [&](const Vec3& place) {
            const auto at = inPicture(eye, vertical_fov_rad, aspect, place);
            return at && std::abs(at->x) <= within && std::abs(at->y) <= within;
        });
    };
    for (double turned_deg = 0.0; turned_deg <= 180.0; turned_deg += 15.0)
        for (const double side : {1.0, -1.0})
            for (const double farther : {1.0, 1.15, 1.3, 1.5}) {
                Orbit from = orbit;
                from.azimuth_rad += side * radiansFromDegrees(turned_deg);
                from.distance_m *= farther;
                if (shown(from)) return from;
            }
    return orbit;
}

Result<void> writeStrip(const std::string& file, const assets::Avatar& avatar, WindowSize size,
                        const std::vector<double>& times_s,
                        const std::function<renderer::Scene(double)>& scene_at) {
    const int count = static_cast<int>(times_s.size());
    renderer::Image strip;
    strip.width = size.width * count;
    strip.height = size.height;
    const auto row = static_cast<std::size_t>(size.width) * 3;
    strip.rgb.resize(row * times_s.size() * static_cast<std::size_t>(size.height));
    std::size_t i = 0;
    const auto drawn = drawFrames(
        avatar, size, count, [&](int frame) { return scene_at(times_s[static_cast<std::size_t>(frame)]); },
        [&](const renderer::Image& one) -> Result<void> {
            for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y)
                std::copy_n(one.rgb.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                            strip.rgb.begin() + static_cast<std::ptrdiff_t>((y * times_s.size() + i) * row));
            ++i;
            return {};
        });
    if (!drawn) return drawn;
    return renderer::writePng(file, strip);
}

Result<void> showInWindow(const std::string& title, WindowSize size, const assets::Avatar& avatar,
                          const std::function<std::unique_ptr<Shown>(GLFWwindow*)>& make) {
    PressedKeys keys;
    auto opened = GlWindow::open(title, size, false);
    if (!opened) return tl::unexpected(opened.error());
    const GlWindow& window = **opened;
    auto renderer = renderer::Renderer::create(avatar, {});
    if (!renderer) return tl::unexpected(renderer.error());
    keys.connect(window.handle());
    const auto shown = make(window.handle());
    while (glfwWindowShouldClose(window.handle()) == GLFW_FALSE) {
        glfwPollEvents();
        const std::vector<int> pressed = keys.take();
        if (std::count(pressed.begin(), pressed.end(), GLFW_KEY_ESCAPE) > 0) break;
        const WindowSize now = window.framebufferSize();
        if (now.width == 0 || now.height == 0) {
            glfwWaitEventsTimeout(0.1);
            continue;
        }
        const renderer::Scene scene = shown->scene();
        renderer->draw(scene, now.width, now.height);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, now.width, now.height);
        shown->frame(scene, pressed);
        glfwSwapBuffers(window.handle());
    }
    return {};
}

}  // namespace deixis::app
