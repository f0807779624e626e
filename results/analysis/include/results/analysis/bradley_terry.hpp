// Abilities of systems from preferences between pairs (Bradley & Terry 1952).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/answers/response_table.hpp"
#include "results/statistics/bootstrap.hpp"

namespace deixis::results {

/// wins[i][j]: how often i was preferred to j; half a win each for a tie.
using WinMatrix = std::vector<std::vector<double>>;

/// Maximum likelihood of P(i preferred to j) = 1 / (1 + exp(b_j - b_i)): the b, with sum 0. By Hunter's
/// (2004) MM algorithm, from `start` where it is given. None if there is no finite maximum: unless every
/// system is preferred, directly or through others, to every other one (Ford 1957), a difference grows
/// without bound.
[[nodiscard]] std::optional<std::vector<double>> bradleyTerryAbilities(const WinMatrix& wins,
                                                                       const std::vector<double>& start = {});

struct Ability {
    std::string system;
    std::optional<double> estimate{};               ///< log odds scale; the mean of all is 0
    std::optional<BootstrapInterval> percentile{};  ///< participants are resampled
    /// Bias-corrected and accelerated. None if there are no finite abilities without one of the
    /// participants, or where all or none of the resampled abilities lie below the estimate; the note says
    /// so.
    std::optional<BootstrapInterval> bca{};
    int wins = 0, ties = 0, losses = 0;
};

/// Answers of one pair, over participants.
struct PairCount {
    std::string a, b;
    int prefers_a = 0, ties = 0, prefers_b = 0;
};

/// "Clearly" and "slightly" count alike.
struct BradleyTerry {
    std::vector<Ability>
        abilities{};                 ///< of the systems compared, in the study's order; empty: no preferences
    std::vector<PairCount> pairs{};  ///< compared at least once
    int participants = 0;
    /// Resamples in which there are no finite abilities; they are skipped, so intervals are too narrow.
    int resamples_left_out = 0;
    std::string note{};  ///< why there are no abilities, or what is wrong with the intervals; may be empty
};

[[nodiscard]] BradleyTerry bradleyTerry(const ResponseTable& table, const BootstrapOptions& options);

}  // namespace deixis::results
