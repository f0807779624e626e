#include "app/viewer/clip_viewer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "app/window/window_gui.hpp"
#include "frames.hpp"
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

// The clip with a transport bar.
class ClipWindow : public Shown {
  public:
    ClipWindow(const motion::Clip& clip, std::string title, std::string description,
               const assets::Avatar& avatar, const Orbit& orbit, double begin_s, GLFWwindow* window)
        : clip_(clip),
          title_(std::move(title)),
          description_(std::move(description)),
          scene_(clip, avatar),
          orbit_(orbit),
          time_s_(static_cast<float>(begin_s)),
          gui_(window) {}

    renderer::Scene scene() override { return scene_.at(static_cast<double>(time_s_), orbit_); }

    /// Advances, and draws the bar over the picture; turns and zooms by the mouse outside the bar.
    void frame(const renderer::Scene& /*scene*/, const std::vector<int>& keys) override {
        gui_.require(title_);
        gui_.require(description_);
        gui_.beginFrame();
        const ImGuiIO& io = ImGui::GetIO();
        const auto end_s = static_cast<float>(clip_.duration_s());
        if (playing_ && end_s > 0.0F) time_s_ = std::fmod(time_s_ + speed_ * io.DeltaTime, end_s);
        for (const int key : keys) {
            if (key == GLFW_KEY_SPACE) playing_ = !playing_;
            if (key != GLFW_KEY_LEFT && key != GLFW_KEY_RIGHT) continue;
            playing_ = false;
            const double step_s = key == GLFW_KEY_LEFT ? -clip_.frame_time_s : clip_.frame_time_s;
            time_s_ = std::clamp(time_s_ + static_cast<float>(step_s), 0.0F, end_s);
        }
        if (!io.WantCaptureMouse) orbit_.follow(io, ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F));
        bar(end_s);
        gui_.endFrame();
    }

  private:
    void bar(float end_s) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float margin = 16.0F;
        ImGui::SetNextWindowPos({margin, screen.y - margin}, ImGuiCond_Always, {0.0F, 1.0F});
        ImGui::SetNextWindowSize({screen.x - 2 * margin, 0.0F});
        ImGui::SetNextWindowBgAlpha(0.82F);
        ImGui::Begin("transport", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        ImGui::Text("%s   %s", title_.c_str(), description_.c_str());
        if (ImGui::Button(playing_ ? "Pause" : "Play", {ImGui::GetFontSize() * 4.5F, 0.0F}))
            playing_ = !playing_;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(screen.x * 0.52F);
        const int frame = static_cast<int>(std::lround(static_cast<double>(time_s_) / clip_.frame_time_s));
        const std::string label = fmt::format(
            "%.2f s   frame {} of {}", std::min(frame, clip_.frameCount() - 1) + 1, clip_.frameCount());
        if (ImGui::SliderFloat("##time", &time_s_, 0.0F, end_s, label.c_str())) playing_ = false;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 3.6F);
        ImGui::SliderFloat("speed", &speed_, 0.1F, 2.0F, "%.2fx");
        ImGui::TextDisabled(
            "Space: play or pause   Arrows: one frame   Drag: turn   Wheel: zoom   Esc: close");
        ImGui::End();
    }

    const motion::Clip& clip_;
    std::string title_;
    std::string description_;
    ClipScene scene_;
    Orbit orbit_;
    bool playing_ = true;
    float time_s_;
    float speed_ = 1.0F;
    WindowGui gui_;
};

}  // namespace

Result<void> viewClip(const motion::Clip& clip, const std::string& name, const std::string& description,
                      const assets::Avatar& avatar, const ViewOptions& options) {
    const auto size = parseWindowSize(options.size);
    if (!size) return tl::unexpected(size.error());
    const auto orbit = orbitFrom(options.from);
    if (!orbit) return tl::unexpected(orbit.error());
    if (!options.screenshot.empty()) {
        ClipScene scene(clip, avatar);
        const std::vector<double> times =
            options.times_s.empty() ? std::vector<double>{0.0} : options.times_s;
        return writeStrip(options.screenshot, avatar, *size, times,
                          [&](double time_s) { return scene.at(time_s, *orbit); });
    }
    if (!options.mp4_file.empty()) {
        ClipScene scene(clip, avatar);
        return writeFilm(options.mp4_file, avatar, *size, clip.duration_s(),
                         [&](double time_s) { return scene.at(time_s, *orbit); });
    }
    const std::string title = std::filesystem::path(name).filename().string();
    const double begin_s = options.times_s.empty() ? 0.0 : options.times_s.front();
    return showInWindow("Deixis - " + title, *size, avatar, [&](GLFWwindow* window) {
        return std::make_unique<ClipWindow>(clip, title, description, avatar, *orbit, begin_s, window);
    });
}

}  // namespace deixis::app
