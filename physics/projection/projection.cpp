#include "physics/projection/projection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "angle_track.hpp"
#include "core/random.hpp"
#include "physics/figure/figure_pose.hpp"
#include "physics/figure/mjcf.hpp"

namespace deixis::physics {

namespace {

using motion::Bone;
using motion::Clip;

bool finite(const Pose& pose) {
    const Vec3& p = pose.position;
    const Quat& q = pose.orientation;
    return std::isfinite(p.x + p.y + p.z) && std::isfinite(q.w + q.x + q.y + q.z);
}

Result<void> check(const Figure& figure, const Clip& clip) {
    const auto& joints = clip.skeleton.joints;
    const auto& expected = figure.skeleton.joints;
    bool same = joints.size() == expected.size();
    for (std::size_t i = 0; same && i < joints.size(); ++i)
        same = joints[i].name == expected[i].name && joints[i].parent == expected[i].parent;
    if (!same)
        return fail("", "found a clip of another skeleton, expected that of the avatar that the body has",
                    "Retarget it to the avatar first");
    if (!(clip.frame_time_s > 0.0) || clip.frames.empty())
        return fail("", "found a clip without frames, expected at least one");
    for (std::size_t f = 0; f < clip.frames.size(); ++f)
        for (std::size_t j = 0; j < joints.size(); ++j)
            if (!finite(clip.frames[f].joints[j]))
                return fail(
                    "",
                    fmt::format("frame {}, joint '{}': found a number that is not finite", f, joints[j].name),
                    "Frames count from 0");
    return {};
}

/// What the body is to follow.
struct Reference {
    AngleTrack angles;
    double fit_distance_m = 0.0;
    double beyond_rad = 0.0;
    std::size_t beyond_hinge = 0;
};

Reference referenceOf(const Figure& figure, const Clip& clip) {
    std::vector<std::vector<double>> frames;
    Reference out{AngleTrack({{}}, clip.frame_time_s)};
    for (const motion::LocalPose& pose : clip.frames) {
        PoseFit fit = fitPose(figure, pose);
        out.fit_distance_m = std::max(out.fit_distance_m, fit.distance_m);
        if (fit.beyond_rad > out.beyond_rad) {
            out.beyond_rad = fit.beyond_rad;
            out.beyond_hinge = fit.beyond_hinge;
        }
        frames.push_back(std::move(fit.angles_rad));
    }
    out.angles = AngleTrack(std::move(frames), clip.frame_time_s);
    return out;
}

class Follower {
  public:
    Follower(Body& body, const Clip& clip, const Reference& reference, const ProjectionSettings& settings)
        : body_(body),
          clip_(clip),
          reference_(reference),
          settings_(settings),
          noise_(settings.seed, "projection") {
        if (settings.feed_forward) ahead_.emplace(body);
    }

    Followed run() {
        BodyState start = stateAt(0.0);
        body_.setState(start);
        Followed out;
        out.states.push_back(std::move(start));
        const auto steps = static_cast<std::size_t>(std::ceil(clip_.duration_s() / step_s - 1e-6));
        while (out.states.size() <= steps) {
            const std::size_t done = out.states.size() - 1;
            if (done % steps_per_control == 0)
                out.targets_rad.push_back(targetsFor(static_cast<double>(done) * step_s));
            if (body_.figure().stance == Stance::pinned)
                body_.moveRoot(rootAt(static_cast<double>(done) * step_s));
            body_.step(out.targets_rad.back(), 1);
            out.states.push_back(body_.state());
        }
        return out;
    }

  private:
    [[nodiscard]] Pose rootAt(double time_s) const {
        return rootOf(body_.figure(), motion::sample(clip_, time_s));
    }

    [[nodiscard]] BodyState stateAt(double time_s) const {
        BodyState state;
        state.root.pose = rootAt(time_s);
        reference_.angles.at(time_s, state.angles_rad, state.speeds_rad_s);
        return state;
    }

    std::vector<double> targetsFor(double time_s) {
        const BodyState middle = stateAt(time_s + 0.5 * control_s);
        std::vector<double> targets = middle.angles_rad;
        if (ahead_) {
            ahead_->setState(middle);
            const std::vector<double> bias = ahead_->biasTorques_nm();
            for (std::size_t i = 0; i < targets.size(); ++i) {
                const Hinge& hinge = body_.figure().hinges[i];
                targets[i] +=
                    (hinge.damping_nms_rad * middle.speeds_rad_s[i] + bias[i]) / hinge.stiffness_nm_rad;
            }
        }
        if (settings_.noise_rad > 0.0)
            for (double& target : targets) target += noise_.normal(0.0, settings_.noise_rad);
        return targets;
    }

    Body& body_;
    const Clip& clip_;
    const Reference& reference_;
    const ProjectionSettings& settings_;
    Random noise_;
    std::optional<Body> ahead_{};  ///< where the body should be
};

/// The first frame in which the pelvis is much lower than the clip's.
std::optional<std::size_t> fallOf(const Figure& figure, const Clip& given, const Clip& made) {
    constexpr double fallen_m = 0.25;
    for (std::size_t f = 0; f < given.frames.size(); ++f)
        if (rootOf(figure, given.frames[f]).position.y - rootOf(figure, made.frames[f]).position.y > fallen_m)
            return f;
    return std::nullopt;
}

/// The clip's pose with the body's angles between two of its states.
motion::LocalPose poseBetween(const Figure& figure, const std::vector<BodyState>& states, double time_s,
                              motion::LocalPose pose) {
    const double place = std::min(time_s / step_s, static_cast<double>(states.size() - 1));
    const auto before = static_cast<std::size_t>(place + 1e-6);  // a frame's time is rarely a step's exactly
    const std::size_t after = std::min(before + 1, states.size() - 1);
    const double share = std::max(0.0, place - static_cast<double>(before));
    std::vector<double> angles = states[before].angles_rad;
    for (std::size_t i = 0; i < angles.size(); ++i)
        angles[i] += share * (states[after].angles_rad[i] - angles[i]);
    applyAngles(figure, angles, pose);
    if (figure.stance == Stance::free)
        applyRoot(figure, motion::interpolate(states[before].root.pose, states[after].root.pose, share),
                  pose);
    return pose;
}

Tracking trackingOf(const Figure& figure, const Clip& given, const Clip& made) {
    constexpr std::array<Bone, 4> bones{Bone::leftLowerArm, Bone::rightLowerArm, Bone::leftHand,
                                        Bone::rightHand};
    Tracking out;
    for (std::size_t f = 0; f < given.frames.size(); ++f) {
        const auto from = motion::worldPose(given.skeleton, given.frames[f]);
        const auto to = motion::worldPose(made.skeleton, made.frames[f]);
        for (const Bone bone : bones) {
            const auto joint = static_cast<std::size_t>(figure.map[bone]);
            const double distance_m = glm::distance(from[joint].position, to[joint].position);
            out.mean_m += distance_m;
            out.max_m = std::max(out.max_m, distance_m);
        }
    }
    out.mean_m /= static_cast<double>(bones.size() * given.frames.size());
    return out;
}

}  // namespace

Result<Followed> follow(Body& body, const Clip& clip, const ProjectionSettings& settings) {
    if (auto fits = check(body.figure(), clip); !fits) return tl::unexpected(fits.error());
    const Reference reference = referenceOf(body.figure(), clip);
    return Follower(body, clip, reference, settings).run();
}

Result<Projection> project(Body& body, const Clip& clip, const ProjectionSettings& settings) {
    const Figure& figure = body.figure();
    if (auto fits = check(figure, clip); !fits) return tl::unexpected(fits.error());
    const Reference reference = referenceOf(figure, clip);
    const auto states = Follower(body, clip, reference, settings).run().states;
    Projection out;
    out.clip.skeleton = clip.skeleton;
    out.clip.frame_time_s = clip.frame_time_s;
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        out.clip.frames.push_back(
            poseBetween(figure, states, static_cast<double>(f) * clip.frame_time_s, clip.frames[f]));
        for (const Pose& pose : out.clip.frames.back().joints)
            if (!finite(pose))
                return fail("", fmt::format("the simulation broke down in frame {}", f),
                            "The clip may move faster than a body can");
    }
    if (const auto frame = fallOf(figure, clip, out.clip))
        return fail("", fmt::format("the body falls; in frame {} it is down", *frame),
                    "A body whose pelvis is held does not fall");
    out.tracking = trackingOf(figure, clip, out.clip);
    out.fit_distance_m = reference.fit_distance_m;
    out.beyond_limit_rad = reference.beyond_rad;
    if (reference.beyond_rad > 0.0) out.beyond_limit_of = figure.hinges[reference.beyond_hinge].name;
    return out;
}

}  // namespace deixis::physics
