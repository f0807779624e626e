// Motion as rows of exponential maps, the format of human motion prediction on Human3.6M and CMU.
#pragma once

#include <string>
#include <string_view>

#include "assets/joints/clip_import.hpp"
#include "core/error.hpp"

namespace deixis::assets {

/// Reads one frame a line, numbers separated by commas or blanks: the root's position, then for each joint of
/// the skeleton x y z of its rotation, the axis times the angle in radians. 99 numbers are the 32 joints of
/// Human3.6M (millimetres, 25 fps assumed) as in Martinez, Black & Romero 2017, "On human motion prediction
/// using recurrent neural networks" (github.com/una-dinosauria/human-motion-prediction); 117 are the 38
/// joints of CMU (1/0.45 inch, 30 fps assumed) as in Li, Zhang, Lee & Lee 2018, "Convolutional sequence to
/// sequence model for human dynamics"
/// (github.com/chaneyddtt/Convolutional-Sequence-to-Sequence-Model-for-Human-Dynamics).
/// These data turn row vectors, so that a joint's rotation is the exponential of the negative map. Bone
/// lengths are those of the one skeleton that these works draw all people with. `name` stands for the file in
/// errors, which name the line.
[[nodiscard]] Result<ImportedClip> parseExpmapRows(std::string_view text, const std::string& name,
                                                   const ImportOptions& options = {});

}  // namespace deixis::assets
