// Random numbers that are the same on every machine and with every compiler. The standard library's
// distributions and std::shuffle are not, so the product owns its generator, its distributions and its
// shuffle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace deixis {

/// xoshiro256** (Blackman & Vigna 2018), seeded through splitmix64. Cheap to copy; a copy repeats the same
/// numbers.
class Random {
  public:
    explicit Random(std::uint64_t seed);

    /// A generator of its own for one purpose: its numbers depend on the seed and the label alone, never on
    /// how many numbers other parts have drawn.
    Random(std::uint64_t seed, std::string_view label);

    [[nodiscard]] std::uint64_t next();                  ///< 64 random bits
    [[nodiscard]] double uniform();                      ///< [0, 1), 53 bits
    [[nodiscard]] double uniform(double a, double b);    ///< [a, b)
    [[nodiscard]] std::uint64_t below(std::uint64_t n);  ///< 0..n-1, unbiased; n > 0
    [[nodiscard]] double normal();                       ///< mean 0, SD 1 (polar method)
    [[nodiscard]] double normal(double mean, double sd) { return mean + sd * normal(); }

    /// Fisher-Yates.
    template <typename T>
    void shuffle(std::span<T> items) {
        for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
    }

  private:
    std::uint64_t state_[4];
    double spare_normal_ = 0.0;
    bool has_spare_normal_ = false;
};

/// A new seed from a seed and a label; also from several labels by nesting.
[[nodiscard]] std::uint64_t deriveSeed(std::uint64_t seed, std::string_view label);

}  // namespace deixis
