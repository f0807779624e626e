#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "app/window/frame_scene.hpp"
#include "headset_state.hpp"

namespace deixis::app {

namespace {

constexpr double push_m_s = 1.0;  // of what is held, by a stick pushed right through
constexpr double stick_at_rest = 0.15;
constexpr double longest_push_s = 0.1;  // between frames
constexpr double recentre_hold_s = 1.0;
constexpr double idle_wait_s = 0.02;  ///< between polls while the session does not run
constexpr double ipd_changed_m = 0.0005;

const char* handName(studies::Hand hand) {
    return hand == studies::Hand::left ? "left" : "right";
}

}  // namespace

// Nothing more can be asked of the runtime: the session ends, and says why.
void HeadsetStation::State::lose(const XrFailure& by) {
    if (!by.lost()) throw by;
    note(studies::NoteKind::xr_state, fmt::format("lost: {}", by.what()));
    frame.reset();
    quit_reason = "the connection to the headset's runtime was lost";
    failure = Error{
        "headset", fmt::format("the connection to the OpenXR runtime was lost ({})", by.what()),
        fmt::format("Start the runtime again, then run the same command with --participant {}: it goes on at "
                    "the trial that was under way",
                    options.participant)};
}

void HeadsetStation::State::handleWindow() {
    asked.add(operator_window->poll());
    if (std::exchange(asked.recentre, false)) place.recentre("operator");
}

void HeadsetStation::State::handleRuntime() {
    XrEvents events = session->poll();
    for (auto& one : events.notes) notes.push_back(std::move(one));
    if (events.recentred_at) recentre_at = events.recentred_at;
    if (events.hidden_area) picture->updateHiddenArea();
    if (events.lost) throw XrFailure(*events.lost);
    if (events.profiles) noteProfiles();
    if (!events.leave) return;
    quit_reason = "the headset's runtime ended the session";
    failure =
        Error{"headset", "the OpenXR runtime ended the session, as its menu may ask it to",
              fmt::format("Run the same command again with --participant {}: it goes on at the trial that "
                          "was under way",
                          options.participant)};
}

void HeadsetStation::State::noteProfiles() {
    const auto profiles = input->profiles();
    for (const studies::Hand hand : {studies::Hand::left, studies::Hand::right}) {
        const std::string& profile = profiles[static_cast<std::size_t>(hand)];
        note(studies::NoteKind::input_profile,
             fmt::format("{} hand: {}", handName(hand), profile.empty() ? "none" : profile));
    }
}

void HeadsetStation::State::noteEyes(const XrEyes& eyes) {
    const Vec3 apart = eyes.tracking_from_eye[1].position - eyes.tracking_from_eye[0].position;
    const double now_m = std::sqrt(apart.x * apart.x + apart.y * apart.y + apart.z * apart.z);
    if (std::abs(now_m - ipd_m) <= ipd_changed_m) return;
    ipd_m = now_m;
    note(studies::NoteKind::ipd, fmt::format("{:.4f} m", ipd_m));
}

// Begins the runtime's next frame, where its session runs, and reads what is tracked at its display time.
void HeadsetStation::State::beginXrFrame() {
    frame = session->begin();
    if (!frame) {
        std::this_thread::sleep_for(std::chrono::duration<double>(idle_wait_s));
        device = {};
        head = {};
        return;
    }
    dropped += frame->dropped;
    if (refresh_rate_hz <= 0.0 && session->period_s() > 0.0) {
        refresh_rate_hz = 1.0 / session->period_s();
        note(studies::NoteKind::refresh_rate, fmt::format("{:.3f} Hz", refresh_rate_hz));
    }
    if (last_begun_s > 0.0) {
        const double rate = 1.0 / std::max(1e-4, frame->begun_s - last_begun_s);
        frames_per_s += (rate - frames_per_s) * (frames_per_s > 0.0 ? 0.05 : 1.0);
    }
    last_begun_s = frame->begun_s;
    device = input->read(session->tracking(), frame->display_time,
                         [this](XrTime time) { return session->stationSeconds(time); });
    head = session->locateHead(*frame);
    updateRecentre();
    placement = place.placement();
    // Who is not seen is taken to have stayed.
    if (head.valid()) off_place_m = place.offPlace_m(head.stage_from_device);
}

// Ends the frame under way, where there is one, without a picture.
void HeadsetStation::State::endUnseen() {
    if (!frame) return;
    session->end(*frame, {});
    frame.reset();
}

void HeadsetStation::State::updateRecentre() {
    if (recentre_at && frame->display_time >= *recentre_at) {
        place.recentre("runtime");
        recentre_at.reset();
    }
    if (!device.recentre_held) {
        recentre_held_since_s.reset();
    } else if (!recentre_held_since_s) {
        recentre_held_since_s = frame->begun_s;
    } else if (frame->begun_s - *recentre_held_since_s >= recentre_hold_s) {
        place.recentre("button");
        recentre_held_since_s = std::numeric_limits<double>::infinity();  // once for each hold
    }
    // Nobody's place is taken while nobody wears it.
    const bool worn = session->lifecycle().focused() && head.valid();
    place.update(worn ? std::optional<Pose>(head.stage_from_device) : std::nullopt, frame->begun_s);
}

// Until somebody wears the headset, tracked and in focus; frames without a picture meanwhile, as the runtime
// wants them before it gives the focus.
void HeadsetStation::State::waitUntilWorn() {
    while (!joined && !asked.end) {
        handleWindow();
        handleRuntime();
        if (failure) return;
        beginXrFrame();
        endUnseen();
        joined = session->lifecycle().focused() && place.known();
        showOperator();
    }
    if (joined) noteProfiles();
}

std::optional<studies::PauseReason> HeadsetStation::State::pauseReason() {
    using studies::PauseReason;
    const bool menu = std::exchange(device.menu, false);
    if (!session->lifecycle().visible()) return PauseReason::headset_taken_off;
    if (!session->lifecycle().focused()) return PauseReason::focus_lost;
    if (head_watch.lost(head, session->now_s())) return PauseReason::tracking_lost;
    return menu ? std::optional(PauseReason::menu) : std::nullopt;
}

void HeadsetStation::State::readInput(studies::InputFrame& in) {
    const double now_s = session->now_s();
    in.time_s = std::max(last_time_s, frame ? frame->display_time_s : now_s);
    const double elapsed_s = last_time_s > 0.0 ? std::min(in.time_s - last_time_s, longest_push_s) : 0.0;
    last_time_s = in.time_s;
    in.utc_s = in.time_s + utc_offset_s;
    in.input_time_s = std::min(now_s, in.time_s);
    if (head.valid()) last_stage_from_head = placement.toStage(head.stage_from_device);
    in.stage_from_head = last_stage_from_head;
    in.off_place_m = off_place_m;

    const studies::Hand before = pointing_hand.hand();
    const PointingHand::Press press = pointing_hand.update(device.select);
    const studies::Hand hand = pointing_hand.hand();
    if (hand != before) note(studies::NoteKind::pointing_hand, handName(hand));
    in.select_held = press.held;
    const double pushed = device.farther[static_cast<std::size_t>(hand)];
    if (std::abs(pushed) > stick_at_rest) in.farther_m = pushed * push_m_s * elapsed_s;
    const studies::TrackedPose& aim = device.aim[static_cast<std::size_t>(hand)];
    if (aim.valid()) {
        const Pose& pose = aim.stage_from_device;
        in.pointer = placement.toStage(Ray{pose.position, pose.orientation * Vec3(0, 0, -1)});
        in.select = press.select;
        in.select_time_s = press.time_s;
    }
    const auto pause = pauseReason();
    in.pause = pause.has_value();
    in.pause_reason = pause.value_or(studies::PauseReason::unsaid);
    if (failure) {
        in.quit = true;
        in.quit_reason = quit_reason;
    }
    std::exchange(asked, {}).putInto(in);
}

bool HeadsetStation::State::drawFrame(const studies::PresentedFrame& shown_frame) {
    XrLayers layers;
    bool shown = false;
    if (frame->should_render && session->lifecycle().visible()) {
        if (head.valid() || shown_frame.notice.empty())
            picture->setNotice(shown_frame.notice, head.stage_from_device);
        layers = picture->draw(
            sceneFromFrame(shown_frame, {}), [this] { return session->locateEyes(*frame); },
            place.placement());
        shown = layers.eyes.has_value();
        has_picture = has_picture || shown;
        if (shown)
            noteEyes(*layers.eyes);
        else
            layers = picture->drawUnplaced(options.tracking_lost);
    }
    session->end(*frame, layers);
    return shown;
}

studies::TrackingSample HeadsetStation::State::sample(std::uint64_t number) const {
    const auto inStage = [&](studies::TrackedPose pose) {
        pose.stage_from_device = placement.toStage(pose.stage_from_device);
        return pose;
    };
    studies::TrackingSample out;
    out.frame = number;
    out.display_time_s = frame->display_time_s;
    out.begun_s = frame->begun_s;
    out.submitted_s = session->now_s();
    out.dropped_frames = frame->dropped;
    out.head = inStage(head);
    for (std::size_t hand = 0; hand < 2; ++hand) {
        out.aim[hand] = inStage(device.aim[hand]);
        out.grip[hand] = inStage(device.grip[hand]);
        out.joints[hand] = device.joints[hand];
        for (auto& joint : out.joints[hand]) joint.pose = inStage(joint.pose);
    }
    if (device.gaze) out.gaze = inStage(*device.gaze);
    out.off_place_m = off_place_m;
    return out;
}

OperatorView HeadsetStation::State::operatorView() const {
    OperatorView view;
    if (options.operator_feed) view.feed = *options.operator_feed;
    view.feed.participant = options.participant;
    view.status = presented.status;
    view.doing = stateInWords(presented);
    view.paused = presented.state == studies::PresentedState::paused;
    view.device_kind = "Headset";
    view.device = deviceWords(runtime);
    view.device_state = wordsOf(session->lifecycle().state());
    view.frames_per_s = frames_per_s;
    view.dropped_frames = dropped;
    view.tracked = {
        {"Head", head.tracked}, {"Left", device.aim[0].tracked}, {"Right", device.aim[1].tracked}};
    view.pointer = fmt::format("Ray from the {}", handName(pointing_hand.hand()));
    view.has_place = true;
    if (head.tracked) view.off_place_m = off_place_m;
    view.place_tolerance_m = options.study.place_tolerance_m;
    if (!joined && !session->lifecycle().focused())
        view.warnings.emplace_back("Waiting for the participant to put the headset on.");
    else if (!joined)
        view.warnings.emplace_back(
            "Waiting for the participant to stand still and look ahead. Recentre takes the present place.");
    if (!session->knowsFloor())
        view.warnings.push_back(fmt::format(
            "The runtime knows no floor: the eyes are taken to be {:.2f} m above it. Set up the room in "
            "the runtime for true heights.",
            options.study.assumed_eye_height_m));
    if (joined && session->lifecycle().focused() && !device.aim[0].valid() && !device.aim[1].valid())
        view.warnings.emplace_back(
            "No controller is awake: the participant cannot answer. Press any of its buttons.");
    if (!presented.notice.empty())
        view.warnings.push_back(fmt::format("The participant reads: \"{}\"", presented.notice));
    return view;
}

void HeadsetStation::State::showOperator() {
    if (!operator_window->due()) return;
    const WindowSize mirror = operator_window->mirrorSize();
    renderer::Scene scene;
    if (has_picture) scene = sceneFromFrame(presented, {});
    picture->drawMirror(scene, mirror.width, mirror.height);
    operator_window->show(operatorView());
}

}  // namespace deixis::app
