// A clip trial whose answer may have a time limit, and after which the practice may show what was right.
#pragma once

#include "answer_limit.hpp"
#include "clip_trial.hpp"

namespace deixis::studies {

class TimedTrial : public ClipTrial {
  public:
    /// `feedback_s`: how long what was right is shown, where the stage shows it.
    TimedTrial(SessionCore& core, const TimelineItem& item, double feedback_s);
    [[nodiscard]] bool stepDone(const InputFrame& input, double since_s) override;
    void resumeDone(const InputFrame& input) override;

  protected:
    AnswerLimit limit_;
    bool revealed_ = false;  ///< what was right is shown

    [[nodiscard]] bool late() const { return draft_.status == ResponseStatus::timed_out; }
    [[nodiscard]] bool inTime(double at_s) const { return limit_.admits(taken_s(at_s)); }
    /// Ends the trial without an answer once the time is up.
    void watchTime(const InputFrame& input);
    void finish();
    /// Where the answer is aimed at a ball: shows that none is met yet.
    void beginAiming();
    /// What the ray meets; shows when it comes on a ball or leaves it.
    Aim aimAtBalls(const InputFrame& input);
    /// Shows what was answered and, where it is revealed, what was right.
    virtual void showDone() = 0;

  private:
    double feedback_s_;
    bool aiming_ = false;  ///< the ray is on a ball

    [[nodiscard]] double taken_s(double at_s) const {
        return at_s - draft_.motion_end.time_s - draft_.paused_s;
    }
};

}  // namespace deixis::studies
