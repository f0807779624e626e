// The skeletons that rows of exponential maps are of; private to their reader.
#pragma once

#include <cstddef>

#include "motion/skeleton/skeleton.hpp"

namespace deixis::assets {

struct ExpmapSkeleton {
    const char* name;
    std::size_t columns;  ///< 3 and 3 for each joint
    double metres_per_unit;
    const char* unit;
    double fps;                 ///< that of the data as they are mostly used
    const char* fps_remark;     ///< what else they may be at
    motion::Skeleton skeleton;  ///< file units; joints in the order of the columns
};

/// The skeleton of rows of so many numbers; null where there is none.
[[nodiscard]] const ExpmapSkeleton* expmapSkeleton(std::size_t columns);

}  // namespace deixis::assets
