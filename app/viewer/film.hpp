// A film as an MP4 file, made by ffmpeg.
#pragma once

#include <functional>
#include <string>

#include "app/window/gl_window.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "renderer/drawing/renderer.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::app {

using TakeImage = std::function<Result<void>(const renderer::Image&)>;

/// Frames that `draw` hands on, one after another, all of `size`; it returns their number. Nothing is left of
/// a film that is not finished. Errors: there is no ffmpeg, the file cannot be written, and those of `draw`.
[[nodiscard]] Result<void> writeFilm(const std::string& mp4_file, WindowSize size, double frames_per_s,
                                     const std::function<Result<int>(const TakeImage&)>& draw);

/// The same of scenes from 0 to `end_s`, 30 frames a second; no window is opened.
[[nodiscard]] Result<void> writeFilm(const std::string& mp4_file, const assets::Avatar& avatar,
                                     WindowSize size, double end_s,
                                     const std::function<renderer::Scene(double)>& scene_at);

}  // namespace deixis::app
