// Boards in the world: what they say, how large they are, where they stand, and what a ray meets on them.
//
// Sizes follow what is comfortable to read in a headset at about 1.5 m: lines of at least 35 mm (1.3 degrees)
// and buttons of at least 0.13 m (5 degrees).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/station.hpp"

namespace deixis::studies {

struct ButtonSpec {
    std::string label;
    int id = 0;
};

/// Title, body and (bold) emphasis above a row of buttons; as wide and high as the text needs. No progress
/// bar where `progress` is negative.
[[nodiscard]] Panel messagePanel(const std::string& title, const std::string& body,
                                 const std::string& emphasis, const std::vector<ButtonSpec>& buttons,
                                 double progress);

/// The question above a row of buttons "1".."n" whose captions are the labels; their ids count up from
/// `first_id`. `replay` adds a button beside the question.
[[nodiscard]] Panel ratingPanel(const std::string& question, const std::vector<std::string>& labels,
                                int first_id, const std::optional<ButtonSpec>& replay);

/// The question and a button beside it.
[[nodiscard]] Panel questionPanel(const std::string& question, const ButtonSpec& button);

/// All three turn aside as far as an avatar that stands nearer than the panel would cover it.
/// Upright, 1.3 m before the viewer, its centre a little below the eyes.
[[nodiscard]] Pose messagePose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// Low before the viewer and tilted up like a lectern: under the avatar's chest as seen from the viewer's
/// place, so that face and torso stay free.
[[nodiscard]] Pose lecternPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// Lower and nearer still, where balls are shown that it must not cover.
[[nodiscard]] Pose deskPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

struct PanelHit {
    double distance_m = 0.0;
    int button = -1;  ///< index of the enabled button that is met; -1: the bare board
};

/// Where the ray meets the board from either side; none where it passes it by.
[[nodiscard]] std::optional<PanelHit> meetPanel(const Panel& panel, const Ray& ray);

/// Lines that a text takes at a line height, wrapped between words, if a character is on average half as
/// wide as the line is high. Counts code points; at least one line a paragraph.
[[nodiscard]] int estimateLines(std::string_view text, double size_m, double width_m);

}  // namespace deixis::studies
