#include "app/viewer/system_viewer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "app/window/picture_point.hpp"
#include "app/window/window_gui.hpp"
#include "core/room.hpp"
#include "frames.hpp"
#include "motion/pointing/accuracy.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/pointing/rays.hpp"
#include "orbit.hpp"
#include "physics/figure/figure.hpp"
#include "physics/figure/figure_pose.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::app {

namespace {

constexpr double ball_radius_m = 0.06;
constexpr double pause_s = 0.7;  ///< between two performances

/// The system's clip for where the ball is.
class Performance {
  public:
    Performance(const motion::Generator& system, const Vec3& target_m) : system_(system) {
        pointAt(target_m);
    }

    void pointAt(const Vec3& target_m) {
        target_m_ = target_m;
        constexpr std::uint64_t seed = 1;
        made_ = system_.generate({"", target_m, seed, {}});
        const auto map = motion::mapByVrmNames(made_.clip.skeleton);
        const auto world = motion::worldPoses(made_.clip);
        const Ray ray =
            motion::pointingRay(made_.clip.skeleton, map, world[static_cast<std::size_t>(middle())],
                                made_.hand, motion::PointingRay::forearm);
        forearm_error_rad_ = motion::angularError(ray, target_m);
        const auto arm = motion::armTrack(world, map, made_.hand, made_.clip.frame_time_s);
        const auto accuracy = arm ? motion::pointingAccuracy(*arm, target_m, middle(), {}) : std::nullopt;
        reward_ = accuracy ? std::optional(accuracy->reward) : std::nullopt;
    }

    [[nodiscard]] const motion::Clip& clip() const { return made_.clip; }
    [[nodiscard]] const Vec3& target_m() const { return target_m_; }
    [[nodiscard]] double holdTime_s() const { return middle() * made_.clip.frame_time_s; }
    [[nodiscard]] std::string text() const {
        std::string out =
            fmt::format("{}   ball at {:.2f} {:.2f} {:.2f} m   forearm {:.0f} degrees off", system_.name(),
                        target_m_.x, target_m_.y, target_m_.z, degreesFromRadians(forearm_error_rad_));
        if (reward_) out += fmt::format("   Eq. 2 {:.3f}", *reward_);
        return out;
    }

  private:
    [[nodiscard]] int middle() const { return (made_.peak_frame + made_.hold_frame) / 2; }

    const motion::Generator& system_;
    Vec3 target_m_{0.0};
    motion::GeneratedClip made_;
    double forearm_error_rad_ = 0.0;
    std::optional<double> reward_;
};

renderer::Scene sceneOf(const Performance& performance, double time_s, const assets::Avatar& avatar,
                        const Orbit& orbit, motion::LocalPose& pose) {
    motion::sample(performance.clip(), time_s, pose);
    renderer::Scene scene = sceneAround(avatar, pose, orbit);
    scene.balls.push_back({performance.target_m(), ball_radius_m, glm::vec3(0.75F, 0.12F, 0.05F)});
    return scene;
}

/// Between the window's points and the stage.
class Lens {
  public:
    Lens(const renderer::Camera& camera, const ImVec2& window)
        : camera_(camera), window_(window), aspect_(static_cast<double>(window.x / window.y)) {}

    /// None behind the camera.
    [[nodiscard]] std::optional<ImVec2> seen(const Vec3& place_m) const {
        const auto at = inPicture(camera_.stage_from_eye, camera_.vertical_fov_rad, aspect_, place_m);
        if (!at) return std::nullopt;
        return ImVec2(0.5F * window_.x * static_cast<float>(1.0 + at->x),
                      0.5F * window_.y * static_cast<float>(1.0 - at->y));
    }
    /// Of a size at a place.
    [[nodiscard]] float pixels(double size_m, const Vec3& place_m) const {
        const double half =
            std::tan(0.5 * camera_.vertical_fov_rad) * std::max(camera_.near_m, ahead_m(place_m));
        return 0.5F * window_.y * static_cast<float>(size_m / half);
    }
    /// Where a point of the window is in the plane through `place_m` that faces the camera.
    [[nodiscard]] Vec3 beside(const ImVec2& point, const Vec3& place_m) const {
        const PicturePoint at{2.0 * static_cast<double>(point.x / window_.x) - 1.0,
                              1.0 - 2.0 * static_cast<double>(point.y / window_.y)};
        const Ray ray = rayThrough(camera_.stage_from_eye, camera_.vertical_fov_rad, aspect_, at);
        const double forwards = ahead_m(ray.origin + ray.direction);
        return ray.origin + ray.direction * (ahead_m(place_m) / forwards);
    }

  private:
    [[nodiscard]] double ahead_m(const Vec3& place_m) const {
        return -transformPoint(inverse(camera_.stage_from_eye), place_m).z;
    }

    const renderer::Camera& camera_;
    ImVec2 window_;
    double aspect_;
};

Vec3 keptInRoom(const Vec3& place_m) {
    const Vec3 margin(ball_radius_m);
    return glm::clamp(place_m, room_low + margin, room_high - margin);
}

/// The body's segments over the picture.
void drawGhost(const physics::Figure& figure, const motion::LocalPose& pose, const Lens& lens) {
    const auto fit = physics::fitPose(figure, pose);
    const auto segments = physics::segmentPoses(figure, physics::rootOf(figure, pose), fit.angles_rad);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    constexpr ImU32 inside = IM_COL32(0x56, 0xB4, 0xE9, 110), joint = IM_COL32(0xF4, 0xF1, 0xEA, 220);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const physics::Shape& shape = figure.segments[i].shape;
        const Vec3 from = transformPoint(segments[i], shape.from_m),
                   to = transformPoint(segments[i], shape.to_m);
        const auto a = lens.seen(from), b = lens.seen(to), at = lens.seen(segments[i].position);
        if (!a || !b || !at) continue;
        const double radius_m =
            shape.radius_m > 0.0 ? shape.radius_m : std::max(shape.half_box_m.x, shape.half_box_m.y);
        const float radius = lens.pixels(radius_m, 0.5 * (from + to));
        list.AddLine(*a, *b, inside, 2 * radius);
        list.AddCircleFilled(*a, radius, inside);
        list.AddCircleFilled(*b, radius, inside);
        list.AddCircleFilled(*at, 3.0F, joint);
    }
}

class SystemWindow : public Shown {
  public:
    SystemWindow(Performance performance, const assets::Avatar& avatar, const physics::Figure& figure,
                 Orbit orbit, GLFWwindow* window)
        : performance_(std::move(performance)),
          avatar_(avatar),
          figure_(figure),
          orbit_(orbit),
          gui_(window) {}

    /// The scene of this frame: before the window's own part of it.
    renderer::Scene scene() override {
        const double shown_s =
            dragged_ ? performance_.holdTime_s() : std::min(time_s_, performance_.clip().duration_s());
        return sceneOf(performance_, shown_s, avatar_, orbit_, pose_);
    }

    /// Text, ghost, mouse and keys.
    void frame(const renderer::Scene& scene, const std::vector<int>& keys) override {
        gui_.beginFrame();
        const ImGuiIO& io = ImGui::GetIO();
        for (const int key : keys) {
            if (key == GLFW_KEY_SPACE) playing_ = !playing_;
            if (key == GLFW_KEY_G) ghost_ = !ghost_;
        }
        if (playing_ && !dragged_)
            time_s_ = std::fmod(time_s_ + static_cast<double>(io.DeltaTime),
                                performance_.clip().duration_s() + pause_s);
        const Lens lens(scene.camera, io.DisplaySize);
        mouse(io, lens);
        if (ghost_) drawGhost(figure_, pose_, lens);
        bar();
        gui_.endFrame();
    }

  private:
    void mouse(const ImGuiIO& io, const Lens& lens) {
        const Vec3 ball_m = performance_.target_m();
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.WantCaptureMouse)
            if (const auto at = lens.seen(ball_m)) {
                const float away = std::hypot(at->x - io.MousePos.x, at->y - io.MousePos.y);
                dragged_ = away < std::max(12.0F * gui_.scale(), 1.5F * lens.pixels(ball_radius_m, ball_m));
            }
        if (dragged_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
            dragged_ = false;
            time_s_ = 0.0;
        }
        if (!dragged_) {
            if (!io.WantCaptureMouse) orbit_.follow(io, ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F));
            return;
        }
        Vec3 wanted_m = lens.beside(io.MousePos, ball_m);
        // The wheel takes the ball nearer to the camera, or farther.
        const Vec3 ahead = wanted_m - orbit_.stageFromEye(Vec3(0.0), avatar_.height_m).position;
        wanted_m -= 0.08 * static_cast<double>(io.MouseWheel) * glm::normalize(ahead);
        wanted_m = keptInRoom(wanted_m);
        if (glm::distance(wanted_m, ball_m) > 1e-4) performance_.pointAt(wanted_m);
    }

    void bar() {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float margin = 16.0F;
        ImGui::SetNextWindowPos({margin, screen.y - margin}, ImGuiCond_Always, {0.0F, 1.0F});
        ImGui::SetNextWindowSize({screen.x - 2 * margin, 0.0F});
        ImGui::SetNextWindowBgAlpha(0.82F);
        ImGui::Begin("system", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        ImGui::TextUnformatted(performance_.text().c_str());
        ImGui::TextDisabled(
            "Drag the ball: point there   Wheel while dragging: nearer or farther   Drag beside it: turn   "
            "Wheel: "
            "zoom   G: the simulated body   Space: play or pause   Esc: close");
        ImGui::End();
    }

    Performance performance_;
    const assets::Avatar& avatar_;
    const physics::Figure& figure_;
    Orbit orbit_;
    WindowGui gui_;
    motion::LocalPose pose_;
    bool playing_ = true;
    bool ghost_ = false;
    bool dragged_ = false;
    double time_s_ = 0.0;
};

Result<void> window(Performance performance, const motion::Generator& system, const assets::Avatar& avatar,
                    const Orbit& orbit, WindowSize size) {
    const auto figure = physics::makeFigure(avatar.skeleton, physics::Stance::free);
    if (!figure) return tl::unexpected(figure.error());
    return showInWindow(fmt::format("Deixis - {}", system.name()), size, avatar, [&](GLFWwindow* window) {
        return std::make_unique<SystemWindow>(std::move(performance), avatar, *figure, orbit, window);
    });
}

}  // namespace

Result<void> viewSystem(const motion::Generator& system, const assets::Avatar& avatar, const Vec3& target_m,
                        const ViewOptions& options) {
    const auto size = parseWindowSize(options.size);
    if (!size) return tl::unexpected(size.error());
    auto orbit = orbitFrom(options.from);
    if (!orbit) return tl::unexpected(orbit.error());
    if (options.from.empty())
        orbit = orbitShowing(*orbit, avatar, keptInRoom(target_m),
                             static_cast<double>(size->width) / static_cast<double>(size->height));
    Performance performance(system, keptInRoom(target_m));
    motion::LocalPose pose;
    const auto scene_at = [&](double time_s) { return sceneOf(performance, time_s, avatar, *orbit, pose); };
    if (!options.mp4_file.empty())
        return writeFilm(options.mp4_file, avatar, *size, performance.clip().duration_s(), scene_at);
    if (options.screenshot.empty()) return window(std::move(performance), system, avatar, *orbit, *size);
    const std::vector<double> times =
        options.times_s.empty() ? std::vector<double>{performance.holdTime_s()} : options.times_s;
    return writeStrip(options.screenshot, avatar, *size, times, scene_at);
}

}  // namespace deixis::app
