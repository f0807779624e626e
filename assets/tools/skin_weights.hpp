// Which bones move a place on the figure.
#pragma once

#include <array>
#include <cstdint>

#include "core/pose.hpp"

namespace deixis::avatar_maker {

struct SkinWeights {
    std::array<std::uint8_t, 4> joints{};  ///< indices into motion::referenceHumanoid()
    std::array<float, 4> weights{};        ///< multiples of 1/1024, largest first; sum exactly 1
};

/// Weights at a place of the T pose.
[[nodiscard]] SkinWeights skinWeightsAt(const Vec3& p);

}  // namespace deixis::avatar_maker
