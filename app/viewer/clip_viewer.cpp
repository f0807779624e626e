#include "app/viewer/clip_viewer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <vector>

#include "app/window/gl_window.hpp"
#include "app/window/pressed_keys.hpp"
#include "app/window/window_gui.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::app {

namespace {

struct NamedView {
    const char* name;
    double azimuth_deg;  // of the camera about the avatar; 0 in front, positive towards the avatar's left
};
constexpr std::array<NamedView, 5> named_views{
    {{"front", 0.0}, {"left", 90.0}, {"right", -90.0}, {"back", 180.0}, {"three-quarter", 35.0}}};

// Looks at the avatar's middle from around it.
struct Orbit {
    double azimuth_rad = 0.0;
    double elevation_rad = radiansFromDegrees(8.0);
    double distance_m = 3.4;

    /// From farther away where the figure is taller than people are.
    [[nodiscard]] Pose stageFromEye(const Vec3& hips, double height_m) const {
        const double size = std::max(1.0, height_m / 1.9);
        const Vec3 middle(hips.x, 0.83 * size, hips.z);
        const Quat turn = yawRotation(azimuth_rad) * glm::angleAxis(-elevation_rad, Vec3(1, 0, 0));
        return {middle + turn * Vec3(0, 0, distance_m * size), turn};
    }
};

Result<Orbit> orbitFrom(const std::string& name) {
    for (const NamedView& view : named_views)
        if (name == view.name) {
            Orbit orbit;
            orbit.azimuth_rad = radiansFromDegrees(view.azimuth_deg);
            return orbit;
        }
    return fail("--from",
                fmt::format("unknown view '{}'; expected front, left, right, back or three-quarter", name));
}

// The clip at a time, seen by an orbiting camera that goes along with the hips.
class ClipScene {
  public:
    ClipScene(const motion::Clip& clip, const assets::Avatar& avatar) : clip_(clip), avatar_(avatar) {}

    renderer::Scene at(double time_s, const Orbit& orbit) {
        motion::sample(clip_, time_s, pose_);
        renderer::Scene scene;
        std::vector<Pose>& joints = scene.avatars.emplace_back();
        motion::worldPose(avatar_.skeleton, pose_, joints);
        const auto hips = static_cast<std::size_t>(std::max(0, avatar_.humanoid[motion::Bone::hips]));
        keepInRoom(joints, hips);
        scene.camera.stage_from_eye = orbit.stageFromEye(joints[hips].position, avatar_.height_m);
        scene.camera.vertical_fov_rad = radiansFromDegrees(42.0);
        return scene;
    }

  private:
    // Who walks farther than this goes on on the spot: the room is small.
    static void keepInRoom(std::vector<Pose>& joints, std::size_t hips) {
        constexpr double farthest_m = 1.0;
        const Vec3 away(joints[hips].position.x, 0.0, joints[hips].position.z);
        const double distance_m = glm::length(away);
        if (distance_m <= farthest_m) return;
        for (Pose& joint : joints) joint.position -= away * (1.0 - farthest_m / distance_m);
    }

    const motion::Clip& clip_;
    const assets::Avatar& avatar_;
    motion::LocalPose pose_;
};

Result<void> picture(ClipScene& clip_scene, const assets::Avatar& avatar, const Orbit& orbit, WindowSize size,
                     const ViewOptions& options) {
    auto context = renderer::OffscreenContext::create();
    if (!context) return tl::unexpected(context.error());
    auto renderer = renderer::Renderer::create(avatar, {});
    if (!renderer) return tl::unexpected(renderer.error());
    const std::vector<double> times = options.times_s.empty() ? std::vector<double>{0.0} : options.times_s;
    renderer::Image strip;
    strip.width = size.width * static_cast<int>(times.size());
    strip.height = size.height;
    strip.rgb.resize(static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height) * 3);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const renderer::Image one =
            renderer->capture(clip_scene.at(times[i], orbit), size.width, size.height);
        const auto row = static_cast<std::size_t>(size.width) * 3;
        for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y)
            std::copy_n(one.rgb.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                        strip.rgb.begin() + static_cast<std::ptrdiff_t>((y * times.size() + i) * row));
    }
    return renderer::writePng(options.screenshot, strip);
}

// The transport bar over the picture.
class Transport {
  public:
    explicit Transport(GLFWwindow* window) : gui_(window) {}

    bool playing = true;
    float time_s = 0.0F;
    float speed = 1.0F;

    /// Advances, and draws the bar over the picture; turns and zooms the orbit by the mouse outside the bar.
    void frame(const motion::Clip& clip, const std::string& title, const std::string& description,
               const std::vector<int>& keys, Orbit& orbit) {
        gui_.require(title);
        gui_.require(description);
        gui_.beginFrame();
        const ImGuiIO& io = ImGui::GetIO();
        const auto end_s = static_cast<float>(clip.duration_s());
        if (playing && end_s > 0.0F) time_s = std::fmod(time_s + speed * io.DeltaTime, end_s);
        for (const int key : keys) {
            if (key == GLFW_KEY_SPACE) playing = !playing;
            if (key != GLFW_KEY_LEFT && key != GLFW_KEY_RIGHT) continue;
            playing = false;
            const double step_s = key == GLFW_KEY_LEFT ? -clip.frame_time_s : clip.frame_time_s;
            time_s = std::clamp(time_s + static_cast<float>(step_s), 0.0F, end_s);
        }
        if (!io.WantCaptureMouse) {
            if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F)) {
                orbit.azimuth_rad -= 0.006 * static_cast<double>(io.MouseDelta.x);
                orbit.elevation_rad =
                    std::clamp(orbit.elevation_rad + 0.006 * static_cast<double>(io.MouseDelta.y),
                               radiansFromDegrees(-5.0), radiansFromDegrees(85.0));
            }
            orbit.distance_m =
                std::clamp(orbit.distance_m * std::pow(0.9, static_cast<double>(io.MouseWheel)), 0.4, 7.0);
        }
        bar(clip, title, description, end_s);
        gui_.endFrame();
    }

  private:
    void bar(const motion::Clip& clip, const std::string& title, const std::string& description,
             float end_s) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float margin = 16.0F;
        ImGui::SetNextWindowPos({margin, screen.y - margin}, ImGuiCond_Always, {0.0F, 1.0F});
        ImGui::SetNextWindowSize({screen.x - 2 * margin, 0.0F});
        ImGui::SetNextWindowBgAlpha(0.82F);
        ImGui::Begin("transport", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        ImGui::Text("%s   %s", title.c_str(), description.c_str());
        if (ImGui::Button(playing ? "Pause" : "Play", {ImGui::GetFontSize() * 4.5F, 0.0F}))
            playing = !playing;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(screen.x * 0.52F);
        const int frame = static_cast<int>(std::lround(static_cast<double>(time_s) / clip.frame_time_s));
        const std::string label = fmt::format("%.2f s   frame {} of {}",
                                              std::min(frame, clip.frameCount() - 1) + 1, clip.frameCount());
        if (ImGui::SliderFloat("##time", &time_s, 0.0F, end_s, label.c_str())) playing = false;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 3.6F);
        ImGui::SliderFloat("speed", &speed, 0.1F, 2.0F, "%.2fx");
        ImGui::TextDisabled(
            "Space: play or pause   Arrows: one frame   Drag: turn   Wheel: zoom   Esc: close");
        ImGui::End();
    }

    WindowGui gui_;
};

Result<void> window(ClipScene& clip_scene, const motion::Clip& clip, const std::string& name,
                    const std::string& description, const assets::Avatar& avatar, Orbit orbit,
                    WindowSize size, const ViewOptions& options) {
    const std::string title = std::filesystem::path(name).filename().string();
    PressedKeys keys;
    auto opened = GlWindow::open("Deixis - " + title, size, false);
    if (!opened) return tl::unexpected(opened.error());
    const GlWindow& gl_window = **opened;
    auto renderer = renderer::Renderer::create(avatar, {});
    if (!renderer) return tl::unexpected(renderer.error());
    keys.connect(gl_window.handle());
    Transport transport(gl_window.handle());
    if (!options.times_s.empty()) transport.time_s = static_cast<float>(options.times_s.front());
    while (glfwWindowShouldClose(gl_window.handle()) == GLFW_FALSE) {
        glfwPollEvents();
        const std::vector<int> pressed = keys.take();
        if (std::count(pressed.begin(), pressed.end(), GLFW_KEY_ESCAPE) > 0) break;
        const WindowSize now = gl_window.framebufferSize();
        if (now.width == 0 || now.height == 0) {
            glfwWaitEventsTimeout(0.1);
            continue;
        }
        renderer->draw(clip_scene.at(static_cast<double>(transport.time_s), orbit), now.width, now.height);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, now.width, now.height);
        transport.frame(clip, title, description, pressed, orbit);
        glfwSwapBuffers(gl_window.handle());
    }
    return {};
}

}  // namespace

Result<void> viewClip(const motion::Clip& clip, const std::string& name, const std::string& description,
                      const assets::Avatar& avatar, const ViewOptions& options) {
    const auto size = parseWindowSize(options.size);
    if (!size) return tl::unexpected(size.error());
    const auto orbit = orbitFrom(options.from);
    if (!orbit) return tl::unexpected(orbit.error());
    ClipScene scene(clip, avatar);
    if (!options.screenshot.empty()) return picture(scene, avatar, *orbit, *size, options);
    return window(scene, clip, name, description, avatar, *orbit, *size, options);
}

}  // namespace deixis::app
