#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/order_statistics.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "motion/speech_gestures/pose_control.hpp"

namespace deixis::motion {

namespace {

using Rotations = std::array<Vec3, upper_bone_count>;  ///< rotation vectors, radians

constexpr int shortest_course = 4;  ///< frames
constexpr int longest_course = 30;

/// A pose, and how far the motion is from it.
struct Target {
    int frame = 0;
    Rotations rotation{};
    Rotations speed_before{};  ///< of the rotation, a frame, where it is reached
    Rotations speed_after{};   ///< where it is left
    int before = 0;  ///< frames of the course that leads to it; 0 where the frame before is a target
    int after = 0;   ///< likewise of the one that leads away
};

Vec3 rotated(const Vec3& direction, const Vec3& by) {
    if (by == Vec3(0.0)) return direction;
    return glm::normalize(rotationBy(by) * direction);
}

/// Minimum-jerk course (Flash & Hogan 1985) with speeds at its ends, at share u of `frames`: from `a`, which
/// it leaves with speed `va`, to `b`, reached with `vb`.
Vec3 course(double u, double frames, const Vec3& a, const Vec3& va, const Vec3& b, const Vec3& vb) {
    return a + (b - a) * minimumJerk(u) + frames * (va * minimumJerkLeaving(u) + vb * minimumJerkArriving(u));
}

UpperBodyPose turned(const UpperBodyPose& pose, const Rotations& by) {
    UpperBodyPose out;
    for (std::size_t b = 0; b < upper_bone_count; ++b) out.directions[b] = rotated(pose.directions[b], by[b]);
    return out;
}

/// Of the fastest bone.
double speedAt(const std::vector<UpperBodyPose>& frames, std::size_t f) {
    double most = 0.0;
    for (std::size_t b = 0; b < upper_bone_count; ++b)
        most = std::max(most, glm::length(frames[f].directions[b] - frames[f - 1].directions[b]));
    return most;
}
double accelerationAt(const std::vector<UpperBodyPose>& frames, std::size_t f) {
    double most = 0.0;
    for (std::size_t b = 0; b < upper_bone_count; ++b)
        most = std::max(most, glm::length(frames[f + 1].directions[b] - 2.0 * frames[f].directions[b] +
                                          frames[f - 1].directions[b]));
    return most;
}

double percentile99(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const std::size_t rank = (values.size() - 1) * 99 / 100;
    return orderStatistic(std::move(values), rank);
}

class Meeting {
  public:
    Meeting(UpperBodyMotion& motion, const std::vector<PoseControl>& poses) : motion_(motion) {
        const auto& frames = motion.frames;
        std::vector<double> speeds, accelerations;
        for (std::size_t f = 1; f < frames.size(); ++f) speeds.push_back(speedAt(frames, f));
        for (std::size_t f = 1; f + 1 < frames.size(); ++f)
            accelerations.push_back(accelerationAt(frames, f));
        speed_limit_ = percentile99(std::move(speeds));
        acceleration_limit_ = percentile99(std::move(accelerations));
        for (const PoseControl& one : poses) {
            Target target{one.frame, {}, {}, {}};
            for (std::size_t b = 0; b < upper_bone_count; ++b)
                target.rotation[b] = rotationVector(rotationBetween(
                    frames[static_cast<std::size_t>(one.frame)].directions[b], one.pose.directions[b]));
            targets_.push_back(target);
        }
        for (std::size_t i = 0; i + 1 < targets_.size(); ++i) {
            if (targets_[i + 1].frame != targets_[i].frame + 1) continue;
            for (std::size_t b = 0; b < upper_bone_count; ++b) {
                const Vec3 speed = targets_[i + 1].rotation[b] - targets_[i].rotation[b];
                targets_[i + 1].speed_after[b] = speed;
                targets_[i].speed_before[b] = speed;
            }
        }
    }

    void meet(const std::vector<PoseControl>& poses) {
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            Target& target = targets_[i];
            if (i == 0 || targets_[i - 1].frame < target.frame - 1) target.before = bestCourse(target, -1);
            if (i + 1 == targets_.size() || targets_[i + 1].frame > target.frame + 1)
                target.after = bestCourse(target, 1);
        }
        const UpperBodyMotion given = motion_;
        const int count = static_cast<int>(given.frames.size());
        const auto turnAll = [&](int first, int last, const auto& rotationAt) {
            for (int f = std::max(0, first); f < std::min(last, count); ++f) {
                const auto at = static_cast<std::size_t>(f);
                motion_.frames[at] = turned(given.frames[at], rotationAt(f));
            }
        };
        const auto lead = [&](const Target& to) {
            turnAll(to.frame - to.before + 1, to.frame,
                    [&](int f) { return besideAt(to, -1, to.before, f); });
        };
        const auto leave = [&](const Target& from) {
            turnAll(from.frame + 1, from.frame + from.after,
                    [&](int f) { return besideAt(from, 1, from.after, f); });
        };
        lead(targets_.front());
        for (std::size_t i = 0; i + 1 < targets_.size(); ++i) {
            const Target &a = targets_[i], &b = targets_[i + 1];
            if (a.after + b.before <= b.frame - a.frame) {
                leave(a);
                lead(b);
            } else {
                turnAll(a.frame + 1, b.frame, [&](int f) { return betweenAt(a, b, f); });
            }
        }
        leave(targets_.back());
        for (const PoseControl& one : poses) motion_.frames[static_cast<std::size_t>(one.frame)] = one.pose;
    }

  private:
    /// On a course of `frames` frames that leaves the target towards later frames (side 1) or earlier ones
    /// (-1).
    static Rotations besideAt(const Target& target, int side, int frames, int frame) {
        const double u = static_cast<double>((frame - target.frame) * side) / frames;
        Rotations out;
        for (std::size_t b = 0; b < upper_bone_count; ++b) {
            const Vec3 speed = side > 0 ? target.speed_after[b] : -target.speed_before[b];
            out[b] = course(u, frames, target.rotation[b], speed, Vec3(0.0), Vec3(0.0));
        }
        return out;
    }
    static Rotations betweenAt(const Target& a, const Target& b, int frame) {
        const double frames = b.frame - a.frame;
        Rotations out;
        for (std::size_t bone = 0; bone < upper_bone_count; ++bone)
            out[bone] = course((frame - a.frame) / frames, frames, a.rotation[bone], a.speed_after[bone],
                               b.rotation[bone], b.speed_before[bone]);
        return out;
    }

    /// How far above the limits, as a share of them, the motion is on a course: at most 1 is within.
    [[nodiscard]] double excess(const Target& target, int side, int frames) const {
        const int count = static_cast<int>(motion_.frames.size());
        const int first = side > 0 ? target.frame : std::max(0, target.frame - frames - 1);
        const int last = side > 0 ? std::min(count - 1, target.frame + frames + 1) : target.frame;
        std::vector<UpperBodyPose> made;
        for (int f = first; f <= last; ++f) {
            const UpperBodyPose& given = motion_.frames[static_cast<std::size_t>(f)];
            const bool beyond = std::abs(f - target.frame) >= frames;
            made.push_back(beyond ? given : turned(given, besideAt(target, side, frames, f)));
        }
        double most = 0.0;
        const auto compare = [&most](double value, double limit) {
            if (value > 0.0) most = std::max(most, limit > 0.0 ? value / limit : 1e9 * value);
        };
        for (std::size_t f = 1; f < made.size(); ++f) compare(speedAt(made, f), speed_limit_);
        for (std::size_t f = 1; f + 1 < made.size(); ++f)
            compare(accelerationAt(made, f), acceleration_limit_);
        return most;
    }

    /// The shortest course within the limits, or else the one that is nearest to them.
    [[nodiscard]] int bestCourse(const Target& target, int side) const {
        int best = shortest_course;
        double least = excess(target, side, best);
        for (int frames = shortest_course + 1; frames <= longest_course && least > 1.0; ++frames) {
            const double now = excess(target, side, frames);
            if (now >= least) continue;
            least = now;
            best = frames;
        }
        return best;
    }

    UpperBodyMotion& motion_;
    std::vector<Target> targets_;
    double speed_limit_ = 0.0;
    double acceleration_limit_ = 0.0;
};

}  // namespace

void meetPoses(UpperBodyMotion& motion, std::vector<PoseControl> poses) {
    if (poses.empty()) return;
    std::ranges::sort(poses, {}, &PoseControl::frame);
    Meeting(motion, poses).meet(poses);
}

}  // namespace deixis::motion
