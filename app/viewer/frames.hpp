// Pictures drawn off screen, one after another; as a film, an MP4 file made by ffmpeg.
#pragma once

#include <functional>
#include <string>

#include "app/window/gl_window.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "renderer/drawing/renderer.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::app {

using SceneOf = std::function<renderer::Scene(int frame)>;
using TakeImage = std::function<Result<void>(const renderer::Image&)>;

/// Draws frames 0 to `count` - 1 and hands each on; no window is opened. Tells on a terminal that it draws.
/// Errors: there is no OpenGL, and those of `take`, after which nothing more is drawn.
[[nodiscard]] Result<void> drawFrames(const assets::Avatar& avatar, WindowSize size, int count,
                                      const SceneOf& scene_of, const TakeImage& take);

/// A film of these frames; prints how many. Nothing is left of one that is not finished. Errors also: there
/// is no ffmpeg, or it cannot write the file.
[[nodiscard]] Result<void> writeFilm(const std::string& mp4_file, double frames_per_s,
                                     const assets::Avatar& avatar, WindowSize size, int count,
                                     const SceneOf& scene_of);

/// Of a movement of `duration_s`, whose scene at a time in seconds `scene_at` gives: 30 frames a second.
[[nodiscard]] Result<void> writeFilm(const std::string& mp4_file, const assets::Avatar& avatar,
                                     WindowSize size, double duration_s,
                                     const std::function<renderer::Scene(double)>& scene_at);

}  // namespace deixis::app
