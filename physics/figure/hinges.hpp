// The axes, limits and actuators of the body's joints.
#pragma once

#include <vector>

#include "physics/figure/figure.hpp"

namespace deixis::physics {

/// Three hinges each, or one of elbow and knee. `bone`: from the joint to the next, any length.
[[nodiscard]] std::vector<Hinge> trunkHinges();
[[nodiscard]] std::vector<Hinge> neckHinges();
[[nodiscard]] std::vector<Hinge> shoulderHinges(motion::Side side, const Vec3& bone);
[[nodiscard]] std::vector<Hinge> elbowHinges(motion::Side side);
[[nodiscard]] std::vector<Hinge> hipHinges(motion::Side side);
[[nodiscard]] std::vector<Hinge> kneeHinges(motion::Side side);
[[nodiscard]] std::vector<Hinge> ankleHinges(motion::Side side);

}  // namespace deixis::physics
