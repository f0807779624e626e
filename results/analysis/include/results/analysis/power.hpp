// Power by simulation: whole studies are drawn from assumed effects on the real plans, with the report's
// own tests on each. The answers are simulated and no evidence about people. Conventions: docs/power.md.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/statistics/proportion.hpp"
#include "studies/design/targets.hpp"
#include "studies/study_file/assumed_effects.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::results {

struct PowerOptions {
    int studies = 1000;             ///< drawn for each number of participants; at least 1
    std::uint64_t seed = 1;         ///< of the answers; the plans have the study's
    std::optional<double> alpha{};  ///< none: the study's
    double level = 0.95;            ///< of the intervals of the power
    unsigned threads = 1;           ///< the numbers do not depend on it
};

/// In how many of the studies drawn a difference was significant, and which way.
struct Found {
    int a_higher = 0;
    int b_higher = 0;

    [[nodiscard]] int either() const { return a_higher + b_higher; }
};

/// One test of the analysis: after Holm's correction in its family.
struct ContrastPower {
    std::string family;
    std::string measure;
    std::string system{};  ///< a and b are levels within this one; empty: they are systems
    std::string a, b;
    std::map<int, Found> found{};  ///< by number of participants
};

/// All tests that Holm's correction takes together.
struct FamilyPower {
    std::string name;
    int tests = 0;
    std::map<int, int> any{};  ///< studies in which at least one of them was significant
    std::map<int, int> all{};  ///< and in which all were
};

struct PowerResult {
    std::string study_name;
    std::string study_hash;
    PowerOptions options;
    double alpha = 0.01;
    std::vector<std::string> not_simulated{};  ///< measures of which nothing is assumed
    std::vector<int> participants{};           ///< simulated so far, ascending
    std::vector<ContrastPower> contrasts{};
    std::vector<FamilyPower> families{};

    /// Of `count` among the studies drawn: exact interval (Clopper & Pearson).
    [[nodiscard]] Proportion share(int count) const;
};

/// Called from the thread that asked, again and again while it waits, and once with done == all.
using PowerProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Draws studies. Study k of a seed is the same whatever else is asked for, and with fewer participants the
/// beginning of the same one: powers of different sizes rise and fall together.
class PowerAnalysis {
  public:
    /// Fails if a plan cannot be built. Groups are assigned as they are to participants who come in turn,
    /// of whom none drops out.
    [[nodiscard]] static Result<PowerAnalysis> make(const studies::Study& study,
                                                    const std::vector<studies::TargetItem>& targets,
                                                    const studies::AssumedEffects& effects,
                                                    int max_participants, const PowerOptions& options);
    PowerAnalysis(PowerAnalysis&&) noexcept;
    ~PowerAnalysis();

    /// Adds these numbers of participants, from 1 to the most, to the result; those that are there already
    /// cost nothing.
    void simulate(const std::vector<int>& participants, const PowerProgress& progress);
    [[nodiscard]] const PowerResult& result() const;

  private:
    struct Impl;
    explicit PowerAnalysis(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// The smallest of the numbers simulated whose estimated power reaches `goal`; none if none does.
[[nodiscard]] std::optional<int> participantsFor(const PowerResult& result, const ContrastPower& contrast,
                                                 double goal);
/// Simulates between the numbers simulated so far, halving, until for each contrast the smallest number that
/// reaches `goal` lies one above a number that does not. Power is taken to rise with participants.
void searchParticipants(PowerAnalysis& analysis, double goal, const PowerProgress& progress);

/// For people: a table a family. `goal`: with the participants that it needs.
[[nodiscard]] std::string powerText(const PowerResult& result, std::optional<double> goal);
/// One object; keys in docs/power.md. The same result gives the same bytes.
[[nodiscard]] std::string powerJson(const PowerResult& result, std::optional<double> goal);
/// One line for each contrast and number of participants.
[[nodiscard]] std::string powerCsv(const PowerResult& result);

}  // namespace deixis::results
