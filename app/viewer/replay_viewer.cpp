#include "app/viewer/replay_viewer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <vector>

#include "app/window/gl_window.hpp"
#include "app/window/window_gui.hpp"
#include "core/staging.hpp"
#include "frames.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "orbit.hpp"
#include "renderer/drawing/renderer.hpp"
#include "replay_scene.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

// Everything of one answer that is needed to show it.
class Show {
  public:
    Show(const results::Recording& recording, const studies::ClipSource& clips, const assets::Avatar& avatar)
        : recording_(recording), idle_(motion::relaxedPose(avatar.skeleton)) {
        for (const results::RecordedAnswer& answer : recording.answers)
            replays_.emplace_back(answer.trial, clips, avatar.skeleton, idle_);
    }
    Show(const Show&) = delete;
    Show& operator=(const Show&) = delete;

    [[nodiscard]] std::size_t count() const { return replays_.size(); }
    [[nodiscard]] const results::RecordedAnswer& answer(std::size_t i) const { return recording_.answers[i]; }
    [[nodiscard]] double length_s(std::size_t i) const { return replays_[i].end_s() - replays_[i].begin_s(); }

    /// At `time_s` after the trial's beginning.
    [[nodiscard]] renderer::Scene scene(std::size_t i, double time_s, bool from_outside,
                                        const OutsideView& view, double trail_s) const {
        const double at_s = replays_[i].begin_s() + time_s;
        return from_outside ? sceneFromOutside(replays_[i], answer(i).trial, at_s, view, trail_s)
                            : sceneByTheirEyes(replays_[i], answer(i).trial, at_s);
    }

    [[nodiscard]] std::string title(std::size_t i) const {
        const studies::Trial& trial = answer(i).trial.trial;
        return fmt::format("Trial {} ({}{}): {}{}", trial.index, trial.stage,
                           trial.practice ? ", practice" : "", answer(i).outcome,
                           answer(i).superseded ? " - repeated, does not count" : "");
    }

  private:
    const results::Recording& recording_;
    motion::LocalPose idle_;
    std::vector<studies::TrialReplay> replays_;
};

/// When each frame of each answer is.
struct Frame {
    std::size_t trial;
    double time_s;
};

std::vector<Frame> framesOf(const Show& show, const ReplayOptions& options) {
    const double step_s = options.speed / options.frames_per_s;
    std::vector<Frame> out;
    for (std::size_t i = 0; i < show.count(); ++i) {
        const int count = static_cast<int>(std::floor(show.length_s(i) / step_s)) + 1;
        for (int k = 0; k < count; ++k) out.push_back({i, k * step_s});
    }
    return out;
}

/// Pictures of an earlier replay, by their names.
std::vector<fs::path> framesIn(const fs::path& folder) {
    std::vector<fs::path> out;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        const fs::path name = entry.path().filename();
        if (name.extension() == ".png" && name.string().starts_with("frame_")) out.push_back(name);
    }
    return out;
}

/// Of all frames, as pictures or as a film.
Result<void> write(const Show& show, const assets::Avatar& avatar, const ReplayOptions& options,
                   WindowSize size) {
    const std::vector<Frame> frames = framesOf(show, options);
    const int count = static_cast<int>(frames.size());
    const SceneOf scene_of = [&](int number) {
        const Frame& frame = frames[static_cast<std::size_t>(number)];
        return show.scene(frame.trial, frame.time_s, options.view == "third", OutsideView{}, options.trail_s);
    };
    if (!options.png_folder.empty()) {
        auto staging = Staging::within(options.png_folder);
        if (!staging) return tl::unexpected(staging.error());
        std::vector<fs::path> names;
        const auto drawn = drawFrames(avatar, size, count, scene_of, [&](const renderer::Image& image) {
            names.emplace_back(fmt::format("frame_{:05}.png", names.size() + 1));
            return renderer::writePng(staging->path() / names.back(), image);
        });
        if (!drawn) return drawn;
        if (auto moved = staging->moveHome(names, framesIn(options.png_folder), false); !moved) return moved;
        fmt::print("{} frames: {}\n", count, options.png_folder);
    }
    if (options.mp4_file.empty()) return {};
    return writeFilm(options.mp4_file, options.frames_per_s, avatar, size, count, scene_of);
}

// The window's controls.
class Controls : public Shown {
  public:
    Controls(GLFWwindow* window, const Show& show, const ReplayOptions& options)
        : from_outside(options.view == "third"),
          speed(static_cast<float>(options.speed)),
          trail_s(static_cast<float>(options.trail_s)),
          show_(show),
          gui_(window) {}

    std::size_t trial = 0;
    bool playing = true;
    bool from_outside;
    float time_s = 0.0F;
    float speed;
    float trail_s;
    OutsideView view{};

    renderer::Scene scene() override {
        return show_.scene(trial, static_cast<double>(time_s), from_outside, view,
                           static_cast<double>(trail_s));
    }

    /// Advances, and draws the bar over the picture.
    void frame(const renderer::Scene& /*scene*/, const std::vector<int>& keys) override {
        const Show& show = show_;
        gui_.beginFrame();
        for (const int key : keys) obey(key, show);
        const ImGuiIO& io = ImGui::GetIO();
        const auto end_s = static_cast<float>(show.length_s(trial));
        if (playing) time_s += speed * io.DeltaTime;
        if (time_s > end_s) {
            time_s = end_s;
            if (trial + 1 < show.count() && playing)
                go(trial + 1);
            else
                playing = false;
        }
        if (!io.WantCaptureMouse && from_outside) turn(io);
        bar(show, end_s);
        gui_.endFrame();
    }

  private:
    const Show& show_;
    WindowGui gui_;

    void go(std::size_t to) {
        trial = to;
        time_s = 0.0F;
    }

    void obey(int key, const Show& show) {
        constexpr float step_s = 1.0F / 30.0F;
        if (key == GLFW_KEY_SPACE) playing = !playing;
        if (key == GLFW_KEY_V) from_outside = !from_outside;
        if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT) {
            playing = false;
            time_s = std::max(0.0F, time_s + (key == GLFW_KEY_LEFT ? -step_s : step_s));
        }
        if (key == GLFW_KEY_PAGE_UP && trial > 0) go(trial - 1);
        if (key == GLFW_KEY_PAGE_DOWN && trial + 1 < show.count()) go(trial + 1);
    }

    void turn(const ImGuiIO& io) {
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F)) {
            view.azimuth_rad -= 0.006 * static_cast<double>(io.MouseDelta.x);
            view.elevation_rad = std::clamp(view.elevation_rad + 0.006 * static_cast<double>(io.MouseDelta.y),
                                            radiansFromDegrees(-5.0), radiansFromDegrees(85.0));
        }
        view.distance_m =
            std::clamp(view.distance_m * std::pow(0.9, static_cast<double>(io.MouseWheel)), 1.0, 9.0);
    }

    void bar(const Show& show, float end_s) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float margin = 16.0F;
        const float letter = ImGui::GetFontSize();
        ImGui::SetNextWindowPos({margin, screen.y - margin}, ImGuiCond_Always, {0.0F, 1.0F});
        ImGui::SetNextWindowSize({screen.x - 2 * margin, 0.0F});
        ImGui::SetNextWindowBgAlpha(0.86F);
        ImGui::Begin("replay", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        ImGui::SetNextItemWidth(screen.x - 2 * margin - 12.0F * letter);
        if (ImGui::BeginCombo("##trial", show.title(trial).c_str(), ImGuiComboFlags_HeightLarge)) {
            for (std::size_t i = 0; i < show.count(); ++i)
                if (ImGui::Selectable(fmt::format("{}##{}", show.title(i), i).c_str(), i == trial)) go(i);
            ImGui::EndCombo();
        }
        ImGui::SameLine();
        if (ImGui::Button("Before", {5.0F * letter, 0.0F}) && trial > 0) go(trial - 1);
        ImGui::SameLine();
        if (ImGui::Button("Next", {5.0F * letter, 0.0F}) && trial + 1 < show.count()) go(trial + 1);

        if (ImGui::Button(playing ? "Pause" : "Play", {4.5F * letter, 0.0F})) {
            if (!playing && time_s >= end_s) time_s = 0.0F;
            playing = !playing;
        }
        ImGui::SameLine();
        ImGui::SetNextItemWidth(screen.x * 0.36F);
        if (ImGui::SliderFloat("##time", &time_s, 0.0F, end_s, "%.2f s")) playing = false;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(8.0F * letter);
        ImGui::SliderFloat("speed", &speed, 0.1F, 4.0F, "%.2fx", ImGuiSliderFlags_Logarithmic);
        ImGui::SameLine();
        if (ImGui::RadioButton("their eyes", !from_outside)) from_outside = false;
        ImGui::SameLine();
        if (ImGui::RadioButton("outside", from_outside)) from_outside = true;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-3.0F * letter);
        ImGui::SliderFloat("trail", &trail_s, 0.0F, 10.0F, "%.1f s");
        const studies::RecordedTrial& shown = show.answer(trial).trial;
        std::string about = fmt::format("{} station", shown.station);
        if (shown.synthetic) about += ", answered by a simulated participant";
        if (shown.tracking.empty()) about += ", head and hand were not recorded";
        ImGui::TextDisabled(
            "%s.   Space: play or pause   Arrows: step   Page keys: trial   V: view   Drag, wheel: "
            "look around   Esc: close",
            about.c_str());
        ImGui::End();
    }
};

}  // namespace

Result<void> showReplay(const results::Recording& recording, const studies::ClipSource& clips,
                        const assets::Avatar& avatar, const ReplayOptions& options) {
    const auto size = parseWindowSize(options.size);
    if (!size) return tl::unexpected(size.error());
    const Show show(recording, clips, avatar);
    if (!options.png_folder.empty() || !options.mp4_file.empty()) return write(show, avatar, options, *size);
    const std::string title =
        fmt::format("Deixis replay - {} - {}", recording.study_title, recording.participant);
    return showInWindow(title, *size, avatar, [&](GLFWwindow* window) {
        return std::make_unique<Controls>(window, show, options);
    });
}

}  // namespace deixis::app
