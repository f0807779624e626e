// The headset station's inside, private to headset_station.cpp (opening, and the Station interface) and
// headset_frame.cpp (one frame: what is read, drawn, kept, and shown to the experimenter).
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/headset/headset_station.hpp"
#include "app/operator/operator_window.hpp"
#include "head_watch.hpp"
#include "headset_picture.hpp"
#include "participant_place.hpp"
#include "pointing_hand.hpp"
#include "xr_input.hpp"
#include "xr_runtime.hpp"
#include "xr_session.hpp"

namespace deixis::app {

/// Headset, runtime and its version, for people.
[[nodiscard]] std::string deviceWords(const XrRuntime& runtime);

struct HeadsetStation::State {
    State(HeadsetStationOptions options_in, XrRuntime runtime_in, double avatar_eye_height_m)
        : options(std::move(options_in)),
          runtime(std::move(runtime_in)),
          place(options.study.eye_level, avatar_eye_height_m) {}

    // In the order in which they are made; they go the other way round.
    HeadsetStationOptions options;
    XrRuntime runtime;
    std::unique_ptr<GlWindow> window;
    std::unique_ptr<OperatorWindow> operator_window;
    std::unique_ptr<XrSessionLoop> session;
    std::unique_ptr<XrInput> input;
    std::unique_ptr<HeadsetPicture> picture;

    ParticipantPlace place;
    PointingHand pointing_hand;
    double utc_offset_s = 0.0;
    double refresh_rate_hz = 0.0;
    double ipd_m = 0.0;
    bool joined = false;  ///< somebody has worn the headset, tracked and in focus
    std::optional<Error>
        failure;  ///< why the station ended the session; nothing is asked of the runtime then
    std::string quit_reason;

    // The frame under way.
    std::optional<XrFrame> frame;
    XrInputState device{};
    studies::TrackedPose head{};  ///< in the tracking space
    studies::Placement placement{};
    double off_place_m = 0.0;

    // From frame to frame.
    std::vector<studies::StationNote> notes;
    std::optional<XrTime> recentre_at;
    std::optional<double> recentre_held_since_s;
    HeadWatch head_watch;
    Pose last_stage_from_head{};
    double last_time_s = 0.0;
    double last_begun_s = 0.0;
    double frames_per_s = 0.0;
    int dropped = 0;
    bool has_picture = false;
    OperatorRequest asked{};
    studies::PresentedFrame presented{};

    void note(studies::NoteKind kind, std::string detail) {
        notes.push_back({kind, std::move(detail), session->now_s()});
    }
    void lose(const XrFailure& by);
    void handleWindow();
    void handleRuntime();
    void beginXrFrame();
    void endUnseen();
    void updateRecentre();
    void waitUntilWorn();
    void noteProfiles();
    void noteEyes(const XrEyes& eyes);
    [[nodiscard]] std::optional<studies::PauseReason> pauseReason();
    void readInput(studies::InputFrame& input);
    bool drawFrame(const studies::PresentedFrame& shown_frame);
    [[nodiscard]] studies::TrackingSample sample(std::uint64_t number) const;
    [[nodiscard]] OperatorView operatorView() const;
    void showOperator();
};

}  // namespace deixis::app
