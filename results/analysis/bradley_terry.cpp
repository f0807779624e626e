#include "results/analysis/bradley_terry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

using Reached = std::vector<bool>;

/// The systems that `from` is linked to, itself included, where linked(i, j) says so of single steps.
template <typename Linked>
Reached reachedFrom(std::size_t from, std::size_t systems, Linked linked) {
    Reached reached(systems, false);
    std::vector<std::size_t> open{from};
    reached[from] = true;
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        for (std::size_t j = 0; j < systems; ++j)
            if (!reached[j] && linked(i, j)) {
                reached[j] = true;
                open.push_back(j);
            }
    }
    return reached;
}

bool reachesAll(const Reached& reached) {
    return std::all_of(reached.begin(), reached.end(), [](bool one) { return one; });
}

/// From the first system to all along wins, and along losses: then from each to each.
bool hasMaximum(const WinMatrix& wins) {
    return reachesAll(reachedFrom(0, wins.size(), [&](auto i, auto j) { return wins[i][j] > 0.0; })) &&
           reachesAll(reachedFrom(0, wins.size(), [&](auto i, auto j) { return wins[j][i] > 0.0; }));
}

std::string namesOf(const Reached& chosen, bool wanted, const std::vector<Ability>& abilities) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] == wanted) names.push_back(abilities[i].system);
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Why there is no maximum.
std::string whyNone(const WinMatrix& wins, const std::vector<Ability>& abilities) {
    const std::size_t n = wins.size();
    const Reached joined =
        reachedFrom(0, n, [&](auto i, auto j) { return wins[i][j] > 0.0 || wins[j][i] > 0.0; });
    if (!reachesAll(joined))
        return fmt::format(
            "{} were never compared with {}, directly or through others: abilities have no common scale",
            namesOf(joined, true, abilities), namesOf(joined, false, abilities));
    // The fewest systems that nobody else was ever preferred to.
    std::optional<Reached> best;
    for (std::size_t i = 0; i < n; ++i) {
        const Reached above = reachedFrom(i, n, [&](auto a, auto b) { return wins[b][a] > 0.0; });
        if (!best ||
            std::count(above.begin(), above.end(), true) < std::count(best->begin(), best->end(), true))
            best = above;
    }
    return fmt::format(
        "no answer preferred {} to {} or rated them equal: the difference in ability is unbounded",
        namesOf(*best, false, abilities), namesOf(*best, true, abilities));
}

WinMatrix emptyWins(std::size_t systems) {
    return WinMatrix(systems, std::vector<double>(systems, 0.0));
}

void addWins(WinMatrix& sum, const WinMatrix& wins) {
    for (std::size_t i = 0; i < sum.size(); ++i)
        for (std::size_t j = 0; j < sum.size(); ++j) sum[i][j] += wins[i][j];
}

void addNote(BradleyTerry& out, const std::string& more) {
    out.note += (out.note.empty() ? "" : "; ") + more;
}

/// By system the influence of each participant on its ability; none where the others' answers alone have no
/// finite abilities.
std::optional<std::vector<std::vector<double>>> abilityInfluences(
    const std::vector<WinMatrix>& by_participant, const std::vector<double>& estimates) {
    std::vector<std::vector<double>> without(estimates.size());
    for (std::size_t left_out = 0; left_out < by_participant.size(); ++left_out) {
        WinMatrix sum = emptyWins(estimates.size());
        for (std::size_t i = 0; i < by_participant.size(); ++i)
            if (i != left_out) addWins(sum, by_participant[i]);
        const auto abilities = bradleyTerryAbilities(sum, estimates);
        if (!abilities) return std::nullopt;
        for (std::size_t i = 0; i < estimates.size(); ++i) without[i].push_back((*abilities)[i]);
    }
    for (std::vector<double>& of_system : without) {
        const double centre = mean(of_system);
        for (double& one : of_system) one = centre - one;
    }
    return without;
}

void addCorrectedIntervals(const std::vector<std::vector<double>>& resampled,
                           const std::vector<WinMatrix>& by_participant, const std::vector<double>& estimates,
                           double level, BradleyTerry& out) {
    const auto of_participants = abilityInfluences(by_participant, estimates);
    if (!of_participants) {
        addNote(out,
                "without one of the participants there are no finite abilities: BCa intervals are not "
                "defined, only percentiles are given");
        return;
    }
    // Abilities that are equal on paper are so to what the iteration leaves open.
    constexpr double allowance = 1e-9;
    std::vector<std::string> undefined;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        out.abilities[i].bca = correctedInterval(
            resampled[i], estimates[i], bootstrapAcceleration((*of_participants)[i]), allowance, level);
        if (!out.abilities[i].bca) undefined.push_back(out.abilities[i].system);
    }
    if (!undefined.empty())
        addNote(out, fmt::format("the resampled abilities of {} lie on one side of the estimate: their BCa "
                                 "intervals are not defined, only percentiles are given",
                                 fmt::join(undefined, ", ")));
}

/// Fills in intervals and what was left out.
void resampleParticipants(const std::vector<WinMatrix>& by_participant, const std::vector<double>& estimates,
                          const BootstrapOptions& options, BradleyTerry& out) {
    const std::size_t systems = estimates.size();
    std::vector<std::vector<double>> resampled(systems);
    Random random(options.seed, "bootstrap");
    for (int b = 0; b < options.resamples; ++b) {
        WinMatrix sum = emptyWins(systems);
        for (std::size_t drawn = 0; drawn < by_participant.size(); ++drawn)
            addWins(sum, by_participant[random.below(by_participant.size())]);
        const auto abilities = bradleyTerryAbilities(sum, estimates);
        if (!abilities) {
            ++out.resamples_left_out;
            continue;
        }
        for (std::size_t i = 0; i < systems; ++i) resampled[i].push_back((*abilities)[i]);
    }
    if (out.resamples_left_out > 0)
        addNote(
            out,
            fmt::format(
                "{} of {} resamples have no finite abilities and are skipped: the intervals are too narrow",
                out.resamples_left_out, options.resamples));
    if (out.resamples_left_out == options.resamples) return;
    const double tail = 0.5 * (1.0 - options.level);
    for (std::size_t i = 0; i < systems; ++i) {
        std::sort(resampled[i].begin(), resampled[i].end());
        out.abilities[i].percentile =
            BootstrapInterval{quantile(resampled[i], tail), quantile(resampled[i], 1.0 - tail)};
    }
    addCorrectedIntervals(resampled, by_participant, estimates, options.level, out);
}

}  // namespace

std::optional<std::vector<double>> bradleyTerryAbilities(const WinMatrix& wins,
                                                         const std::vector<double>& start) {
    const std::size_t n = wins.size();
    if (n == 0 || !hasMaximum(wins)) return std::nullopt;
    std::vector<double> ability = start.empty() ? std::vector<double>(n, 0.0) : start;
    std::vector<double> strength(n);
    constexpr int max_rounds = 100'000;
    constexpr double still = 1e-12;
    for (int round = 0; round < max_rounds; ++round) {
        for (std::size_t i = 0; i < n; ++i) strength[i] = std::exp(ability[i]);
        double moved = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            double won = 0.0;
            double weight = 0.0;
            for (std::size_t j = 0; j < n; ++j) {
                if (j == i) continue;
                won += wins[i][j];
                weight += (wins[i][j] + wins[j][i]) / (strength[i] + strength[j]);
            }
            const double next = std::log(won / weight);
            moved = std::max(moved, std::abs(next - ability[i]));
            ability[i] = next;
            sum += next;
        }
        for (double& one : ability) one -= sum / static_cast<double>(n);
        if (moved <= still) break;
    }
    return ability;
}

BradleyTerry bradleyTerry(const ResponseTable& table, const BootstrapOptions& options) {
    BradleyTerry out;
    std::map<std::string, std::size_t> place;
    for (const std::string& system : table.systems)
        if (std::any_of(table.rows.begin(), table.rows.end(), [&](const ResponseRow& row) {
                return !row.other_system.empty() && (row.system == system || row.other_system == system);
            })) {
            place.emplace(system, out.abilities.size());
            out.abilities.push_back({system});
        }
    const std::size_t systems = out.abilities.size();
    if (systems == 0) return out;

    std::map<std::string, WinMatrix> by_participant;
    std::map<std::pair<std::size_t, std::size_t>, PairCount> pairs;
    for (const ResponseRow& row : table.rows) {
        if (row.other_system.empty()) continue;
        const std::size_t left = place.at(row.system);
        const std::size_t right = place.at(row.other_system);
        auto& wins = by_participant.try_emplace(row.participant, emptyWins(systems)).first->second;
        const auto [first, second] = std::minmax(left, right);
        PairCount& pair = pairs[{first, second}];
        if (row.value == 0.0) {
            wins[left][right] += 0.5;
            wins[right][left] += 0.5;
            ++out.abilities[left].ties;
            ++out.abilities[right].ties;
            ++pair.ties;
            continue;
        }
        const std::size_t winner = row.value > 0.0 ? right : left;
        const std::size_t loser = row.value > 0.0 ? left : right;
        wins[winner][loser] += 1.0;
        ++out.abilities[winner].wins;
        ++out.abilities[loser].losses;
        ++(winner == first ? pair.prefers_a : pair.prefers_b);
    }
    for (auto& [systems_compared, pair] : pairs) {
        pair.a = out.abilities[systems_compared.first].system;
        pair.b = out.abilities[systems_compared.second].system;
        out.pairs.push_back(std::move(pair));
    }
    out.participants = static_cast<int>(by_participant.size());

    WinMatrix sum = emptyWins(systems);
    std::vector<WinMatrix> each;
    for (const auto& [participant, wins] : by_participant) {
        addWins(sum, wins);
        each.push_back(wins);
    }
    // What is drawn does not depend on how participants are called.
    std::sort(each.begin(), each.end());
    const auto estimates = bradleyTerryAbilities(sum);
    if (!estimates) {
        out.note = whyNone(sum, out.abilities);
        return out;
    }
    for (std::size_t i = 0; i < systems; ++i) out.abilities[i].estimate = (*estimates)[i];
    if (each.size() > 1) resampleParticipants(each, *estimates, options, out);
    return out;
}

}  // namespace deixis::results
