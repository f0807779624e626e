#include "core/parallel.hpp"

#include <doctest/doctest.h>

#include <set>
#include <stdexcept>

using namespace deixis;

TEST_SUITE("core/parallel") {
    TEST_CASE("every number is taken once, whatever the threads, and progress ends with all") {
        for (const unsigned threads : {0U, 1U, 3U, 8U})
            for (const std::size_t count : {0U, 1U, 5U, 1000U}) {
                std::vector<int> taken(count, 0);
                std::set<unsigned> workers;
                std::mutex mutex;
                std::size_t last_done = 0, last_of = 1;
                takeInTurn(
                    count, threads,
                    [&](unsigned thread) {
                        const std::lock_guard lock(mutex);
                        CHECK(workers.insert(thread).second);
                        return [&](std::size_t i) { ++taken[i]; };
                    },
                    [&](std::size_t done, std::size_t of) {
                        CHECK(done >= last_done);
                        last_done = done;
                        last_of = of;
                    });
                CHECK(taken == std::vector<int>(count, 1));
                CHECK(workers.size() == std::max(1U, threads));
                CHECK(last_done == count);
                CHECK(last_of == count);
            }
    }

    TEST_CASE("what one throws is passed on, and the others do not go on to the end") {
        std::atomic<std::size_t> done{0};
        const auto workerOf = [&](unsigned) {
            return [&](std::size_t i) {
                if (i == 3) throw std::runtime_error("the third");
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                ++done;
            };
        };
        CHECK_THROWS_WITH(takeInTurn(5000, 2, workerOf, [](std::size_t, std::size_t) {}), "the third");
        CHECK(done < 4000);
    }
}
