// What the test asks for: lines that it adds to a file while the program runs.
//
//   headset missing                      xrGetSystem finds none
//   spaces local_floor                   no stage
//   spaces local METRES                  no stage and no floor; the local space's origin is so high above it
//   state synchronized|visible|focused   the session comes no further: taken off; not in front; all well
//   head tracked|guessed|turning|lost    as measured; position guessed; no position; neither
//   gaze seen|guessed|lost YAW PITCH     eyes are tracked, and look so many degrees left and up of ahead
//   input held|passed                    no news of the hands; all that came meanwhile, in one frame
//   recentre X Z YAW AHEAD_MS            the spaces' new origin in the old one, and in how many milliseconds
//   exit                                 the runtime's menu ends the program's session
//   announce session-loss|instance-loss  by an event
//   lose session|instance CALL           from the next such call on, without a word before
//   wait FRAMES                          what follows holds only after so many frames more
#pragma once

#include <openxr/openxr.h>

#include <deque>
#include <optional>
#include <string>

namespace deixis::conditions {

enum class Tracking { tracked, guessed, turning, lost };

struct Gaze {
    Tracking tracking = Tracking::tracked;
    float yaw_deg = 0.0F;
    float pitch_deg = 0.0F;
};

struct Recentring {
    XrPosef old_from_new{};
    double ahead_s = 0.0;
};

struct Loss {
    XrResult result = XR_ERROR_INSTANCE_LOST;
    std::string call;
};

enum class Spaces { all, local_floor, local };

/// What holds now, and what is to happen and has not been taken up yet.
struct Conditions {
    bool headset = true;
    Spaces spaces = Spaces::all;
    float local_height_m = 0.0F;
    XrSessionState max = XR_SESSION_STATE_FOCUSED;
    Tracking head = Tracking::tracked;
    std::optional<Gaze> gaze;
    bool input_held = false;
    std::optional<Loss> loss;

    std::deque<Recentring> recentrings;
    bool exit = false;
    bool announce_session_loss = false;
    bool announce_instance_loss = false;
};

class Commands {
  public:
    /// The file that the environment variable DEIXIS_CONDITIONS names; it must be there.
    Commands();
    /// Takes in the lines added since the last call; `frame` counts up. A line that makes no sense ends the
    /// program: the test is wrong.
    void read(Conditions& conditions, int frame);
    [[nodiscard]] const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::size_t read_ = 0;  ///< bytes
    int wait_until_ = 0;    ///< frame
};

}  // namespace deixis::conditions
