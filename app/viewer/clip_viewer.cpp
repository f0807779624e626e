#include "app/viewer/clip_viewer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "app/window/gl_window.hpp"
#include "app/window/pressed_keys.hpp"
#include "app/window/window_gui.hpp"
#include "orbit.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::app {

namespace {

// The clip at a time, seen by an orbiting camera that goes along with the hips.
class ClipScene {
  public:
    ClipScene(const motion::Clip& clip, const assets::Avatar& avatar) : clip_(clip), avatar_(avatar) {}

    renderer::Scene at(double time_s, const Orbit& orbit) {
        motion::sample(clip_, time_s, pose_);
        return sceneAround(avatar_, pose_, orbit);
    }

  private:
    const motion::Clip& clip_;
    const assets::Avatar& avatar_;
    motion::LocalPose pose_;
};

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
        if (!io.WantCaptureMouse) orbit.follow(io, ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F));
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
    if (!options.screenshot.empty()) {
        const std::vector<double> times =
            options.times_s.empty() ? std::vector<double>{0.0} : options.times_s;
        return writeStrip(options.screenshot, avatar, *size, times,
                          [&](double time_s) { return scene.at(time_s, *orbit); });
    }
    return window(scene, clip, name, description, avatar, *orbit, *size, options);
}

}  // namespace deixis::app
