// The exact signed-rank test with ties, against the normal approximation and the enumeration of all signs.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "results/statistics.hpp"

namespace {

using namespace deixis;

/// Differences of shares of ten answers: none zero, many tied.
std::vector<double> tiedDifferences(int count) {
    Random random(39, "tied differences");
    std::vector<double> out;
    for (int i = 0; i < count; ++i) {
        const double size = 0.1 * static_cast<double>(1 + random.below(6));
        out.push_back(random.uniform() < 0.6 ? size : -size);
    }
    return out;
}

struct SignedRanks {
    std::vector<double> midranks;
    double w_plus = 0.0;
    double ties = 0.0;  ///< sum of t^3 - t
};

SignedRanks rank(const std::vector<double>& differences) {
    std::vector<double> sizes;
    for (const double d : differences) sizes.push_back(std::round(std::abs(d) * 1e9));
    std::vector<double> sorted = sizes;
    std::sort(sorted.begin(), sorted.end());
    SignedRanks out;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), sizes[i]);
        const auto tied = static_cast<double>(high - low);
        out.midranks.push_back(static_cast<double>(low - sorted.begin()) + (tied + 1.0) / 2.0);
        out.ties += tied * tied - 1.0;  // once for each of the tied
        if (differences[i] > 0.0) out.w_plus += out.midranks.back();
    }
    return out;
}

double approximateP(const std::vector<double>& differences) {
    const SignedRanks ranks = rank(differences);
    const auto n = static_cast<double>(differences.size());
    const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ranks.ties / 48.0;
    const double distance = std::max(0.0, std::abs(ranks.w_plus - n * (n + 1.0) / 4.0) - 0.5);
    return std::min(1.0, std::erfc(distance / std::sqrt(2.0 * variance)));
}

double enumeratedP(const std::vector<double>& differences) {
    const SignedRanks ranks = rank(differences);
    const std::uint32_t patterns = 1U << differences.size();
    const auto n = static_cast<double>(differences.size());
    const double centre = n * (n + 1.0) / 4.0;
    std::uint32_t as_far = 0;
    for (std::uint32_t pattern = 0; pattern < patterns; ++pattern) {
        double w = 0.0;
        for (std::size_t i = 0; i < ranks.midranks.size(); ++i)
            if ((pattern >> i & 1U) != 0U) w += ranks.midranks[i];
        if (std::abs(w - centre) >= std::abs(ranks.w_plus - centre)) ++as_far;
    }
    return static_cast<double>(as_far) / static_cast<double>(patterns);
}

void exact(benchmark::State& state) {
    const auto differences = tiedDifferences(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(results::signedRankTest(differences).p);
}
BENCHMARK(exact)->Name("signed_rank/exact_with_ties")->Arg(39)->Arg(16)->Unit(benchmark::kMicrosecond);

using Peer = double (*)(const std::vector<double>&);

/// A peer must agree with the product within `tolerance`, or its time says nothing.
void peer(benchmark::State& state, Peer peer_p, double tolerance) {
    const auto differences = tiedDifferences(static_cast<int>(state.range(0)));
    if (std::abs(peer_p(differences) - results::signedRankTest(differences).p) > tolerance)
        return state.SkipWithError("the peer finds another p");
    for (auto _ : state) benchmark::DoNotOptimize(peer_p(differences));
}
BENCHMARK_CAPTURE(peer, approximation, approximateP, 0.02)
    ->Name("signed_rank/peer_normal_approximation")
    ->Arg(39)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(peer, enumeration, enumeratedP, 1e-12)
    ->Name("signed_rank/peer_enumeration")
    ->Arg(16)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
