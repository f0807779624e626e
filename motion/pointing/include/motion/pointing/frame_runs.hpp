// Runs of frames in which a condition holds.
#pragma once

#include <vector>

namespace deixis::motion {

/// Frames, both ends in.
struct Run {
    int begin = 0;
    int end = 0;
    [[nodiscard]] int frames() const { return end - begin + 1; }
};

/// The longest runs of the frames `first` to `last` for which `holds` is true.
template <typename Holds>
[[nodiscard]] std::vector<Run> runsOf(int first, int last, const Holds& holds) {
    std::vector<Run> runs;
    for (int f = first; f <= last; ++f) {
        if (!holds(f)) continue;
        if (!runs.empty() && runs.back().end == f - 1)
            runs.back().end = f;
        else
            runs.push_back({f, f});
    }
    return runs;
}

}  // namespace deixis::motion
