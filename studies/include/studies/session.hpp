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

/// What one step gives: the frame to show, and what happened.
struct SessionStep {
    PresentedFrame frame;
    std::vector<SessionEvent> events;
};

class SessionRunner {
  public:
    /// `answered` holds the indices of trials already answered in an earlier session of the participant: they
    /// are not asked again (practice before the first unanswered trial's stage is repeated only if that stage
    /// has not begun). `idle_pose` is how the avatar stands when no clip plays. All references must outlive
    /// the runner.
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

    [[nodiscard]] bool finished() const;  ///< the last page was left; nothing more to show
    [[nodiscard]] bool quit() const;      ///< ended before its end; the rest can be resumed

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace deixis::studies
