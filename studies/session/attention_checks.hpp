// Attention checks: whether an answer passes, and what the study wants when too many do not.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/session/session.hpp"

namespace deixis::studies {

/// How an answer did in its trial's check.
struct CheckResult {
    bool passed = true;
    std::string what{};  ///< "number: 73 expected, 50 given"
};

/// A trial with its answer.
struct TrialAnswer {
    const Trial& trial;
    const Response& response;

    /// Of a question (about a stimulus; -1: about none); none where it was not given.
    [[nodiscard]] std::optional<double> value(std::string_view question, int stimulus = -1) const;
};

/// Two answers with a number, against a tolerance.
[[nodiscard]] CheckResult compareNumbers(double first, double now, double tolerance);
/// Every stimulus's rating against that of the first time, wherever the stimulus stood: the first that
/// differs.
[[nodiscard]] CheckResult compareRatings(const TrialAnswer& first, const TrialAnswer& now, double tolerance);

class CheckScorer {
  public:
    /// Study and plan must outlive it.
    CheckScorer(const Study& study, const StudyPlan& plan, const Resume& resume);

    /// None where the trial is no check, was not answered, or repeats one whose answer is not known.
    [[nodiscard]] std::optional<CheckResult> score(const Response& response) const;
    /// Keeps an answer, with the result of its check.
    void keep(const Response& response);
    void forget(int trial);  ///< it is done again

    /// What is to be done about a failed check, given all failures of its kind in its stage so far; note:
    /// nothing.
    [[nodiscard]] CheckRule ruleFor(const Trial& trial) const;
    [[nodiscard]] int passed() const;
    [[nodiscard]] int failed() const;

  private:
    const Study& study_;
    const StudyPlan& plan_;
    std::map<std::pair<std::string, CheckKind>, int> earlier_failures_;  ///< of other sessions
    std::map<int, Response> kept_{};  ///< by trial, with those of `Resume::first_answers`
    std::map<int, bool> results_{};   ///< by trial, of this session

    [[nodiscard]] const AttentionChecks* checksOf(const Trial& trial) const;
    [[nodiscard]] const Trial& trialOf(int index) const;
};

}  // namespace deixis::studies
