#include "attention_checks.hpp"

#include <fmt/core.h>

#include <cmath>

#include "session_unit.hpp"

namespace deixis::studies {

namespace {

constexpr double rounding = 1e-9;

}  // namespace

std::optional<double> TrialAnswer::value(std::string_view question, int stimulus) const {
    for (const Answer& answer : response.answers)
        if (answer.question == question && answer.stimulus == stimulus) return answer.value;
    return std::nullopt;
}

CheckResult compareNumbers(double first, double now, double tolerance) {
    return {std::abs(now - first) <= tolerance + rounding,
            fmt::format("repeat: {} first, {} now", first, now)};
}

CheckResult compareRatings(const TrialAnswer& first, const TrialAnswer& now, double tolerance) {
    CheckResult result;
    for (std::size_t i = 0; i < now.trial.stimuli.size(); ++i)
        for (std::size_t j = 0; j < first.trial.stimuli.size(); ++j) {
            if (now.trial.stimuli[i] != first.trial.stimuli[j]) continue;
            const auto again = now.value("rating", static_cast<int>(i));
            const auto before = first.value("rating", static_cast<int>(j));
            if (!again || !before) continue;
            CheckResult one = compareNumbers(*before, *again, tolerance);
            if (result.passed) result = std::move(one);
        }
    return result;
}

CheckScorer::CheckScorer(const Study& study, const StudyPlan& plan, const Resume& resume)
    : study_(study), plan_(plan), earlier_failures_(resume.check_failures) {
    for (const Response& response : resume.first_answers) kept_[response.trial_index] = response;
}

const Trial& CheckScorer::trialOf(int index) const {
    return plan_.trials.at(static_cast<std::size_t>(index));
}

const AttentionChecks* CheckScorer::checksOf(const Trial& trial) const {
    const Stage* stage = study_.findStage(trial.stage);
    if (stage == nullptr || !trial.check) return nullptr;
    for (const AttentionChecks& checks : stage->checks)
        if (checks.kind == trial.check->kind) return &checks;
    return nullptr;
}

std::optional<CheckResult> CheckScorer::score(const Response& response) const {
    const Trial& trial = trialOf(response.trial_index);
    if (!trial.check || response.status == ResponseStatus::skipped) return std::nullopt;
    const AttentionChecks* checks = checksOf(trial);
    const double tolerance = checks != nullptr ? checks->tolerance : 0.0;
    const double expected = trial.check->expected;
    switch (trial.check->kind) {
        case CheckKind::number: {
            const auto given = TrialAnswer{trial, response}.value("rating", trial.check->stimulus);
            if (!given) return std::nullopt;
            return CheckResult{std::abs(*given - expected) <= tolerance + rounding,
                               fmt::format("number: {} expected, {} given", expected, *given)};
        }
        case CheckKind::catch_trial:
            return CheckResult{response.correct(), "catch"};
        case CheckKind::repeat: {
            const auto first = kept_.find(trial.check->of_trial);
            const bool comparable = first != kept_.end() &&
                                    first->second.status == ResponseStatus::answered &&
                                    response.status == ResponseStatus::answered;
            if (!comparable || unitOf(trial.kind).compare == nullptr) return std::nullopt;
            return unitOf(trial.kind)
                .compare({trialOf(trial.check->of_trial), first->second}, {trial, response}, tolerance);
        }
    }
    return std::nullopt;
}

void CheckScorer::keep(const Response& response) {
    kept_[response.trial_index] = response;
    if (response.check_passed) results_[response.trial_index] = *response.check_passed;
}

void CheckScorer::forget(int trial) {
    kept_.erase(trial);
    results_.erase(trial);
}

CheckRule CheckScorer::ruleFor(const Trial& trial) const {
    const AttentionChecks* checks = checksOf(trial);
    if (checks == nullptr) return CheckRule::note;
    const auto earlier = earlier_failures_.find({trial.stage, checks->kind});
    int failures = earlier != earlier_failures_.end() ? earlier->second : 0;
    for (const auto& [index, passed] : results_)
        if (!passed && trialOf(index).stage == trial.stage && trialOf(index).check->kind == checks->kind)
            ++failures;
    return failures >= checks->after_failures ? checks->rule : CheckRule::note;
}

int CheckScorer::passed() const {
    int count = 0;
    for (const auto& result : results_)
        if (result.second) ++count;
    return count;
}

int CheckScorer::failed() const {
    int count = static_cast<int>(results_.size()) - passed();
    for (const auto& earlier : earlier_failures_) count += earlier.second;
    return count;
}

}  // namespace deixis::studies
