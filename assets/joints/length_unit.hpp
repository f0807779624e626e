// Which unit of length a file is in, told from the size of its figure.
#pragma once

#include <string>

#include "assets/joints/clip_import.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::assets {

/// `clip` is in file units.
[[nodiscard]] FoundUnit detectUnit(const motion::Clip& clip);

/// Of joint positions in file units: by the legs or, in an upper body, by the arms, as long as they are on
/// the mean.
[[nodiscard]] FoundUnit detectUnit(const std::vector<motion::BonePositions>& frames);

/// "centimetre", or "0.0123 m" where the unit has no name.
[[nodiscard]] std::string givenUnitName(double metres);

/// What of the unit a file's description says, such as "centimetre (detected)".
[[nodiscard]] std::string unitWords(const FoundUnit& unit);

}  // namespace deixis::assets
