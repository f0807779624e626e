#include "studies/design/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

constexpr double height_step_m = 0.15;

double onGrid(double metres) {
    return static_cast<double>(std::llround(metres * 1e4)) / 1e4;
}

/// What is in the way of a ball: few of the body's parts are near the line to it.
std::vector<motion::Capsule> inTheWay(const Vec3& eye, const Sphere& ball,
                                      const std::vector<motion::Capsule>& body,
                                      const std::vector<Sphere>& others) {
    std::vector<motion::Capsule> near;
    const auto keep = [&](const motion::Capsule& part) {
        if (motion::capsuleDistance({eye, ball.centre, ball.radius_m}, part) < 0.0) near.push_back(part);
    };
    for (const motion::Capsule& part : body) keep(part);
    for (const Sphere& other : others) keep({other.centre, other.centre, other.radius_m});
    return near;
}

std::vector<Sphere> spheres(const std::vector<Vec3>& centres, double radius_m) {
    std::vector<Sphere> out;
    for (const Vec3& centre : centres) out.push_back({centre, radius_m});
    return out;
}

std::vector<Sphere> without(std::vector<Sphere> balls, std::size_t ball) {
    balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(ball));
    return balls;
}

}  // namespace

Vec3 eyesAt(const Study& study, const Layout& layout, Standing standing) {
    const ViewerPlace place = viewerPlace(layout, standing);
    return {onGrid(place.x_m), onGrid(study.eye_height_m), onGrid(place.z_m)};
}

std::vector<Viewpoint> viewpoints(const Study& study) {
    std::set<std::string> used;
    for (const Stage& stage : study.stages)
        if (declarationOf(stage.kind).balls)
            used.insert(stage.design.layouts.begin(), stage.design.layouts.end());
    std::vector<Viewpoint> out;
    for (const Layout& layout : study.layouts) {
        if (used.count(layout.name) == 0) continue;
        for (const Standing standing : {Standing::headset, Standing::desktop}) {
            Viewpoint& viewpoint = out.emplace_back(Viewpoint{layout.name, standing, {}});
            const Vec3 eyes = eyesAt(study, layout, standing);
            for (const double step : {-1.0, 0.0, 1.0})
                viewpoint.eyes.push_back({eyes.x, onGrid(study.eye_height_m + step * height_step_m), eyes.z});
        }
    }
    return out;
}

StandingAvatar::StandingAvatar(const motion::Skeleton& skeleton, const motion::LocalPose& idle_pose)
    : skeleton_(skeleton),
      map_(motion::mapByVrmNames(skeleton)),
      world_(motion::worldPose(skeleton, idle_pose)),
      at_rest_(motion::bodyShape(skeleton_, map_, world_)) {}

const StandingAvatar& StandingAvatar::reference() {
    static const StandingAvatar avatar(motion::referenceHumanoid(),
                                       motion::relaxedPose(motion::referenceHumanoid()));
    return avatar;
}

Vec3 StandingAvatar::eyes() const {
    const Vec3 eyes = motion::eyePosition(map_, world_);
    return {onGrid(eyes.x), onGrid(eyes.y), onGrid(eyes.z)};
}

std::vector<motion::Capsule> StandingAvatar::pointing(const Vec3& target) const {
    return motion::bodyShape(skeleton_, map_, world_, target);
}

double visibleShare(const Vec3& eye, const Sphere& ball, const std::vector<motion::Capsule>& body,
                    const std::vector<Sphere>& others) {
    const std::vector<motion::Capsule> parts = inTheWay(eye, ball, body, others);
    if (parts.empty()) return 1.0;
    // Points (i, j) of a square grid within a circle of 4.5 steps, the disc's rim: 69. It is turned, so that
    // no upright limb passes between two rows.
    constexpr int steps = 4;
    constexpr int rim_squared = 20;
    const Vec3 ahead = glm::normalize(ball.centre - eye);
    Vec3 aside = glm::cross(ahead, up);
    if (glm::dot(aside, aside) < 1e-6) aside = Vec3(1.0, 0.0, 0.0);
    const Vec3 level = ball.radius_m / 4.5 * glm::normalize(aside);
    const Vec3 steep = glm::cross(level, ahead);
    const Vec3 right = 0.8 * level + 0.6 * steep;
    const Vec3 above = 0.8 * steep - 0.6 * level;
    int points = 0;
    int seen = 0;
    for (int i = -steps; i <= steps; ++i) {
        for (int j = -steps; j <= steps; ++j) {
            if (i * i + j * j > rim_squared) continue;
            ++points;
            const Vec3 point = ball.centre + static_cast<double>(i) * right + static_cast<double>(j) * above;
            const bool hidden = std::any_of(parts.begin(), parts.end(), [&](const motion::Capsule& part) {
                return motion::capsuleDistance({eye, point, 0.0}, part) < 0.0;
            });
            if (!hidden) ++seen;
        }
    }
    return static_cast<double>(seen) / points;
}

double SeenBalls::min() const {
    double min = 1.0;
    for (const std::vector<double>* shares : {&at_rest, &pointing})
        for (const double share : *shares) min = std::min(min, share);
    return min;
}

SeenBalls seenFrom(const Viewpoint& viewpoint, const StandingAvatar& avatar,
                   const std::vector<Sphere>& balls) {
    SeenBalls seen{viewpoint.layout, viewpoint.standing, {}, {}};
    const std::vector<motion::Capsule> pointing = avatar.pointing(balls.front().centre);
    for (std::size_t ball = 0; ball < balls.size(); ++ball) {
        const std::vector<Sphere> others = without(balls, ball);
        double at_rest = 1.0;
        double while_pointing = 1.0;
        for (const Vec3& eye : viewpoint.eyes) {
            at_rest = std::min(at_rest, visibleShare(eye, balls[ball], avatar.atRest(), others));
            while_pointing = std::min(while_pointing, visibleShare(eye, balls[ball], pointing, others));
        }
        seen.at_rest.push_back(std::round(at_rest * 1e3) / 1e3);
        seen.pointing.push_back(std::round(while_pointing * 1e3) / 1e3);
    }
    return seen;
}

ClearView::ClearView(const std::vector<Viewpoint>& from, const Vec3& target, double ball_radius_m)
    : bodies_{StandingAvatar::reference().atRest(), StandingAvatar::reference().pointing(target)},
      target_{target, ball_radius_m} {
    for (const Viewpoint& viewpoint : from)
        for (const Vec3& eye : viewpoint.eyes)
            if (std::find(eyes_.begin(), eyes_.end(), eye) == eyes_.end()) eyes_.push_back(eye);
}

bool ClearView::seesTarget() const {
    for (const Vec3& eye : eyes_)
        for (const std::vector<motion::Capsule>& body : bodies_)
            if (visibleShare(eye, target_, body, {}) < min_visible_share) return false;
    return true;
}

bool ClearView::admits(const std::vector<Vec3>& others, const Vec3& more) const {
    std::vector<Sphere> before = spheres(others, target_.radius_m);
    before.insert(before.begin(), target_);
    const Sphere added{more, target_.radius_m};
    for (const Vec3& eye : eyes_) {
        for (const std::vector<motion::Capsule>& body : bodies_) {
            if (visibleShare(eye, added, body, before) < min_visible_share) return false;
            for (std::size_t ball = 0; ball < before.size(); ++ball) {
                std::vector<Sphere> beside = without(before, ball);
                beside.push_back(added);
                const double share = visibleShare(eye, before[ball], body, beside);
                if (share >= min_visible_share) continue;
                beside.pop_back();  // what was hidden before it came is not its doing
                if (share < visibleShare(eye, before[ball], body, beside)) return false;
            }
        }
    }
    return true;
}

}  // namespace deixis::studies
