// A recorded session in a window: scrub, speed, first or third person, trails. Or as pictures or a film.
#pragma once

#include <string>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "results/store/recording.hpp"
#include "studies/session/session.hpp"

namespace deixis::app {

inline constexpr const char* first_replay_picture = "frame_00001.png";

struct ReplayOptions {
    std::string view = "first";  ///< "first": by the participant's eyes; "third": from outside
    std::string png_folder;      ///< frame_00001.png, ...
    std::string mp4_file;
    double frames_per_s = 30.0;  ///< of what is written
    double speed = 1.0;
    double trail_s = 2.0;  ///< of the ways shown in third person
    std::string size = "1280x720";
};

/// Shows all answers of the recording, one after another. Where pictures or a film are asked for, no window
/// is opened. Fails if ffmpeg is asked for and not installed.
[[nodiscard]] Result<void> showReplay(const results::Recording& recording, const studies::ClipSource& clips,
                                      const assets::Avatar& avatar, const ReplayOptions& options);

}  // namespace deixis::app
