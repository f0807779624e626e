// The one interface between a session and the person or program that takes part in it: a desktop, a
// headset or a simulated participant.
//
// A station begins a frame (which sets the pace, and is the only clock), returns what the person did,
// presents what the session says, and reports whether the frame was really shown.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "studies/station/authoring.hpp"
#include "studies/station/first_look.hpp"
#include "studies/station/note_kind.hpp"
#include "studies/station/pause_reason.hpp"
#include "studies/station/presented_state.hpp"
#include "studies/station/session_status.hpp"
#include "studies/station/station_kind.hpp"

namespace deixis::studies {

/// Something that a station has to say for the record; kept as a Note of the session at its own time, with
/// the trial under way.
struct StationNote {
    NoteKind kind = NoteKind::xr_state;
    std::string detail;
    double time_s = 0.0;  ///< on the station's clock
};

enum class OperatorAction : unsigned char {
    repeat_last,  ///< the trial answered last is done again; its answer is kept, and marked
    skip,         ///< the trial under way is left without an answer
    abort,        ///< the session ends, and the participant counts as a drop-out
    note          ///< a remark for the record
};

/// What the experimenter asked for, beside pausing (InputFrame::pause), going on (resume) and ending (quit).
struct OperatorCommand {
    OperatorAction action = OperatorAction::note;
    std::string text{};  ///< the reason, or the remark
};

/// What the person did since the last frame, and the time at which the frame now begun will be shown.
struct InputFrame {
    double time_s = 0.0;  ///< predicted display time on the station's monotonic clock; never goes back
    double utc_s = 0.0;   ///< the same moment as UTC seconds since 1970 (simulated stations: virtual)
    /// When the input was read, on the same clock; none: at time_s. An answer by key is given at this time.
    std::optional<double> input_time_s;
    /// When input was read before, on the same clock: a key went down, or select where its time is not known,
    /// at some time since. Only what surely came after the onset is an answer. None: at input_time_s.
    std::optional<double> read_before_s;
    Pose stage_from_head{};      ///< -z looks forward, +y up
    std::optional<Ray> pointer;  ///< hand or mouse ray in the stage's frame; none while it is not tracked
    bool select = false;         ///< the select button went down
    bool select_held = false;    ///< it is down: a slider follows the ray
    /// When it went down, on the same clock, where the device tells; none: at input_time_s. An answer by ray
    /// is given at this time, unless the open answer was not yet shown then.
    std::optional<double> select_time_s;
    std::optional<int> digit;  ///< a number key went down: 1..9
    /// What is held by the ray is to go so much farther away: wheel, page keys, thumbstick.
    double farther_m = 0.0;
    bool confirm = false;  ///< Enter or Space went down (Space: not while a text field is open)
    std::string typed{};   ///< characters typed, UTF-8; where the station has a keyboard
    int erased = 0;        ///< how often Backspace went down, after what was typed
    bool pause = false;    ///< Esc went down, or focus or tracking was lost
    bool resume = false;   ///< the operator ends the pause
    /// What was authored since the frame before; also while the session is paused.
    std::optional<AuthoredWork> work{};
    std::vector<OperatorCommand> commands{};
    PauseReason pause_reason = PauseReason::unsaid;
    bool quit = false;          ///< the window was closed or the operator ends the session
    std::string quit_reason{};  ///< empty: "quit"
    /// How far the person stands from the layout's place, along the floor; 0 if the station keeps it
    /// there. Beyond HeadsetOptions::place_tolerance_m the person is asked back.
    double off_place_m = 0.0;
    /// Whether every answer given so far is on the disk. The next trial waits for it.
    bool answers_kept = true;
    /// Answers can no longer be kept: the session ends with a calm word, and nothing more is asked.
    bool recording_failed = false;
    std::vector<StationNote> notes{};
};

struct Rgb {
    float r = 1.0F, g = 1.0F, b = 1.0F;  ///< linear light, 0..1
};

/// Told apart without colours too: by lightness, and by rings around the ball.
enum class BallLook : unsigned char {
    waiting,     ///< black
    selectable,  ///< white
    hovered,     ///< lit yellow, as long as the ray is on it
    chosen,      ///< blue, with a ring
    revealed     ///< green, with two rings: feedback, this was the target
};

struct BallView {
    Vec3 centre{0.0};
    double radius_m = 0.0;
    BallLook look = BallLook::waiting;
};

/// A rectangle on a panel: metres from the panel's lower left corner, y up.
struct PanelRect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

struct PanelText {
    PanelRect box{};
    std::string text;  ///< as laid out: a line feed ends each of its lines, and none is wider than the box
    double size_m = 0.04;  ///< height of a line
    bool bold = false;
    bool centred = false;
    bool faint = false;
    bool level = false;  ///< in the middle of the box's height
};

/// What a button does, which a person reads from its label and place.
enum class ButtonRole : unsigned char {
    go_on,   ///< leaves the page
    leave,   ///< ends something: the session, without consent
    play,    ///< shows a clip
    option,  ///< one answer of several: a step of a scale, a preference, an option
    other
};
/// "go_on": in traces and to the studio's page.
[[nodiscard]] std::string_view buttonRoleName(ButtonRole role);

struct PanelButton {
    PanelRect box{};
    std::string label;
    std::string caption{};  ///< small text inside, under the label
    int id = 0;
    bool enabled = true;
    bool hovered = false;
    bool chosen = false;  ///< the option that is picked now
    ButtonRole role = ButtonRole::other;
};

/// A track on which a value is set by pressing on it, or by dragging. Nothing is set until it is touched.
struct PanelSlider {
    PanelRect box{};  ///< of the whole: track, and under it the labels
    int id = 0;
    int low = 0;
    int high = 100;
    std::optional<int> value{};         ///< none: untouched, no thumb is drawn
    std::vector<std::string> labels{};  ///< spread evenly under the track; as laid out, in lines
    double label_size_m = 0.036;        ///< height of their lines
    bool enabled = true;
    bool hovered = false;
    /// The track, from low to high, in the panel's metres; the thumb stays within it.
    [[nodiscard]] PanelRect track() const;
    [[nodiscard]] int valueAt(double x_m) const;  ///< nearest value; ends beyond the track's
};

/// A line of text that is typed.
struct PanelField {
    PanelRect box{};
    int id = 0;
    std::string text{};
    std::string hint{};   ///< shown while it is empty
    bool active = false;  ///< takes what is typed; shows a caret
    bool hovered = false;
    bool enabled = true;
};

/// A board that stands in the world. `stage_from_panel` has its origin at the lower left corner, +x to the
/// reader's right, +y up, +z towards the reader.
struct Panel {
    Pose stage_from_panel{};
    double width_m = 0.0;
    double height_m = 0.0;
    std::vector<PanelText> texts;
    std::vector<PanelButton> buttons;
    std::vector<PanelSlider> sliders{};
    std::vector<PanelField> fields{};
    double progress = -1.0;  ///< 0..1 draws a bar along the foot; negative: none
};

struct RayView {
    Ray ray{};
    double length_m = 5.0;  ///< that is drawn: up to what it meets
};

/// A sound that is heard with what is shown.
struct SoundView {
    std::string id;       ///< ClipSound::id
    double time_s = 0.0;  ///< how far into the sound the frame's display time is; 0 until the clip has begun
    bool on_right = false;  ///< of a pair, the avatar at the participant's right makes it
    Vec3 mouth{0.0};        ///< of the avatar that makes it, in the stage's frame
};

/// Everything that a participant can see or hear in one frame; nothing about what the right answer is.
struct PresentedFrame {
    std::uint64_t number = 0;         ///< counts up; a frame report refers to it
    bool scene_visible = true;        ///< avatars and balls: not behind a page, which they would cover
    std::vector<Pose> avatar_joints;  ///< stage_from_joint, in the avatar skeleton's order
    /// Pairwise: the other avatar, which stands at the participant's right; empty: there is none.
    std::vector<Pose> right_avatar_joints{};
    std::vector<BallView> balls;
    /// Game: where a flat screen looks, and how wide, so that the balls are seen with the arm that points or
    /// the board that asks; changes where such a board comes or goes.
    std::optional<FirstLook> first_look{};
    std::optional<RayView> ray;
    std::optional<SoundView> sound{};
    std::optional<Panel> panel;
    std::uint64_t board = 0;  ///< counts up with each panel that comes; the same while its contents change
    /// A small board beside the avatar's head, to be read only: the number of an attention check.
    std::optional<Panel> sign;
    std::optional<AuthoringTask> authoring{};  ///< present in such a trial, also while it is paused
    Pose stage_from_viewer{};  ///< where the participant is asked to stand: on the floor, -z is forward
    std::string viewer_place;  ///< changes exactly when the viewer is moved: "across", "side-by-side"
    SessionStatus status{};    ///< for the operator
    /// One calm sentence to the participant beside all else ("Please step back to your place."); empty:
    /// none.
    std::string notice;
    bool tick = false;  ///< the ray has just met a ball or a button: a light haptic tick
    PresentedState state = PresentedState::starting;
    bool in_game = false;  ///< the state is one of a trial of the game
    std::string stage;     ///< Stage::name; empty outside stages
};

/// The state's name; in the game with "-" and the place behind: "choosing-across".
[[nodiscard]] std::string presentedStateName(const PresentedFrame& frame);

/// A tracked pose in the stage's frame, with what the device says of it.
struct TrackedPose {
    Pose stage_from_device{};
    bool position_valid = false;
    bool orientation_valid = false;
    bool tracked = false;  ///< measured now, not held or guessed from before
    [[nodiscard]] bool valid() const { return position_valid && orientation_valid; }
};

enum class Hand : unsigned char { left, right };

/// One joint of a tracked hand, in the order of XR_EXT_hand_tracking (palm, wrist, thumb, ... 26 in all).
struct HandJoint {
    TrackedPose pose{};
    double radius_m = 0.0;
};

/// What was measured during one frame. All times are on the station's clock; poses hold at display_time_s.
struct TrackingSample {
    std::uint64_t frame = 0;      ///< PresentedFrame::number
    double display_time_s = 0.0;  ///< predicted
    double begun_s = 0.0;         ///< when the station was let begin the frame
    double submitted_s = 0.0;     ///< when the frame had been handed over
    int dropped_frames = 0;       ///< display periods that passed without a new frame since the one before
    bool rendered = true;         ///< false: the frame had no picture, the device did not want one
    TrackedPose head{};
    std::array<TrackedPose, 2> aim{};   ///< by Hand
    std::array<TrackedPose, 2> grip{};  ///< by Hand
    std::optional<TrackedPose> gaze;    ///< -z looks forward; none: not asked for, or not offered
    std::array<std::vector<HandJoint>, 2> joints{};  ///< by Hand; empty: not asked for, offered or seen
    double off_place_m = 0.0;                        ///< as InputFrame::off_place_m
};

/// What became of a presented frame.
struct FrameReport {
    std::uint64_t number = 0;
    bool shown = false;
    double display_time_s = 0.0;               ///< when it was (or is predicted to have been) shown
    std::optional<TrackingSample> tracking{};  ///< none if nothing is tracked
};

struct StationInfo {
    StationKind kind = StationKind::desktop;
    std::string details;     ///< device, driver, display and refresh rate in words
    bool synthetic = false;  ///< no person answers here
    std::string controls{};  ///< how to take part, one line; empty if there is nothing to tell
    std::string hint{};      ///< the same for the participant, under the first pages and where a pause begins
    /// Name and value, for the record: "runtime", "runtime_version", "system", "refresh_rate_hz", "ipd_m",
    /// ...
    std::vector<std::pair<std::string, std::string>> properties{};
};

class Station {
  public:
    virtual ~Station() = default;
    [[nodiscard]] virtual StationInfo info() const = 0;
    /// Begins a frame: waits for its time, and says what the person did.
    [[nodiscard]] virtual InputFrame beginFrame() = 0;
    /// Shows it. Called exactly once for each begun frame.
    virtual FrameReport present(const PresentedFrame& frame) = 0;
    /// Called once, when the session is over: takes leave of the device. Returns what it still has to say.
    virtual std::vector<StationNote> close() { return {}; }
    /// Why the station itself ended the session (a runtime that went away); none: it did not.
    [[nodiscard]] virtual std::optional<Error> failure() const { return std::nullopt; }
};

}  // namespace deixis::studies
