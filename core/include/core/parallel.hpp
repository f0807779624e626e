// Running large work on all cores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace deixis {

/// What work(first, last) gives for ranges, `last` not included, that together are 0 to count - 1, in their
/// order: one range where there are fewer than twice `worth_a_thread`, else as many as there are cores at the
/// most, at the same time. What `work` does to one must not hang on another. Passes on what `work` throws.
template <typename Work>
auto mapRanges(std::size_t count, std::size_t worth_a_thread, const Work& work) {
    const std::size_t parts =
        std::clamp<std::size_t>(count / worth_a_thread, 1, std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::future<decltype(work(count, count))>> others;
    for (std::size_t i = 1; i < parts; ++i)
        others.push_back(std::async(std::launch::async, [&work, i, count, parts] {
            return work(count * i / parts, count * (i + 1) / parts);
        }));
    std::vector<decltype(work(count, count))> results;
    results.push_back(work(0, count / parts));
    for (auto& other : others) results.push_back(other.get());
    return results;
}

/// Likewise, of work that gives nothing.
template <typename Work>
void forRanges(std::size_t count, std::size_t worth_a_thread, const Work& work) {
    mapRanges(count, worth_a_thread, [&](std::size_t first, std::size_t last) {
        work(first, last);
        return true;
    });
}

}  // namespace deixis
