// Several movements on one page: the participant plays them by buttons, any of them again, and answers when
// each has been shown to its end. Parallel rating and pairs say what the answer is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clip_playback.hpp"
#include "session_unit.hpp"
#include "studies/boards/panel_layout.hpp"

namespace deixis::studies {

class ComparePage : public TrialUnit {
  public:
    ComparePage(SessionCore& core, const TimelineItem& item) : TrialUnit(core, item) {}
    void enter(const InputFrame& input, bool moved) override;  ///< once the avatars stand
    void step(const InputFrame& input) override;
    void shown(std::uint64_t frame, const Moment& at) override;
    void resume(const InputFrame& input, double away_s) override;
    [[nodiscard]] bool stepDone(const InputFrame& input, double since_s) override;
    void resumeDone(const InputFrame& input) override;
    [[nodiscard]] bool wantsPointer() const override { return !done_; }
    [[nodiscard]] bool begun() const override { return begun_; }

  protected:
    AnswerGate gate_{};  ///< of the answer to the whole page

    /// The avatar that shows stimulus `i`.
    [[nodiscard]] virtual AvatarPoser& poserOf(std::size_t i) = 0;
    [[nodiscard]] virtual PresentedState openState() const = 0;
    [[nodiscard]] virtual Panel board() const = 0;
    /// What the ray did on the board beside playing; true where the board has changed.
    virtual bool stepBoard(const InputFrame& input, const Aim& met) = 0;
    /// Whether the page can be answered as it is, all having been seen.
    [[nodiscard]] virtual bool complete_enough() const { return true; }
    /// A second page has taken the board's place.
    [[nodiscard]] virtual bool beyondBoard() const { return false; }
    virtual void stepBeyond(const InputFrame& /*input*/) {}
    virtual void resumeBeyond(const InputFrame& /*input*/) {}
    virtual void forgetAnswer() {}  ///< what was begun of the answer and not given

    [[nodiscard]] std::size_t count() const { return playbacks_.size(); }
    [[nodiscard]] bool seen(std::size_t i) const { return draft_.plays[i] >= task_.plays; }
    [[nodiscard]] bool allSeen() const;
    [[nodiscard]] bool quiet() const { return !playing_.has_value(); }
    [[nodiscard]] StimulusView viewOf(std::size_t i) const;

  private:
    std::vector<ClipPlayback> playbacks_{};
    std::optional<std::size_t> playing_{};  ///< from its pause before the clip until its end was shown
    bool leading_in_ = false;
    bool begun_ = false;
    bool changed_ = false;  ///< since the board was drawn

    void openBoard(const InputFrame& input);
    void play(std::size_t i);
    void stepPlaying(const InputFrame& input);
    void settleGate();
    void startOver();
};

}  // namespace deixis::studies
