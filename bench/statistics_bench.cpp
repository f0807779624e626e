// The exact signed-rank test with ties, against the enumeration of all signs and the normal approximation;
// the other tests on samples as studies have them. bench/statistics_peers.sh times R and SciPy beside them.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "results/statistics/bootstrap.hpp"
#include "results/statistics/rank_sum.hpp"
#include "results/statistics/signed_rank.hpp"

namespace {

using namespace deixis;
using results::Rational;

/// Differences of shares of ten answers: none zero, many tied.
std::vector<Rational> tiedDifferences(int count) {
    Random random(39, "tied differences");
    std::vector<Rational> out;
    for (int i = 0; i < count; ++i) {
        const auto size = static_cast<std::int64_t>(1 + random.below(6));
        out.emplace_back(random.uniform() < 0.6 ? size : -size, 10);
    }
    return out;
}

double enumeratedP(const std::vector<Rational>& differences) {
    std::vector<double> midranks;
    double w_plus = 0.0;
    for (const Rational& d : differences) {
        double rank = 0.5;
        for (const Rational& other : differences)
            rank += abs(other) < abs(d) ? 1.0 : abs(other) == abs(d) ? 0.5 : 0.0;
        midranks.push_back(rank);
        if (d.sign() > 0) w_plus += rank;
    }
    const std::uint32_t patterns = 1U << differences.size();
    const auto n = static_cast<double>(differences.size());
    const double centre = n * (n + 1.0) / 4.0;
    std::uint32_t as_far = 0;
    for (std::uint32_t pattern = 0; pattern < patterns; ++pattern) {
        double w = 0.0;
        for (std::size_t i = 0; i < midranks.size(); ++i)
            if ((pattern >> i & 1U) != 0U) w += midranks[i];
        if (std::abs(w - centre) >= std::abs(w_plus - centre)) ++as_far;
    }
    return static_cast<double>(as_far) / static_cast<double>(patterns);
}

void exact(benchmark::State& state) {
    const auto differences = tiedDifferences(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(results::signedRankTest(differences).p_two_sided);
}
BENCHMARK(exact)
    ->Name("signed_rank/exact_with_ties")
    ->Arg(16)
    ->Arg(39)
    ->Arg(1000)
    ->Arg(2000)
    ->Unit(benchmark::kMicrosecond);

/// The peer must agree with the product, or its time says nothing.
void enumeration(benchmark::State& state) {
    const auto differences = tiedDifferences(static_cast<int>(state.range(0)));
    if (std::abs(enumeratedP(differences) - results::signedRankTest(differences).p_two_sided) > 1e-12)
        return state.SkipWithError("the peer finds another p");
    for (auto _ : state) benchmark::DoNotOptimize(enumeratedP(differences));
}
BENCHMARK(enumeration)->Name("signed_rank/peer_enumeration")->Arg(16)->Unit(benchmark::kMicrosecond);

void rankSum(benchmark::State& state) {
    const auto a = tiedDifferences(static_cast<int>(state.range(0)));
    auto b = a;
    for (Rational& value : b) value += Rational(1, 10);
    for (auto _ : state) benchmark::DoNotOptimize(results::rankSumTest(a, b).p_two_sided);
}
BENCHMARK(rankSum)->Name("rank_sum/exact_with_ties")->Arg(39)->Arg(200)->Unit(benchmark::kMillisecond);

void bootstrap(benchmark::State& state) {
    Random random(39, "scores");
    std::vector<std::vector<double>> rows(39, std::vector<double>(4));
    for (auto& row : rows)
        for (double& value : row) value = random.normal(3.0, 0.5);
    for (auto _ : state)
        benchmark::DoNotOptimize(results::bootstrapMeans(rows, {.resamples = 10000}).front().se);
    state.counters["limit_ms"] = 10;
}
BENCHMARK(bootstrap)->Name("bootstrap/10000_of_39_x_4")->Unit(benchmark::kMillisecond);

}  // namespace
