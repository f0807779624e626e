// The session: a pure state machine from input frames to presented frames and events. No clock, file or GL.
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "motion/clip.hpp"
#include "studies/events.hpp"
#include "studies/plan.hpp"
#include "studies/station.hpp"
#include "studies/study.hpp"

namespace deixis::studies {

/// Gives the clip of a trial, already on the avatar's skeleton. Clips live as long as the source.
class ClipSource {
  public:
    virtual ~ClipSource() = default;
    [[nodiscard]] virtual const motion::Clip& clip(const Trial& trial) const = 0;
};

/// What one step gives: the frame to show (valid until the next step), and what happened.
struct SessionStep {
    const PresentedFrame& frame;
    std::vector<SessionEvent> events;
};

/// Ids of the buttons on panels.
namespace button_id {
constexpr int go_on = 1;  ///< leaves a page
constexpr int resume = 2;
constexpr int end_session = 3;
constexpr int replay = 4;
constexpr int end_for_good = 5;    ///< asked after end_session
constexpr int back = 6;            ///< from that question
constexpr int first_rating = 101;  ///< the button "1"; the others follow
}  // namespace button_id

/// The course of a session (Deichler et al. 2023, section 2.4.2): welcome, then for each stage instructions,
/// practice where the plan has any, and the trials with breaks, then goodbye.
///
/// A trial: a pause in which the avatar stands at ease (longer where the participant has been moved), the
/// clip, then the answer. The clip's time is the display time since its first frame was shown. Its last pose
/// is held while the answer is open. An answer counts only when the frame that opened it has been shown, and
/// only where select (or the key) went down after that; it is dated by that moment. Nothing can be hovered or
/// selected that lies more than 60 degrees off the looking direction. The answer given is shown for a moment
/// and until it is kept (InputFrame::answers_kept).
///
/// A pause during the clip starts it over; a pause while the answer is open is taken off the response time,
/// or starts the trial over where the study wants it repeated (Study::after_interruption).
///
/// A participant who strays from the place, or has had no pointer for 2 s with something to aim at, is told
/// so (PresentedFrame::notice), and the trial is marked by notes.
class SessionRunner {
  public:
    /// `answered` holds the indices of trials already answered in an earlier session of the participant: they
    /// are not asked again (practice before the first unanswered trial's stage is repeated only if that stage
    /// has not begun). `idle_pose` is how the avatar stands when no clip plays. All references must outlive
    /// the runner. Throws std::invalid_argument where the plan names a layout that the study lacks, and
    /// step() where a clip is empty or has not the avatar's joints.
    SessionRunner(const Study& study, const StudyPlan& plan, const ClipSource& clips,
                  const motion::Skeleton& avatar, const motion::LocalPose& idle_pose, std::set<int> answered);
    ~SessionRunner();
    SessionRunner(const SessionRunner&) = delete;
    SessionRunner& operator=(const SessionRunner&) = delete;

    /// Advances to the input's time. Call once for each begun frame.
    [[nodiscard]] SessionStep step(const InputFrame& input);

    /// Tells what became of the frame that the last step gave; an onset is logged only when its frame was
    /// shown. Returns the events that follow from it.
    [[nodiscard]] std::vector<SessionEvent> shown(const FrameReport& report);

    /// Index of the trial under way, from its pause before the clip until its answer has been confirmed; -1
    /// between trials.
    [[nodiscard]] int trialUnderWay() const;
    [[nodiscard]] bool finished() const;  ///< the last page was left; nothing more to show
    [[nodiscard]] bool quit() const;      ///< ended before its end; the rest can be resumed

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace deixis::studies
