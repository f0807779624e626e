// The session: a pure state machine from input frames to presented frames and events. No clock, file or GL.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/skeleton/clip.hpp"
#include "studies/boards/button_ids.hpp"
#include "studies/design/plan.hpp"
#include "studies/session/events.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// What is said in a clip.
struct ClipSound {
    std::string id;  ///< under which a station has the samples
    double duration_s = 0.0;
};

/// Gives the clip of a stimulus, already on the avatar's skeleton. Clips and sounds live as long as the
/// source.
class ClipSource {
  public:
    virtual ~ClipSource() = default;
    [[nodiscard]] virtual const motion::Clip& clip(const Stimulus& stimulus) const = 0;
    /// Null: nothing is heard with it.
    [[nodiscard]] virtual const ClipSound* sound(const Stimulus& /*stimulus*/) const { return nullptr; }
    /// The studio's project that the clip is made of (its file's text); null: of none.
    [[nodiscard]] virtual const std::string* project(const Stimulus& /*stimulus*/) const { return nullptr; }
};

/// How far a trial of authoring had come.
struct UnfinishedWork {
    int trial_index = -1;
    AuthoredProject project{};
    double used_s = 0.0;  ///< of its time
};

/// What earlier sessions of the participant left.
struct Resume {
    /// Trial index -> correct (false only for a wrong choice of the game). A consent that was declined is not
    /// among them: it is asked again before anything else.
    std::map<int, bool> answered{};
    std::set<int> begun{};  ///< unanswered trials whose clip had been begun
    /// By stage and kind; not those that were forgiven when the participant was let in again.
    std::map<std::pair<std::string, CheckKind>, int> check_failures{};
    /// Work on a trial of authoring that was broken off.
    std::optional<UnfinishedWork> work{};
    /// Answers to trials that a check repeats (TrialCheck::of_trial). Without, such a repeat is not judged.
    std::vector<Response> first_answers{};
    double gap_s = 0.0;  ///< from the last thing known of the session before until now; 0: there was none
};

/// The trials that are still to be answered, in order: none of later visits (Stage::session) while an
/// earlier one has any left, and no practice attempts after one that met the criterion, or of a stage whose
/// trials have begun.
[[nodiscard]] std::vector<int> trialsLeft(const Study& study, const StudyPlan& plan,
                                          const std::map<int, bool>& answered);

/// What one step gives: the frame to show (valid until the next step), and what happened.
struct SessionStep {
    const PresentedFrame& frame;
    std::vector<SessionEvent> events;
};

enum class SessionOutcome : unsigned char {
    running,
    finished,  ///< this visit's last page was left
    quit,      ///< ended before its end; the rest can be resumed
    aborted,   ///< by the operator: a drop-out
    declined,  ///< consent was not given
    excluded   ///< a check or a practice that ends the session failed
};
[[nodiscard]] std::string_view sessionOutcomeName(SessionOutcome outcome);

/// How far the session is: for the operator.
struct StageProgress {
    std::string name;
    int done = 0;
    int of = 0;  ///< units that are answered; 0: a page
    bool current = false;
};

struct SessionProgress {
    std::vector<StageProgress> stages;
    int checks_passed = 0;
    int checks_failed = 0;
    std::string trial;  ///< the conditions of the trial under way, which the operator sees only on demand
};

/// The timeline of a session: the stages of the plan in order, each with its pages, trials and breaks (for
/// the pointing study: Deichler et al. 2023, section 2.4.2).
///
/// A trial: a pause in which the avatar stands at ease (longer where the participant has been moved), the
/// clip, then the answer. The clip's time is the display time since its first frame was shown. Its last pose
/// is held while the answer is open. An answer counts only when the frame that opened it has been shown, and
/// only where select (or the key) went down after that; it is dated by that moment. Nothing can be hovered or
/// selected that lies more than 60 degrees off the looking direction. The answer given is shown for a moment
/// and until it is kept (InputFrame::answers_kept).
///
/// A page of parallel rating, or a pair: the participant plays the clips by buttons, any of them again; the
/// answer can be given when each has been shown to its end.
///
/// A pause during the clip starts it over; a pause while the answer is open is taken off the response time,
/// or starts the trial over where the study wants it repeated (Study::after_interruption).
///
/// A participant who strays from the place, or has had no pointer for 2 s with something to aim at, is told
/// so (PresentedFrame::notice), and the trial is marked by notes.
class SessionRunner {
  public:
    /// Goes through trialsLeft(); pages of a stage that has begun are not shown again, but for the
    /// instructions before it where `resume.gap_s` exceeds Study::instructions_again_after_s. `keyboard`:
    /// questions that need one are asked. `hint`: StationInfo::hint. `idle_pose` is how the avatar stands
    /// when no clip plays. All references must outlive the runner. Throws std::invalid_argument if the
    /// plan names a stage or layout that the study lacks, and step() where a clip is empty or has not the
    /// avatar's joints.
    SessionRunner(const Study& study, const StudyPlan& plan, const ClipSource& clips,
                  const motion::Skeleton& avatar, const motion::LocalPose& idle_pose, Resume resume,
                  bool keyboard, std::string hint = {});
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
    /// What the session has come to. Only `running` goes on.
    [[nodiscard]] SessionOutcome outcome() const;
    [[nodiscard]] SessionProgress progress() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace deixis::studies
