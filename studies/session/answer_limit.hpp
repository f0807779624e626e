// The time limit of an answer, and what the participant is told of it.
#pragma once

#include <string>

#include "studies/texts/language.hpp"

namespace deixis::studies {

class AnswerLimit {
  public:
    static constexpr double told_s = 1.0;  ///< how long it is told that the time is up

    explicit AnswerLimit(double limit_s) : limit_s_(limit_s) {}  ///< 0: there is none

    /// Whether an answer that took so long is in time.
    [[nodiscard]] bool admits(double taken_s) const { return limit_s_ <= 0.0 || taken_s <= limit_s_; }
    /// Whether the time is up; else counts down what is told.
    [[nodiscard]] bool passed(double taken_s);
    /// Nothing is told any more: it was answered, or starts over.
    void forget() { seconds_left_ = 0; }
    [[nodiscard]] std::string notice(const LanguageTable& words, bool done, bool timed_out) const;

  private:
    double limit_s_;
    int seconds_left_ = 0;  ///< told to the participant; 0: nothing is
};

}  // namespace deixis::studies
