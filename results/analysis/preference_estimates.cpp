#include "preference_estimates.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "results/analysis/bradley_terry.hpp"
#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"
#include "studies/study_file/answer_curve.hpp"
#include "studies/study_file/root.hpp"

namespace deixis::results {

namespace {

using studies::PreferenceCurve;

/// Strengths and zones are sought up to this, in SDs of a difference: beyond, an answer is all but certain.
constexpr double farthest = 6.0;

struct PairAnswers {
    std::size_t first = 0, second = 0;  ///< places among the systems
    std::array<double, 5> counts{};     ///< of the answers from -2 to 2; positive: for the first
    double mean = 0.0;
    std::map<std::string, Scores> by_participant{};
};

std::vector<PairAnswers> pairsOf(const ResponseTable& table, const std::vector<std::string>& systems) {
    const auto asked = [&](const std::string& system) {
        return std::find(systems.begin(), systems.end(), system) != systems.end();
    };
    RowPointers rows;
    for (const ResponseRow& row : table.rows)
        if (asked(row.system) && asked(row.other_system)) rows.push_back(&row);
    std::vector<PairAnswers> out;
    for (const auto& [places, participants] : preferencesByPair(rows, systems)) {
        PairAnswers& pair = out.emplace_back(PairAnswers{places.first, places.second});
        Scores all;
        for (const auto& [participant, scores] : participants) {
            for (const double score : scores) ++pair.counts.at(static_cast<std::size_t>(score + 2.0));
            all.insert(all.end(), scores.begin(), scores.end());
        }
        pair.mean = mean(all);
        pair.by_participant = participants;
    }
    return out;
}

/// In SDs of a difference.
struct Cuts {
    std::vector<double> strengths;
    double tie_zone = 0.5;
    double slight_zone = 0.5;  ///< from the tie zone to clear preferences

    [[nodiscard]] PreferenceCurve curve() const { return {tie_zone, tie_zone + slight_zone}; }
    [[nodiscard]] double between(const PairAnswers& pair) const {
        return strengths[pair.first] - strengths[pair.second];
    }
};

double logLikelihood(const std::vector<PairAnswers>& pairs, const Cuts& cuts) {
    const PreferenceCurve curve = cuts.curve();
    double sum = 0.0;
    for (const PairAnswers& pair : pairs)
        for (std::size_t place = 0; place < pair.counts.size(); ++place)
            if (const double count = pair.counts[place]; count > 0.0) {
                const int answer = static_cast<int>(place) - 2;
                sum += count * std::log(std::max(1e-15, curve.probability(answer, cuts.between(pair), 1.0)));
            }
    return sum;
}

/// Where a concave function of `place` is highest; leaves `place` there, and returns how far it went.
double climb(double& place, double low, double high, const std::function<double()>& height) {
    constexpr int bits = std::numeric_limits<double>::digits / 2;  // more cannot be told of a top
    const double before = place;
    const auto depth = [&](double x) {
        place = x;
        return -height();
    };
    place = boost::math::tools::brent_find_minima(depth, low, high, bits).first;
    return std::abs(place - before);
}

/// The log-likelihood is concave, and each parameter has limits of its own: one after another leads to the
/// top.
Cuts likeliestCuts(const std::vector<PairAnswers>& pairs, std::size_t systems) {
    Cuts cuts{std::vector<double>(systems, 0.0)};
    const auto height = [&] { return logLikelihood(pairs, cuts); };
    constexpr int max_rounds = 300;
    constexpr double still = 1e-5;
    for (int round = 0; round < max_rounds; ++round) {
        double moved = 0.0;
        for (double& strength : cuts.strengths)
            moved = std::max(moved, climb(strength, -farthest, farthest, height));
        moved = std::max(moved, climb(cuts.tie_zone, 0.0, farthest, height));
        moved = std::max(moved, climb(cuts.slight_zone, 0.0, farthest, height));
        if (moved < still) break;
    }
    const double centre = mean(cuts.strengths);
    for (double& strength : cuts.strengths) strength -= centre;
    return cuts;
}

/// Two pairs, the answers of one participant to both of them.
struct SharedSystems {
    double first_location, second_location;
    double share;    ///< of the participant's part in the two differences that is the same: 1, or a half
    double product;  ///< sum of the products of the answers' deviations
    double count;    ///< of such answers
};

/// Of all pairs that have a system in common, turned so that the common part has the same sign.
std::vector<SharedSystems> sharedSystems(const std::vector<PairAnswers>& pairs, const Cuts& cuts) {
    std::vector<SharedSystems> out;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (std::size_t j = i; j < pairs.size(); ++j) {
            const PairAnswers& one = pairs[i];
            const PairAnswers& other = pairs[j];
            const int common = (one.first == other.first) + (one.second == other.second) -
                               (one.first == other.second) - (one.second == other.first);
            if (common == 0) continue;
            const double turned = common > 0 ? 1.0 : -1.0;
            SharedSystems shared{cuts.between(one), turned * cuts.between(other), 0.5 * std::abs(common), 0.0,
                                 0.0};
            for (const auto& [participant, scores] : one.by_participant) {
                const auto found = other.by_participant.find(participant);
                if (found == other.by_participant.end()) continue;
                double sum = 0.0, squares = 0.0, other_sum = 0.0;
                for (const double score : scores) {
                    sum += score - one.mean;
                    squares += (score - one.mean) * (score - one.mean);
                }
                for (const double score : found->second) other_sum += turned * (score - other.mean);
                const auto n = static_cast<double>(scores.size());
                // Of one pair, two different answers.
                shared.product += i == j ? sum * sum - squares : sum * other_sum;
                shared.count += i == j ? n * (n - 1.0) : n * static_cast<double>(found->second.size());
            }
            if (shared.count > 0.0) out.push_back(shared);
        }
    return out;
}

/// The share of a difference's variance that is the participant's own.
double participantsShare(const std::vector<SharedSystems>& all, const PreferenceCurve& curve) {
    double wanted = 0.0;
    for (const SharedSystems& one : all) wanted += one.product;
    if (wanted <= 0.0) return 0.0;
    const auto excess = [&](double share) {
        double sum = 0.0;
        for (const SharedSystems& one : all)
            sum += one.count * curve.covariance(one.first_location, one.second_location, 1.0,
                                                std::sqrt(share * one.share));
        return sum - wanted;
    };
    constexpr double max_share = 0.98;
    if (excess(max_share) <= 0.0) return max_share;
    return studies::rootBetween(0.0, max_share, 1e-12, excess);
}

}  // namespace

std::variant<studies::AssumedPreference, std::string> estimatePreference(
    const ResponseTable& table, const std::vector<std::string>& systems) {
    const std::vector<PairAnswers> pairs = pairsOf(table, systems);
    WinMatrix wins(systems.size(), std::vector<double>(systems.size(), 0.0));
    for (const PairAnswers& pair : pairs) {
        const auto& [clearly_second, second, tie, first, clearly_first] = pair.counts;
        wins[pair.first][pair.second] += first + clearly_first + 0.5 * tie;
        wins[pair.second][pair.first] += second + clearly_second + 0.5 * tie;
    }
    if (!bradleyTerryAbilities(wins))
        return "not all systems were preferred, directly or through others, to each other";
    const Cuts cuts = likeliestCuts(pairs, systems.size());
    if (cuts.tie_zone > 0.99 * farthest) return "all answers are alike";
    const double share = participantsShare(sharedSystems(pairs, cuts), cuts.curve());
    // The variance of a difference: two own parts of the participant and noise, which is 1.
    const double sd = 1.0 / std::sqrt(1.0 - share);
    studies::AssumedPreference out;
    for (std::size_t i = 0; i < systems.size(); ++i) out.systems[systems[i]] = sd * cuts.strengths[i];
    out.participant_system_sd = sd * std::sqrt(0.5 * share);
    out.noise_sd = 1.0;
    out.tie_zone = sd * cuts.tie_zone;
    out.clear_zone = sd * (cuts.tie_zone + cuts.slight_zone);
    return out;
}

}  // namespace deixis::results
