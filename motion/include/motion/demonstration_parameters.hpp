// Parameters of the synthetic demonstrations; assets/data/demonstrations.toml holds the values and marks
// where each comes from.
#pragma once

#include <cstdint>

namespace deixis::motion {

struct DemonstrationParameters {
    std::uint64_t library_seed = 1;
    int left_count = 25;
    int right_count = 27;
};

}  // namespace deixis::motion
