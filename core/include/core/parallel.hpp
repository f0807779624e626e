// Running large work on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <future>
#include <mutex>
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

/// Work for 0 to count - 1 in `threads` threads, at least one; each takes the next number when it is done
/// with one. `workerOf(thread)` is called once in each thread, and what it gives with each number. Meanwhile
/// the caller's thread calls progress(done, count), ten times a second and at the end. Where one throws, the
/// others end after the number that they are at, and it is passed on.
template <typename WorkerOf, typename Progress>
void takeInTurn(std::size_t count, unsigned threads, const WorkerOf& workerOf, const Progress& progress) {
    std::atomic<std::size_t> next{0}, done{0};
    std::mutex mutex;
    std::condition_variable one_ended;
    unsigned at_work = std::max(1U, threads);
    std::exception_ptr failure;
    const auto run = [&](unsigned thread) {
        try {
            auto&& work = workerOf(thread);
            for (std::size_t i = next++; i < count; i = next++) {
                work(i);
                ++done;
            }
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
        const std::lock_guard lock(mutex);
        --at_work;
        one_ended.notify_one();
    };
    {
        std::vector<std::jthread> pool;
        const unsigned all = at_work;
        for (unsigned i = 0; i < all; ++i) pool.emplace_back(run, i);
        std::unique_lock lock(mutex);
        while (!one_ended.wait_for(lock, std::chrono::milliseconds(100), [&] { return at_work == 0; })) {
            lock.unlock();
            if (const std::size_t so_far = done; so_far < count) progress(so_far, count);
            lock.lock();
        }
    }
    if (failure) std::rethrow_exception(failure);
    progress(count, count);
}

}  // namespace deixis
