#include "studies/session/replay.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

#include "avatar_poser.hpp"
#include "ball_met.hpp"
#include "motion/skeleton/clip.hpp"
#include "session_unit.hpp"
#include "studies/study_file/stage_kind.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::studies {

namespace {

constexpr double before_s = 1.0;        // of a trial of which nothing is known before its first clip
constexpr double after_s = 1.0;         // that are shown of the answer given
constexpr double longest_gap_s = 0.25;  // between samples that are joined

using TrackedPart = const TrackedPose& (*)(const TrackingSample&, std::size_t);

const TrackedPose& headOf(const TrackingSample& sample, std::size_t) {
    return sample.head;
}

const TrackedPose& aimOf(const TrackingSample& sample, std::size_t hand) {
    return sample.aim[hand];
}

// Rotations are kept in steps of 2^-15, each a little off unit length: at a few metres that would make a ray
// miss what it met.
Pose poseOf(const TrackedPose& tracked) {
    return {tracked.stage_from_device.position, glm::normalize(tracked.stage_from_device.orientation)};
}

Ray rayOf(const Pose& aim) {
    return {aim.position, aim.orientation * Vec3(0.0, 0.0, -1.0)};
}

// The first sample at or after a time.
auto sampleAt(const std::vector<TrackingSample>& samples, double time_s) {
    return std::lower_bound(samples.begin(), samples.end(), time_s,
                            [](const TrackingSample& sample, double t) { return sample.display_time_s < t; });
}

// The hand whose ray was nearest to the one that answered.
std::size_t pointingHand(const RecordedTrial& recorded) {
    constexpr std::size_t right = 1;
    const auto sample = sampleAt(recorded.tracking, recorded.answered_s);
    if (!recorded.pointer || sample == recorded.tracking.end()) return right;
    std::size_t best = right;
    double min_rad = pi;
    for (const std::size_t hand : {std::size_t{1}, std::size_t{0}}) {
        if (!sample->aim[hand].valid()) continue;
        const double off_rad =
            angleBetween(rayOf(poseOf(sample->aim[hand])).direction, recorded.pointer->direction);
        if (off_rad >= min_rad) continue;
        min_rad = off_rad;
        best = hand;
    }
    return best;
}

bool showsPair(const Trial& trial) {
    return declarationOf(trial.kind).arrangement == Arrangement::sides;
}

std::vector<BallView> ballsOf(const RecordedTrial& recorded) {
    std::vector<BallView> balls;
    for (int place = 0; place < static_cast<int>(recorded.trial.ball_order.size()); ++place)
        balls.push_back({recorded.trial.ball(place), recorded.ball_diameter_m / 2.0, BallLook::waiting});
    return balls;
}

}  // namespace

int ballMetBy(const RecordedTrial& recorded, const Ray& ray) {
    return nearestBall(ballsOf(recorded), ray).place;
}

TrialReplay::TrialReplay(const RecordedTrial& recorded, const ClipSource& clips,
                         const motion::Skeleton& avatar, const motion::LocalPose& idle_pose)
    : recorded_(recorded), clips_(clips), avatar_(avatar), idle_(idle_pose), hand_(pointingHand(recorded)) {
    const double first_s = recorded.plays.empty() ? recorded.open_s : recorded.plays.front().onset_s;
    begin_s_ = first_s - before_s;
    if (!recorded.tracking.empty()) begin_s_ = std::min(begin_s_, recorded.tracking.front().display_time_s);
    end_s_ = std::max(recorded.answered_s, first_s) + after_s;
    for (const RecordedPlay& play : recorded.plays)
        if (play.stimulus < 0 || static_cast<std::size_t>(play.stimulus) >= recorded.trial.stimuli.size())
            throw std::invalid_argument("a recorded play of a stimulus that is not in its trial");
}

std::vector<Pose> TrialReplay::joints(double time_s, int avatar_place) const {
    const bool pair = showsPair(recorded_.trial);
    AvatarPoser poser(avatar_, idle_);
    if (pair) poser.standAt(pairPlaces(viewerPose(recorded_.layout))[static_cast<std::size_t>(avatar_place)]);
    const RecordedPlay* playing = nullptr;
    const RecordedPlay* next = nullptr;
    for (const RecordedPlay& play : recorded_.plays) {
        if (pair && play.stimulus != avatar_place) continue;
        if (play.onset_s <= time_s)
            playing = &play;
        else if (next == nullptr)
            next = &play;
    }
    const auto clipOf = [&](const RecordedPlay& play) -> const motion::Clip& {
        return clips_.clip(recorded_.trial.stimuli[static_cast<std::size_t>(play.stimulus)]);
    };
    const bool approaches = next != nullptr && next->onset_s - time_s < AvatarPoser::blend_s;
    if (playing != nullptr && !approaches && time_s <= recorded_.answered_s + after_s)
        poser.show(clipOf(*playing),
                   std::clamp(time_s - playing->onset_s, 0.0, clipOf(*playing).duration_s()));
    if (approaches) {
        poser.blendTo(clipOf(*next).frames.front(), next->onset_s - AvatarPoser::blend_s);
        poser.advance(time_s);
    }
    std::vector<Pose> out;
    poser.write(out);
    return out;
}

PresentedFrame TrialReplay::at(double time_s) const {
    PresentedFrame frame;
    frame.stage = recorded_.trial.stage;
    frame.viewer_place = recorded_.layout.name;
    frame.stage_from_viewer = viewerPose(recorded_.layout);
    frame.avatar_joints = joints(time_s, 0);
    if (showsPair(recorded_.trial)) frame.right_avatar_joints = joints(time_s, 1);
    const auto pointed = pointer(time_s);
    const bool open = time_s >= recorded_.open_s;
    const bool answered = time_s >= recorded_.answered_s;
    const auto replayed = unitOf(recorded_.trial.kind).replayed;
    frame.balls = replayed != nullptr ? replayed(recorded_, time_s) : ballsOf(recorded_);
    BallMet met;
    if (pointed && open) met = nearestBall(frame.balls, *pointed);
    for (std::size_t i = 0; i < frame.balls.size() && replayed == nullptr; ++i) {
        const int place = static_cast<int>(i);
        BallLook& look = frame.balls[i].look;
        if (open) look = BallLook::selectable;
        if (open && !answered && place == met.place) look = BallLook::hovered;
        if (answered && place == recorded_.chosenPlace()) look = BallLook::chosen;
    }
    if (pointed && open) frame.ray = RayView{*pointed, met.place >= 0 ? met.distance_m : free_ray_m};
    return frame;
}

std::optional<Pose> TrialReplay::tracked(double time_s, TrackedPart of) const {
    const auto& samples = recorded_.tracking;
    const auto after = sampleAt(samples, time_s);
    if (after == samples.end() || !of(*after, hand_).valid()) return std::nullopt;
    if (after->display_time_s == time_s) return poseOf(of(*after, hand_));
    if (after == samples.begin()) return std::nullopt;
    const auto before = after - 1;
    const double gap_s = after->display_time_s - before->display_time_s;
    if (!of(*before, hand_).valid() || gap_s > longest_gap_s) return std::nullopt;
    return motion::interpolate(poseOf(of(*before, hand_)), poseOf(of(*after, hand_)),
                               (time_s - before->display_time_s) / gap_s);
}

std::optional<Pose> TrialReplay::head(double time_s) const {
    return tracked(time_s, headOf);
}

std::optional<Ray> TrialReplay::pointer(double time_s) const {
    const auto aim = tracked(time_s, aimOf);
    return aim ? std::optional<Ray>(rayOf(*aim)) : std::nullopt;
}

std::vector<Vec3> TrialReplay::trail(double time_s, double length_s, TrackedPart of) const {
    std::vector<Vec3> out;
    for (auto sample = sampleAt(recorded_.tracking, time_s - length_s);
         sample != recorded_.tracking.end() && sample->display_time_s <= time_s; ++sample)
        if (of(*sample, hand_).valid()) out.push_back(of(*sample, hand_).stage_from_device.position);
    return out;
}

std::vector<Vec3> TrialReplay::headTrail(double time_s, double length_s) const {
    return trail(time_s, length_s, headOf);
}

std::vector<Vec3> TrialReplay::handTrail(double time_s, double length_s) const {
    return trail(time_s, length_s, aimOf);
}

}  // namespace deixis::studies
