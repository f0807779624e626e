// A camera around the avatar, as the viewers of clips and systems have it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/window/gl_window.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "renderer/scene/scene.hpp"

struct ImGuiIO;

namespace deixis::app {

/// Looks at the avatar's middle from around it.
struct Orbit {
    double azimuth_rad = 0.0;  ///< 0 in front of the avatar, positive towards its left
    double elevation_rad = radiansFromDegrees(8.0);
    double distance_m = 3.4;

    /// From farther away where the figure is taller than people are, and never from outside the room.
    [[nodiscard]] Pose stageFromEye(const Vec3& hips, double height_m) const;
    /// Turned where the mouse drags, nearer or farther by the wheel.
    void follow(const ImGuiIO& io, bool dragging);
};

/// "front", "left", "right", "back" or "three-quarter", which an empty name is, too.
[[nodiscard]] Result<Orbit> orbitFrom(const std::string& name);

/// The avatar in a pose, which walks on the spot where it would leave the room, and the camera.
[[nodiscard]] renderer::Scene sceneAround(const assets::Avatar& avatar, const motion::LocalPose& pose,
                                          const Orbit& orbit);

/// As little beside `orbit` as it takes to have a standing avatar and a place in a picture of this shape
/// (width over height); itself where nothing in the room does.
[[nodiscard]] Orbit orbitShowing(const Orbit& orbit, const assets::Avatar& avatar, const Vec3& place_m,
                                 double aspect);

/// What a viewer's window shows, frame by frame.
class Shown {
  public:
    virtual ~Shown() = default;
    [[nodiscard]] virtual renderer::Scene scene() = 0;
    /// What stands over the picture of that scene; mouse and keys.
    virtual void frame(const renderer::Scene& scene, const std::vector<int>& keys) = 0;
};

/// Opens a window and shows what `make` makes for it, until it is closed or Escape pressed.
[[nodiscard]] Result<void> showInWindow(const std::string& title, WindowSize size,
                                        const assets::Avatar& avatar,
                                        const std::function<std::unique_ptr<Shown>(GLFWwindow*)>& make);

/// Pictures at several times, side by side, as a PNG file; no window is opened.
[[nodiscard]] Result<void> writeStrip(const std::string& file, const assets::Avatar& avatar, WindowSize size,
                                      const std::vector<double>& times_s,
                                      const std::function<renderer::Scene(double)>& scene_at);

}  // namespace deixis::app
