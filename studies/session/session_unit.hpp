// One thing that a session goes through, while it is under way: a page, or a trial of one of the kinds. Each
// kind stands in a folder of studies/trials; the conductor (session.cpp) knows only what is declared here.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "attention_checks.hpp"
#include "session_core.hpp"
#include "timeline.hpp"

namespace deixis::studies {

struct RecordedTrial;

class Unit {
  public:
    explicit Unit(SessionCore& core) : core_(core) {}
    virtual ~Unit() = default;
    Unit(const Unit&) = delete;
    Unit& operator=(const Unit&) = delete;

    /// `moved`: the participant has been moved since the unit before.
    virtual void enter(const InputFrame& input, bool moved) = 0;
    virtual void step(const InputFrame& input) = 0;  ///< one frame, until done()
    /// What was authored; also while the session is paused.
    virtual void takeWork(const AuthoredWork& /*work*/) {}
    /// A frame was shown.
    virtual void shown(std::uint64_t /*frame*/, const Moment& /*at*/) {}
    /// Goes on after a pause, which had put its own board in place of all else.
    virtual void resume(const InputFrame& input, double away_s) = 0;
    /// Once done: one frame more; true when the answer has been shown long enough, `since_s` after it.
    [[nodiscard]] virtual bool stepDone(const InputFrame& /*input*/, double /*since_s*/) { return true; }
    virtual void resumeDone(const InputFrame& /*input*/) {}
    /// Leaves the unit without an answer, as far as that can be.
    virtual bool skip(const InputFrame& /*input*/, const std::string& /*reason*/) { return false; }

    /// The page has been left, or the trial answered.
    [[nodiscard]] bool done() const { return done_; }
    /// What the answer is, once.
    [[nodiscard]] std::optional<Response> takeResponse() { return std::exchange(response_, std::nullopt); }
    /// Whether the participant is to aim at something in the frame made last.
    [[nodiscard]] virtual bool wantsPointer() const = 0;
    /// Whether something of it has been seen that must not be shown twice without need.
    [[nodiscard]] virtual bool begun() const { return false; }
    /// Whether a page stands there in whatever state it is.
    [[nodiscard]] virtual bool showsPage() const { return false; }
    [[nodiscard]] virtual std::string notice() const { return {}; }

  protected:
    SessionCore& core_;
    bool done_ = false;
    std::optional<Response> response_{};
};

/// A unit that is answered and kept.
class TrialUnit : public Unit {
  public:
    TrialUnit(SessionCore& core, const TimelineItem& item);
    bool skip(const InputFrame& input, const std::string& reason) override;

  protected:
    const Trial& trial_;
    const Stage& stage_;
    const Stage& task_;         ///< what is asked
    Response draft_{};          ///< what is known of the answer by now
    bool onset_known_ = false;  ///< of the draft

    /// Whether the study wants what was interrupted to start over.
    [[nodiscard]] bool startsOver() const {
        return core_.study.after_interruption == AfterInterruption::repeat;
    }
    void showState(PresentedState state);
    /// The number of a check, beside the head of the avatar that shows stimulus `i`.
    [[nodiscard]] bool checked(int i) const;
    void showSign(const InputFrame& input, bool on_right);
    /// When it was given and how; `complete` hands it over.
    void give(const InputFrame& input, double given_s, const char* by);
    void complete();
};

/// A page that is only read.
[[nodiscard]] std::unique_ptr<Unit> makePage(SessionCore& core, const TimelineItem& item);

/// How a kind is presented and answered; each declares it in studies/trials/KIND/unit.cpp.
struct UnitDeclaration {
    std::unique_ptr<Unit> (*make)(SessionCore& core, const TimelineItem& item);
    /// Whether the answer to a repeated trial is that of the first time, for kinds that may be repeated.
    CheckResult (*compare)(const TrialAnswer& first, const TrialAnswer& now, double tolerance) = nullptr;
    /// The balls as they looked at a time of a recorded trial; null: those of the plan, lit by the ray.
    std::vector<BallView> (*replayed)(const RecordedTrial& recorded, double time_s) = nullptr;
};
template <typename UnitOfKind>
[[nodiscard]] std::unique_ptr<Unit> makeUnitOf(SessionCore& core, const TimelineItem& item) {
    return std::make_unique<UnitOfKind>(core, item);
}
[[nodiscard]] const UnitDeclaration& unitOf(StageKind kind);
/// The one that the item asks for.
[[nodiscard]] std::unique_ptr<Unit> makeUnit(SessionCore& core, const TimelineItem& item);

constexpr double confirm_s = 0.35;  ///< how long the answer given is shown

}  // namespace deixis::studies
