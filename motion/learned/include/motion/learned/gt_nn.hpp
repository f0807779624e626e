// The system gt-nn of a lab's own demonstrations: a target is pointed at by the demonstration with the
// nearest target, unchanged (Deichler et al. 2023, section 2.4.1.2). It is the topline of naturalness only as
// far as its clips are recorded.
#pragma once

#include <memory>
#include <vector>

#include "motion/networks/weights_file.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::motion {

inline constexpr const char* gt_nn_architecture = "gt-nn";

/// Demonstrations as arrays, in float32 all but unchanged: targets, phases, and each clip's joints. All on
/// the same skeleton; at least one.
[[nodiscard]] NetworkWeights gtNnWeights(const std::vector<Demonstration>& demonstrations);

/// The system. Fails where the weights are of another architecture or skeleton. A hold that a request asks
/// for is the gesture's hold played slower or faster; `seed` and `unsteadiness_m` change nothing.
[[nodiscard]] Result<std::unique_ptr<Generator>> makeGtNn(const NetworkWeights& weights,
                                                          const Skeleton& avatar);

}  // namespace deixis::motion
