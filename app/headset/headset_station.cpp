#include "app/headset/headset_station.hpp"

#include <fmt/format.h>

#include <thread>

#include "core/utc.hpp"
#include "headset_state.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::app {

namespace {

constexpr double hidden_wait_s = 0.02;  ///< between polls while the session does not run
constexpr double first_frame_s = 3.0;   ///< how long opening waits for the first frame's facts
constexpr double leave_taking_s = 2.0;  ///< how long the runtime may take to end the session

double avatarEyeHeight(const assets::Avatar& avatar) {
    std::vector<Pose> joints;
    motion::worldPose(avatar.skeleton, motion::restPose(avatar.skeleton), joints);
    double sum_m = 0.0;
    for (const motion::Bone eye : {motion::Bone::leftEye, motion::Bone::rightEye}) {
        const int joint = avatar.humanoid[eye];
        if (joint < 0) {  // as high over the head as those of the own avatar
            const int head = avatar.humanoid[motion::Bone::head];
            return head < 0 ? 1.65 : joints[static_cast<std::size_t>(head)].position.y + 0.09;
        }
        sum_m += joints[static_cast<std::size_t>(joint)].position.y;
    }
    return sum_m / 2.0;
}

}  // namespace

// Some runtimes have their version in their name already.
std::string deviceWords(const XrRuntime& runtime) {
    const bool named = runtime.name().find(runtime.version()) != std::string::npos;
    return fmt::format("{}, {}{}{}", runtime.systemName(), runtime.name(), named ? "" : " ",
                       named ? "" : runtime.version());
}

HeadsetStation::HeadsetStation(std::unique_ptr<State> state) : state_(std::move(state)) {}
HeadsetStation::~HeadsetStation() = default;

Result<std::unique_ptr<HeadsetStation>> HeadsetStation::open(const assets::Avatar& avatar,
                                                             const HeadsetStationOptions& options) {
    // The runtime first: without one no window flashes up.
    auto runtime = XrRuntime::open();
    if (!runtime) return tl::unexpected(runtime.error());
    auto state = std::make_unique<State>(options, std::move(*runtime), avatarEyeHeight(avatar));
    State& s = *state;
    auto window = GlWindow::open(options.title, options.window_size, false);
    if (!window) return tl::unexpected(window.error());
    s.window = std::move(*window);
    s.operator_window = std::make_unique<OperatorWindow>(*s.window);
    auto session = XrSessionLoop::open(s.runtime, *s.window,
                                       {options.resolution_scale, options.study.assumed_eye_height_m});
    if (!session) return tl::unexpected(session.error());
    s.session = std::move(*session);
    s.input =
        std::make_unique<XrInput>(s.runtime, s.session->handle(),
                                  XrInputOptions{options.study.record_gaze, options.study.record_hands});
    auto picture = HeadsetPicture::create(avatar, *s.session);
    if (!picture) return tl::unexpected(picture.error());
    s.picture = std::move(*picture);
    s.picture->warmUp(avatar);
    s.utc_offset_s = utcNow_s() - s.session->now_s();

    // A first frame tells the refresh rate and the eyes' distance, where somebody is there already.
    try {
        const double until_s = s.session->now_s() + first_frame_s;
        while (s.session->now_s() < until_s && s.ipd_m == 0.0) {
            s.handleWindow();
            s.handleRuntime();
            if (s.failure) return tl::unexpected(*s.failure);
            s.beginXrFrame();
            if (!s.frame) continue;
            if (const auto eyes = s.session->locateEyes(*s.frame)) s.noteEyes(*eyes);
            s.endUnseen();
        }
    } catch (const XrFailure& failure) {
        if (!failure.lost()) throw;
        return fail("headset",
                    fmt::format("the connection to the OpenXR runtime was lost ({})", failure.what()),
                    "Start the runtime again, then try again");
    }
    if (s.runtime.has("XR_FB_display_refresh_rate"))
        if (const auto rate =
                s.runtime.function<PFN_xrGetDisplayRefreshRateFB>("xrGetDisplayRefreshRateFB")) {
            float hz = 0.0F;
            if (XR_SUCCEEDED(rate(s.session->handle(), &hz))) s.refresh_rate_hz = hz;
        }
    if (s.refresh_rate_hz <= 0.0 && s.session->period_s() > 0.0)
        s.refresh_rate_hz = 1.0 / s.session->period_s();
    return std::unique_ptr<HeadsetStation>(new HeadsetStation(std::move(state)));
}

studies::StationInfo HeadsetStation::info() const {
    const State& s = *state_;
    const XrSwapchainSize& size = s.session->eyeSize();
    const char* mode = s.picture->multiview() ? "one pass for both eyes" : "one pass for each eye";
    studies::StationInfo info;
    info.kind = studies::StationKind::headset;
    info.details = fmt::format("{}, 2 x {}x{} pixels, {:.0f} Hz, {}, {}", deviceWords(s.runtime), size.width,
                               size.height, s.refresh_rate_hz, mode, s.picture->driver());
    const std::string assumed_m = fmt::format("{:.2f}", s.options.study.assumed_eye_height_m);
    if (!s.session->knowsFloor())
        info.details += fmt::format(", no floor known: the eyes are taken to be {} m above it", assumed_m);
    info.controls = "Trigger: select.  Menu button: pause.  Thumbstick held for a second: recentre.";
    info.hint = state_->options.hint;
    const auto yesNo = [](bool yes) { return std::string(yes ? "yes" : "no"); };
    info.properties = {
        {"runtime", s.runtime.name()},
        {"runtime_version", s.runtime.version()},
        {"system", s.runtime.systemName()},
        {"refresh_rate_hz", s.refresh_rate_hz > 0.0 ? fmt::format("{:.3f}", s.refresh_rate_hz) : ""},
        {"ipd_m", s.ipd_m > 0.0 ? fmt::format("{:.4f}", s.ipd_m) : ""},
        {"eye_picture_px", fmt::format("{}x{}", size.width, size.height)},
        {"space", s.session->spaceName()},
        {"stereo", s.picture->multiview() ? "multiview" : "two passes"},
        {"depth_layer", yesNo(s.session->hasDepth())},
        {"visibility_mask", yesNo(s.runtime.has("XR_KHR_visibility_mask"))},
        {"eye_gaze", yesNo(s.options.study.record_gaze && s.runtime.tracksEyes())},
        {"hand_joints", yesNo(s.options.study.record_hands && s.runtime.tracksHands())},
        {"driver", s.picture->driver()}};
    if (!s.session->knowsFloor()) info.properties.emplace_back("assumed_eye_height_m", assumed_m);
    return info;
}

studies::InputFrame HeadsetStation::beginFrame() {
    State& s = *state_;
    studies::InputFrame input;
    try {
        if (!s.failure && !s.joined) s.waitUntilWorn();
        if (!s.failure) {
            s.handleWindow();
            s.handleRuntime();
        }
        if (!s.failure) s.beginXrFrame();
    } catch (const XrFailure& failure) {
        s.lose(failure);
    }
    s.readInput(input);
    for (auto& note : s.place.takeNotes()) s.notes.push_back(std::move(note));
    input.notes = std::exchange(s.notes, {});
    return input;
}

studies::FrameReport HeadsetStation::present(const studies::PresentedFrame& frame) {
    State& s = *state_;
    studies::FrameReport report{frame.number};
    report.display_time_s = s.last_time_s;
    // Where the participant is moved to another place, this frame is the first there: so it is drawn and
    // kept.
    s.place.stand(frame.stage_from_viewer, s.session->now_s());
    s.placement = s.place.placement();
    s.presented = frame;
    try {
        if (s.frame) {
            report.shown = s.drawFrame(frame);
            if (frame.tick) s.input->tick(s.pointing_hand.hand());
            report.tracking = s.sample(frame.number);
            report.tracking->rendered = report.shown;
            s.frame.reset();
        }
    } catch (const XrFailure& failure) {
        s.lose(failure);
        report.shown = false;
    }
    if (!s.failure) s.showOperator();
    return report;
}

std::vector<studies::StationNote> HeadsetStation::close() {
    State& s = *state_;
    try {
        s.session->requestExit();
        const double until_s = s.session->now_s() + leave_taking_s;
        bool left = s.failure.has_value();
        while (!left && s.session->now_s() < until_s) {
            XrEvents events = s.session->poll();
            for (auto& note : events.notes) s.notes.push_back(std::move(note));
            left = events.leave || events.lost.has_value();
            if (left) break;
            s.frame = s.session->begin();
            if (s.frame)
                s.endUnseen();
            else
                std::this_thread::sleep_for(std::chrono::duration<double>(hidden_wait_s));
        }
    } catch (const XrFailure& failure) {
        s.note(studies::NoteKind::xr_state, fmt::format("lost: {}", failure.what()));
    }
    return std::exchange(s.notes, {});
}

std::optional<Error> HeadsetStation::failure() const {
    return state_->failure;
}

}  // namespace deixis::app
