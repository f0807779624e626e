// Processor time, which other work on the machine does not lengthen, and medians.
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

namespace deixis::bench {

inline double secondsOn(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// Of all the program's threads.
inline double processorSeconds() {
    return secondsOn(CLOCK_PROCESS_CPUTIME_ID);
}
/// Of this thread.
inline double threadSeconds() {
    return secondsOn(CLOCK_THREAD_CPUTIME_ID);
}

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace deixis::bench
