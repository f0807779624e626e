// A trial in which the participant makes gestures to a speech in the studio's page (Yoon et al. 2021, 7.1).
#pragma once

#include <string>

namespace deixis::studies {

/// A project of the studio, and how it came about in a trial.
struct AuthoredProject {
    std::string project;  ///< JSON, as the page saves it
    int edits = 0;
    int poses = 0;      ///< pose controls in it,
    int styles = 0;     ///< and style controls
    int generated = 0;  ///< how often gestures were generated
};

/// What the page tells of it.
struct AuthoredWork {
    int trial = 0;  ///< AuthoringTask::trial that it is of; of another one it is not taken
    /// The project as it is now; edits and generations since the work before.
    AuthoredProject now{};
    bool finished = false;  ///< the participant ends the trial, where that is allowed
};

struct AuthoringTask {
    int trial = 1;  ///< 1.. of the stage
    int of = 1;
    bool practice = false;
    std::string system;
    bool keyframes_only = false;  ///< there is neither model nor styles
    std::string question;
    AuthoredProject so_far{};  ///< what to start from, or to go on with
    double limit_s = 0.0;
    double left_s = 0.0;
    bool may_end_early = false;
};

}  // namespace deixis::studies
