#include "studies/station/first_look.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "motion/pointing/stretched_arm.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

namespace {

constexpr double free_share = 0.1;  // of half the picture, at each side
constexpr int rounds = 30;          // each brings the middle of what is seen nearer to the middle of the view

struct Bounds {
    Vec3 low{1e9};
    Vec3 high{-1e9};
    void include(const Vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

/// The spheres on the picture plane at distance 1, in a view that looks along its -z.
Bounds onPicture(const std::vector<Sphere>& seen, const Quat& view_from_viewer) {
    constexpr double nearest_m = 0.05;
    Bounds bounds;
    for (const Sphere& sphere : seen) {
        const Vec3 at = view_from_viewer * sphere.centre;
        const double depth_m = std::max(-at.z - sphere.radius_m, nearest_m);
        const Vec3 reach(sphere.radius_m, sphere.radius_m, 0.0);
        bounds.include((at - reach) / depth_m);
        bounds.include((at + reach) / depth_m);
    }
    return bounds;
}

}  // namespace

double FirstLook::verticalView_rad(double aspect) const {
    const double half = std::max(half_height, half_width / aspect) / (1.0 - free_share);
    return std::clamp(2.0 * std::atan(half), min_view_rad, max_view_rad);
}

FirstLook firstLook(const Pose& stage_from_viewer, double eye_height_m, const std::vector<Sphere>& seen) {
    const Pose eye_from_stage = inverse(stage_from_viewer * Pose{{0.0, eye_height_m, 0.0}, no_rotation});
    std::vector<Sphere> before_eye;
    Bounds box;
    for (const Sphere& sphere : seen) {
        before_eye.push_back({transformPoint(eye_from_stage, sphere.centre), sphere.radius_m});
        box.include(before_eye.back().centre);
    }
    const Vec3 middle = 0.5 * (box.low + box.high);
    FirstLook look;
    look.yaw_rad = std::atan2(-middle.x, -middle.z);
    look.pitch_rad = std::atan2(middle.y, std::hypot(middle.x, middle.z));
    for (int round = 0; round <= rounds; ++round) {
        const Quat view_from_viewer =
            glm::angleAxis(-look.pitch_rad, Vec3(1.0, 0.0, 0.0)) * glm::angleAxis(-look.yaw_rad, up);
        const Bounds bounds = onPicture(before_eye, view_from_viewer);
        const Vec3 aside = 0.5 * (bounds.low + bounds.high);
        look.half_width = std::max(-bounds.low.x, bounds.high.x);
        look.half_height = std::max(-bounds.low.y, bounds.high.y);
        if (round == rounds) break;
        look.yaw_rad -= 0.5 * std::atan(aside.x);
        look.pitch_rad += 0.5 * std::atan(aside.y);
    }
    return look;
}

std::vector<Sphere> panelCorners(const Panel& panel) {
    constexpr double round_m = 0.01;
    std::vector<Sphere> corners;
    for (const double x : {0.0, panel.width_m})
        for (const double y : {0.0, panel.height_m})
            corners.push_back({transformPoint(panel.stage_from_panel, {x, y, 0.0}), round_m});
    return corners;
}

std::vector<Sphere> pointingScene(const std::vector<Sphere>& balls, const motion::Skeleton& avatar,
                                  const motion::LocalPose& idle_pose) {
    constexpr double shoulder_radius_m = 0.08;
    constexpr double hand_radius_m = 0.08;
    std::vector<Sphere> scene = balls;
    const motion::HumanoidMap map = motion::mapByVrmNames(avatar);
    for (const motion::Bone bone : {motion::Bone::head, motion::Bone::leftHand, motion::Bone::rightHand})
        if (!map.has(bone)) return scene;
    const std::vector<Pose> world = motion::worldPose(avatar, idle_pose);
    for (const Sphere& ball : balls) {
        const motion::StretchedArm arm =
            motion::stretchedArm(avatar, map, world, motion::handFor(ball.centre), ball.centre);
        scene.push_back({arm.shoulder, shoulder_radius_m});
        scene.push_back({arm.fingertip, hand_radius_m});
    }
    return scene;
}

}  // namespace deixis::studies
