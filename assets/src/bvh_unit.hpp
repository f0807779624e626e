// Which unit of length a BVH file is in, told from the size of its figure.
#pragma once

#include <string>

#include "motion/clip.hpp"

namespace deixis::assets {

struct LengthUnit {
    double metres_per_unit;
    std::string words;
};

/// `clip` is in file units.
[[nodiscard]] LengthUnit detectUnit(const motion::Clip& clip);

}  // namespace deixis::assets
