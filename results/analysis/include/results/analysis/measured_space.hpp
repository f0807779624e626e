// Measures with a unit, such as the distance from ball to target, over the targets' places.
#pragma once

#include <string>
#include <vector>

#include "core/pose.hpp"
#include "results/answers/response_table.hpp"

namespace deixis::results {

/// The answers to one target of one system, or of all systems.
struct MeasuredPlace {
    std::string measure;
    std::string unit;
    std::string system;  ///< "all": of all together
    std::string target_id;
    Vec3 position_m{0.0};  ///< in the avatar's frame
    int n = 0;             ///< answers; at least 1
    double mean = 0.0;     ///< in the unit
};

/// In the order of the measures, of "all" and the systems, and of the targets' ids. Empty if nothing is
/// measured in a unit, or the places of its targets are not known.
[[nodiscard]] std::vector<MeasuredPlace> measuredSpace(const ResponseTable& table);

}  // namespace deixis::results
