// A trial with one clip: a pause in which the avatar stands at ease, the clip, then the answer. Rating and
// game say what the answer is.
#pragma once

#include <cstdint>
#include <string>

#include "clip_playback.hpp"
#include "session_unit.hpp"

namespace deixis::studies {

class ClipTrial : public TrialUnit {
  public:
    ClipTrial(SessionCore& core, const TimelineItem& item);
    void enter(const InputFrame& input, bool moved) override;
    void step(const InputFrame& input) override;
    void shown(std::uint64_t frame, const Moment& at) override;
    void resume(const InputFrame& input, double away_s) override;
    [[nodiscard]] bool wantsPointer() const override;
    [[nodiscard]] bool begun() const override { return begun_; }

  protected:
    AnswerGate gate_{};

    virtual void openAnswer(const InputFrame& input) = 0;  ///< also after a pause
    virtual void stepAnswer(const InputFrame& input) = 0;
    virtual void forgetAnswer() {}  ///< what was begun of the answer and not given
    /// Whether the first of several answers has been given: the clip does not come again.
    [[nodiscard]] virtual bool committed() const { return false; }

    void reopenAnswer(const InputFrame& input);
    /// Whether select went down as an answer; noted where it did so before the open answer was seen.
    [[nodiscard]] bool select(const InputFrame& input);
    /// Present while the study allows it.
    [[nodiscard]] std::optional<ButtonSpec> replayButton() const;
    void replay();

  private:
    enum class Phase : unsigned char { lead_in, playing, answering };

    Phase phase_ = Phase::lead_in;
    ClipPlayback playback_;
    int plays_left_;      ///< before the answer opens
    bool begun_ = false;  ///< an onset was shown
    bool early_select_ = false;

    void startLeadIn(double length_s);
    void stepPlaying(const InputFrame& input);
    void noteEarlySelect(const InputFrame& input);
    void tellOnset(const Moment& at);
};

/// Added to the pause before a trial where the participant was moved.
constexpr double orient_s = 0.6;

}  // namespace deixis::studies
