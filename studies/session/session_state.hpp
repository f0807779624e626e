// A session under way: the conductor. Its parts stand in session.cpp (from unit to unit, and each frame),
// pauses.cpp and operator_commands.cpp (commands, progress).
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "attention_checks.hpp"
#include "guards.hpp"
#include "session_core.hpp"
#include "session_unit.hpp"
#include "studies/session/session.hpp"
#include "timeline.hpp"

namespace deixis::studies {

struct SessionRunner::State {
    State(const Study& study_in, const StudyPlan& plan_in, const ClipSource& clips,
          const motion::Skeleton& avatar, const motion::LocalPose& idle, Resume resume, bool keyboard,
          std::string hint);

    const Study& study;
    const StudyPlan& plan;
    std::set<int> begun;  ///< in earlier sessions
    SessionCore core;
    Timeline timeline;
    CheckScorer checks;
    PlaceGuard place_guard;
    PointerGuard pointer_guard;

    SessionOutcome outcome = SessionOutcome::running;
    bool started = false;
    std::optional<TimelineItem> item{};
    std::unique_ptr<Unit> unit{};
    std::string stage{};                 ///< the last that was told to have started
    double done_since_s = 0.0;           ///< of the unit
    bool disk_wait_shown = false;        ///< that the answer waits to be kept
    bool excluded = false;               ///< told
    bool reselect = false;               ///< the unit under way is put off
    std::optional<int> last_answered{};  ///< in this session

    bool paused = false;
    PauseReason pause_reason = PauseReason::unsaid;
    double paused_since_s = 0.0;

    [[nodiscard]] bool over() const { return outcome != SessionOutcome::running; }

    // From unit to unit.
    void begin(const InputFrame& input);
    void proceed(const InputFrame& input);
    void enter(const InputFrame& input);
    void stepUnit(const InputFrame& input);
    void keepAnswer(Response response);
    void scorePractice(const Trial& trial);
    void exclude(Response& response, std::string reason);
    void end(SessionOutcome how, const char* status);
    void endEarly(const std::string& reason);
    void stop(const InputFrame& input);

    // Pauses.
    void pause(const InputFrame& input);
    void openPausePanel(const InputFrame& input);
    void askWhetherToEnd(const InputFrame& input);
    void stepPaused(const InputFrame& input);
    void resume(const InputFrame& input);

    // The operator.
    void carryOut(const InputFrame& input, const OperatorCommand& command);
    void repeatLast(const InputFrame& input, const std::string& reason);
    void skip(const InputFrame& input, const std::string& reason);
    [[nodiscard]] SessionProgress progress() const;

    // One frame.
    void step(const InputFrame& input);
    void guard(const InputFrame& input);
    void tell(bool waits_for_disk);
    void shown(const FrameReport& report);
};

}  // namespace deixis::studies
