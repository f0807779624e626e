#include "feet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/pointing/two_bone_ik.hpp"
#include "motion/skeleton/bone_index.hpp"
#include "motion/skeleton/kinematics.hpp"
#include "motion/skeleton/minimum_jerk.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

constexpr double low_m = 0.06;
constexpr double left_m = 0.09;
constexpr double slow_m_s = 0.3;
constexpr double fast_m_s = 0.5;
constexpr VelocitySpan speed_span{0.025, 0.025};
constexpr double longest_gap_s = 0.06;
constexpr double shortest_contact_s = 0.10;
constexpr double fade_s = 0.3;
constexpr double longest_slide_m = 0.12;
constexpr double smoothing_s = 0.1;
constexpr double deepest_drop_m = 0.1;
constexpr double stretched = 0.9995;  // share of the leg's length to which a leg is stretched

/// Mean over the frames up to `reach` away.
std::vector<double> smoothed(const std::vector<double>& values, std::size_t reach) {
    std::vector<double> sums(values.size() + 1, 0.0);
    for (std::size_t f = 0; f < values.size(); ++f) sums[f + 1] = sums[f] + values[f];
    std::vector<double> out(values.size());
    for (std::size_t f = 0; f < values.size(); ++f) {
        const std::size_t first = f < reach ? 0 : f - reach;
        const std::size_t last = std::min(values.size(), f + reach + 1);
        out[f] = (sums[last] - sums[first]) / static_cast<double>(last - first);
    }
    return out;
}

/// Runs of `value` that are shorter than `min` become the other, but for those at the ends of the clip.
void dropShortRuns(std::vector<char>& contact, char value, std::size_t min) {
    std::size_t begin = 0;
    while (begin < contact.size()) {
        std::size_t end = begin;
        while (end < contact.size() && contact[end] == contact[begin]) ++end;
        if (contact[begin] == value && end - begin < min && begin > 0 && end < contact.size())
            std::fill(contact.begin() + static_cast<std::ptrdiff_t>(begin),
                      contact.begin() + static_cast<std::ptrdiff_t>(end), static_cast<char>(!value));
        begin = end;
    }
}

double horizontal(const Vec3& v) {
    return std::hypot(v.x, v.z);
}

/// A run of frames in which a foot stands.
struct Stand {
    std::size_t first, last;
};

class Foot {
  public:
    Foot(const AvatarRest& avatar, Side side, const std::vector<BodyFrame>& frames, double frame_time_s)
        : avatar_(avatar),
          sole_(soleOf(avatar, side)),
          upper_(side == Side::left ? leftUpperLeg : rightUpperLeg),
          lower_(side == Side::left ? leftLowerLeg : rightLowerLeg),
          leg_{avatar.offset[indexOf(lower_)], avatar.offset[indexOf(sole_.foot)], Vec3(1, 0, 0)},
          frame_time_s_(frame_time_s) {
        readPath(frames);
        levelWhereFlat();
        findShifts();
        keepAboveFloor();
    }

    /// How far the hips must come down so that the foot can stand where it should; 0 where it stands free.
    [[nodiscard]] double dropNeeded(std::size_t f) const {
        if (!stands(f)) return 0.0;
        const double length = glm::length(leg_.upper) + glm::length(leg_.lower);
        const double reach_m = std::max(stretched * length, glm::length(ankle_[f] - hip_[f]));
        const Vec3 way = hip_[f] - (ankle_[f] + shift_[f]);
        const double below2 = reach_m * reach_m - way.x * way.x - way.z * way.z;
        if (glm::length(way) <= reach_m || below2 <= 0.0) return 0.0;
        return std::clamp(way.y - std::sqrt(below2), 0.0, deepest_drop_m);
    }

    /// Turns the leg's bones of a frame whose hips have come down by `drop_m`.
    void apply(BodyFrame& frame, std::size_t f, double drop_m) {
        const Vec3 hip = hip_[f] - Vec3(0.0, drop_m, 0.0);
        const Vec3 goal = ankle_[f] + shift_[f];
        Quat& foot = frame.rotation[indexOf(sole_.foot)];
        if (const Quat levelling = turn_[f] * glm::conjugate(foot); turn_[f] != foot) {
            Quat& toes = frame.rotation[indexOf(sole_.toes)];
            toes = levelling * toes;
            foot = turn_[f];
        }
        const bool still = drop_m == 0.0 && shift_[f] == Vec3(0.0);
        if (!still) reach(leg_, goal - hip, frame.rotation[indexOf(upper_)], frame.rotation[indexOf(lower_)]);
        const Vec3 ankle =
            hip + frame.rotation[indexOf(upper_)] * leg_.upper + frame.rotation[indexOf(lower_)] * leg_.lower;
        shift_[f] = still ? Vec3(0.0) : ankle - ankle_[f];
        lowest_ = std::min({lowest_, (ankle + foot * sole_.heel).y, (ankle + foot * sole_.ball).y});
        if (sole_.tip) lowest_ = std::min(lowest_, bendToes(frame, ankle));
    }

    /// The height of the sole's lowest point in the frames so far.
    [[nodiscard]] double lowest() const { return lowest_; }

    /// Adds the way that the standing point slides, and the time that the foot stands.
    void addSlide(double& before_m, double& after_m, std::size_t& steps) const {
        for (std::size_t f = 1; f < heel_.size(); ++f) {
            if (!stands(f) || !stands(f - 1) || on_ball_[f] != on_ball_[f - 1]) continue;
            const auto& path = on_ball_[f] ? ball_ : heel_;
            const Vec3 way = path[f] - path[f - 1];
            before_m += horizontal(way);
            after_m += horizontal(way + shift_[f] - shift_[f - 1]);
            ++steps;
        }
    }
    [[nodiscard]] std::size_t standingFrames() const {
        std::size_t count = 0;
        for (std::size_t f = 0; f < heel_.size(); ++f) count += stands(f) ? 1 : 0;
        return count;
    }

  private:
    [[nodiscard]] bool stands(std::size_t f) const { return on_heel_[f] || on_ball_[f]; }

    void readPath(const std::vector<BodyFrame>& frames) {
        for (auto* path : {&hip_, &ankle_, &heel_, &ball_}) path->reserve(frames.size());
        turn_.reserve(frames.size());
        const Vec3 to_hip = avatar_.offset[indexOf(upper_)];
        for (const BodyFrame& frame : frames) {
            const Quat& turn = frame.rotation[indexOf(sole_.foot)];
            hip_.push_back(hipsPosition(avatar_, frame) + frame.rotation[indexOf(hips)] * to_hip);
            ankle_.push_back(hip_.back() + frame.rotation[indexOf(upper_)] * leg_.upper +
                             frame.rotation[indexOf(lower_)] * leg_.lower);
            heel_.push_back(ankle_.back() + turn * sole_.heel);
            ball_.push_back(ankle_.back() + turn * sole_.ball);
            turn_.push_back(turn);
        }
        on_heel_ = floorContacts(heel_, frame_time_s_);
        on_ball_ = floorContacts(ball_, frame_time_s_);
    }

    void levelWhereFlat() {
        std::vector<double> flat(heel_.size());
        for (std::size_t f = 0; f < flat.size(); ++f) flat[f] = on_heel_[f] && on_ball_[f] ? 1.0 : 0.0;
        flat = smoothed(flat, framesIn(smoothing_s / 2.0, frame_time_s_));
        for (std::size_t f = 0; f < flat.size(); ++f) {
            const Vec3 along = ball_[f] - heel_[f];
            const Vec3 level(along.x, 0.0, along.z);
            if (flat[f] <= 0.0 || along.y == 0.0 || horizontal(along) < 1e-6) continue;
            const Quat turn = glm::slerp(no_rotation, rotationBetween(along, level), minimumJerk(flat[f]));
            turn_[f] = turn * turn_[f];
            heel_[f] = ankle_[f] + turn_[f] * sole_.heel;
            ball_[f] = ankle_[f] + turn_[f] * sole_.ball;
        }
    }

    /// Shifts of one stand from its first frame on, in which it is not shifted sideways; ends early where it
    /// slides too far.
    std::size_t holdFrom(std::size_t first, std::size_t end) {
        bool ball = on_ball_[first] != 0;
        Vec3 anchor = ball ? ball_[first] : heel_[first];
        for (std::size_t f = first; f < end; ++f) {
            const Vec3 before = f == first ? Vec3(0.0) : shift_[f - 1];
            if (const bool now = on_ball_[f] != 0; now != ball) {
                ball = now;
                anchor = (ball ? ball_[f] : heel_[f]) + before;
            }
            const Vec3 shift = anchor - (ball ? ball_[f] : heel_[f]);
            if (horizontal(shift) > longest_slide_m) return f;
            shift_[f] = Vec3(shift.x, 0.0, shift.z);
        }
        return end;
    }

    void findShifts() {
        const std::size_t count = heel_.size();
        shift_.assign(count, Vec3(0.0));
        std::vector<double> ball_share(count);
        for (std::size_t f = 0; f < count; ++f) ball_share[f] = on_ball_[f] ? 1.0 : 0.0;
        ball_share = smoothed(ball_share, framesIn(smoothing_s / 2.0, frame_time_s_));

        std::vector<Stand> stands_found;
        for (std::size_t f = 0; f < count;) {
            if (!stands(f)) {
                ++f;
                continue;
            }
            std::size_t end = f;
            while (end < count && stands(end)) ++end;
            const std::size_t held = holdFrom(f, end);
            Vec3 mean(0.0);
            for (std::size_t i = f; i < held; ++i) mean += shift_[i] / static_cast<double>(held - f);
            for (std::size_t i = f; i < held; ++i) {
                shift_[i] -= mean;
                const double height = ball_share[i] * ball_[i].y + (1.0 - ball_share[i]) * heel_[i].y;
                shift_[i].y = -height;
            }
            stands_found.push_back({f, held - 1});
            f = held;
            // A foot that slid away is let go for a moment, so that it can come to its next place.
            for (const std::size_t rest = std::min(end, held + framesIn(fade_s, frame_time_s_));
                 held < end && f < rest; ++f)
                on_heel_[f] = on_ball_[f] = 0;
        }
        bridge(stands_found);
    }

    /// Shifts between stands.
    void bridge(const std::vector<Stand>& stands_found) {
        const auto fade = static_cast<double>(framesIn(fade_s, frame_time_s_));
        const auto fadeOut = [&](std::size_t from, std::size_t to) {  // frames from < f < to, either may be
            const bool behind = from < heel_.size();                  // outside: no stand there
            const bool ahead = to < heel_.size();
            for (std::size_t f = behind ? from + 1 : 0; f < std::min(to, heel_.size()); ++f) {
                Vec3 shift(0.0);
                if (behind) shift += shift_[from] * (1.0 - minimumJerk(static_cast<double>(f - from) / fade));
                if (ahead) shift += shift_[to] * (1.0 - minimumJerk(static_cast<double>(to - f) / fade));
                shift_[f] = shift;
            }
        };
        if (stands_found.empty()) return;
        fadeOut(heel_.size(), stands_found.front().first);
        for (std::size_t i = 0; i + 1 < stands_found.size(); ++i) {
            const std::size_t from = stands_found[i].last;
            const std::size_t to = stands_found[i + 1].first;
            const auto gap = static_cast<double>(to - from);
            if (gap > 2.0 * fade) {
                fadeOut(from, to);
                continue;
            }
            for (std::size_t f = from + 1; f < to; ++f) {
                const double share = minimumJerk(static_cast<double>(f - from) / gap);
                shift_[f] = (1.0 - share) * shift_[from] + share * shift_[to];
            }
        }
        fadeOut(stands_found.back().last, heel_.size());
    }

    void keepAboveFloor() {
        for (std::size_t f = 0; f < heel_.size(); ++f) {
            const double lowest = std::min(heel_[f].y, ball_[f].y) + shift_[f].y;
            if (lowest < 0.0) shift_[f].y -= lowest;
        }
    }

    /// Gives the height of the toes' tip.
    double bendToes(BodyFrame& frame, const Vec3& ankle) const {
        const Vec3 start = ankle + frame.rotation[indexOf(sole_.foot)] * avatar_.offset[indexOf(sole_.toes)];
        Quat& turn = frame.rotation[indexOf(sole_.toes)];
        const Vec3 way = turn * *sole_.tip;
        const double length = glm::length(way);
        const double across = horizontal(way);
        if (start.y + way.y >= 0.0 || across < 1e-6 || start.y > length) return start.y + way.y;
        const double along = std::sqrt(length * length - start.y * start.y) / across;
        turn = rotationBetween(way, Vec3(way.x * along, -start.y, way.z * along)) * turn;
        return 0.0;
    }

    const AvatarRest& avatar_;
    Sole sole_;
    Bone upper_, lower_;
    TwoBones leg_;
    double frame_time_s_;
    std::vector<Vec3> hip_, ankle_, heel_, ball_;  // as they come; heel and ball levelled
    std::vector<Quat> turn_;                       // of the foot, levelled
    std::vector<Vec3> shift_;                      // of the ankle
    std::vector<char> on_heel_, on_ball_;
    double lowest_ = 1e9;
};

}  // namespace

std::vector<char> floorContacts(const std::vector<Vec3>& point, double frame_time_s) {
    const std::size_t count = point.size();
    const std::vector<double> speed = speeds(point, frame_time_s, speed_span);
    std::vector<char> contact(count, 0);
    bool on = false;
    for (std::size_t f = 0; f < count; ++f) {
        const double height = point[f].y;
        on = on ? speed[f] < fast_m_s && height < left_m : speed[f] < slow_m_s && height < low_m;
        contact[f] = on ? 1 : 0;
    }
    dropShortRuns(contact, 0, framesIn(longest_gap_s, frame_time_s));
    dropShortRuns(contact, 1, framesIn(shortest_contact_s, frame_time_s));
    return contact;
}

PlantedFeet plantFeet(const AvatarRest& avatar, std::vector<BodyFrame>& frames, double frame_time_s) {
    PlantedFeet report;
    std::array<Foot, 2> feet{Foot(avatar, Side::left, frames, frame_time_s),
                             Foot(avatar, Side::right, frames, frame_time_s)};

    std::vector<double> drop(frames.size());
    for (std::size_t f = 0; f < drop.size(); ++f)
        drop[f] = std::max(feet[0].dropNeeded(f), feet[1].dropNeeded(f));
    const std::size_t reach_frames = framesIn(smoothing_s, frame_time_s);
    std::vector<double> widened = drop;
    for (std::size_t f = 0; f < drop.size(); ++f) {
        if (drop[f] == 0.0) continue;
        const std::size_t end = std::min(drop.size(), f + reach_frames + 1);
        for (std::size_t i = f < reach_frames ? 0 : f - reach_frames; i < end; ++i)
            widened[i] = std::max(widened[i], drop[f]);
    }
    drop = smoothed(widened, reach_frames);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (drop[f] < 1e-9) drop[f] = 0.0;
        frames[f].hip_centre.y -= drop[f];
        for (Foot& foot : feet) foot.apply(frames[f], f, drop[f]);
    }

    double before_m = 0.0;
    double after_m = 0.0;
    std::size_t steps = 0;
    std::size_t standing_frames = 0;
    for (const Foot& foot : feet) {
        foot.addSlide(before_m, after_m, steps);
        standing_frames += foot.standingFrames();
    }
    report.standing_share = static_cast<double>(standing_frames) / (2.0 * static_cast<double>(frames.size()));
    if (steps > 0) {
        report.before_m_s = before_m / (static_cast<double>(steps) * frame_time_s);
        report.after_m_s = after_m / (static_cast<double>(steps) * frame_time_s);
    }
    report.lowest_after_m = std::min(feet[0].lowest(), feet[1].lowest());
    return report;
}

}  // namespace deixis::motion
