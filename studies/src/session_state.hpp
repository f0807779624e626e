// A session under way. Its parts stand in session.cpp (from item to item, and each frame), session_trial.cpp
// and session_pause.cpp.
#pragma once

#include <string>
#include <vector>

#include "session_agenda.hpp"
#include "session_avatar.hpp"
#include "session_guards.hpp"
#include "session_playback.hpp"
#include "session_view.hpp"
#include "studies/session.hpp"

namespace deixis::studies {

enum class Phase : unsigned char {
    page,
    lead_in,    ///< the pause before a clip
    playing,    ///< from the clip's first frame until its last pose has been shown
    answering,  ///< the answer is open
    confirmed,  ///< the answer given is shown for a moment, and until it is kept
    over
};

struct SessionRunner::State {
    State(const Study& study_in, const StudyPlan& plan, const ClipSource& clips_in,
          const motion::Skeleton& avatar_in, const motion::LocalPose& idle_in, const std::set<int>& answered);

    const Study& study;
    const ClipSource& clips;
    const motion::Skeleton& avatar;
    const motion::LocalPose& idle;
    std::vector<AgendaItem> agenda;
    AvatarPoser poser;  ///< moved by `playback` too
    SessionView view;
    PlaceGuard place_guard;
    PointerGuard pointer_guard;
    std::vector<SessionEvent> events;

    Phase phase = Phase::page;
    std::size_t position = 0;
    int scored = 0;
    int done = 0;
    bool started = false;
    bool finished = false;
    bool quit = false;
    bool paused = false;
    std::string pause_reason;
    double paused_since_s = 0.0;
    double panel_since_s = 0.0;
    double confirmed_since_s = 0.0;
    Moment now{};  ///< of the input last stepped to

    // The trial under way.
    ClipPlayback playback;
    std::uint64_t answer_frame = 0;  ///< the first in which the answer was open
    bool answer_open = false;        ///< balls white or panel there, in a frame
    bool answer_shown = false;       ///< and that frame was shown,
    double answer_shown_s = 0.0;     ///< at this time
    bool aiming = false;             ///< the ray is on a ball
    double paused_s = 0.0;
    int pauses = 0;
    int replays = 0;
    bool early_select = false;  ///< noted
    bool told_of_disk = false;  ///< that the answer waits to be kept

    [[nodiscard]] const AgendaItem& item() const { return agenda[position]; }
    [[nodiscard]] const Trial& trial() const { return *item().trial; }
    [[nodiscard]] bool game() const { return trial().stage == StageKind::game; }
    /// Index of the trial under way; -1: none is.
    [[nodiscard]] int trialIndex() const;
    /// A page takes no input at once: a double click must not skip it.
    [[nodiscard]] bool settled() const;
    /// A time on the station's clock near the last input's, with its UTC.
    [[nodiscard]] Moment momentAt(double time_s) const;
    /// Whether the participant is to aim at something in the frame made last.
    [[nodiscard]] bool somethingToAimAt() const;

    void note(const char* kind, std::string detail = {});
    void noteAt(const Moment& at, std::string kind, std::string detail);
    /// In the game the place is part of the state's name.
    void showState(const char* base);
    void openPanel(Panel panel, const InputFrame& input, PanelPlace place);

    // From item to item.
    void begin(const InputFrame& input);
    void enter(const InputFrame& input);
    void enterPage(const InputFrame& input);
    void openPage(const InputFrame& input);
    void leave(const InputFrame& input);
    void end(const char* status);
    void endEarly(const std::string& reason);

    // A trial.
    void enterTrial(bool moved);
    void startLeadIn(double length_s);
    void stepLeadIn();
    void stepPlaying();
    void openAnswer(const InputFrame& input);
    void stepAnswering(const InputFrame& input);
    void answer(const InputFrame& input, double given_s, const char* by, int rating, int place);
    void stepConfirmed(const InputFrame& input);
    void noteEarlySelect(const InputFrame& input);

    // Pauses.
    void pause(const InputFrame& input);
    void openPausePanel(const InputFrame& input);
    void askWhetherToEnd(const InputFrame& input);
    void stepPaused(const InputFrame& input);
    void resume(const InputFrame& input);
    void resumeTrial(const InputFrame& input, double away_s);

    // One frame.
    void step(const InputFrame& input);
    void stepPhase(const InputFrame& input);
    void guard(const InputFrame& input);
    void shown(const FrameReport& report);
};

}  // namespace deixis::studies
