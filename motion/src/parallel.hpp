// Long clips on all cores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace deixis::motion {

/// Calls work(first, last) for ranges of frames, `last` not included, that together are 0 to count - 1: one
/// range of a short clip, of a long one several at the same time. What `work` does to one frame must not hang
/// on another.
template <typename Work>
void forFrames(std::size_t count, const Work& work) {
    constexpr std::size_t worth_a_thread = 2000;
    const std::size_t parts =
        std::clamp<std::size_t>(count / worth_a_thread, 1, std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::future<void>> others;
    for (std::size_t i = 1; i < parts; ++i)
        others.push_back(std::async(std::launch::async, [&work, i, count, parts] {
            work(count * i / parts, count * (i + 1) / parts);
        }));
    work(0, count / parts);
    for (auto& other : others) other.get();
}

}  // namespace deixis::motion
