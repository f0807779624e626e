#include "replay_scene.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "core/room.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using namespace deixis::app;

namespace {

class NoClips : public studies::ClipSource {
  public:
    [[nodiscard]] const motion::Clip& clip(const studies::Stimulus&) const override { return clip_; }

  private:
    motion::Clip clip_{};
};

Pose camera(const studies::Layout& layout, const OutsideView& view) {
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const motion::LocalPose idle = motion::relaxedPose(avatar);
    const NoClips clips;
    studies::RecordedTrial recorded;
    recorded.layout = layout;
    const studies::TrialReplay replay(recorded, clips, avatar, idle);
    return sceneFromOutside(replay, recorded, 0.0, view, 0.0).camera.stage_from_eye;
}

const studies::Layout across{"across", 0.0, 3.4, 180.0};
const studies::Layout side_by_side{"side-by-side", -0.6, -0.95, 15.0};

}  // namespace

TEST_SUITE("immersive/replay_scene") {
    TEST_CASE("From outside means from within the room, wherever the camera goes round") {
        for (const auto& layout : {across, side_by_side})
            for (int azimuth = 0; azimuth < 360; azimuth += 15)
                for (const double elevation : {-5.0, 18.0, 85.0})
                    for (const double distance_m : {1.0, 4.6, 9.0}) {
                        OutsideView view;
                        view.azimuth_rad = radiansFromDegrees(azimuth);
                        view.elevation_rad = radiansFromDegrees(elevation);
                        view.distance_m = distance_m;
                        const Pose at = camera(layout, view);
                        const glm::vec3 p(at.position);
                        CAPTURE(azimuth);
                        CAPTURE(elevation);
                        CAPTURE(distance_m);
                        CHECK(glm::all(glm::greaterThan(Vec3(p), room_low + 0.1)));
                        CHECK(glm::all(glm::lessThan(Vec3(p), room_high - 0.1)));
                        // The middle between participant and avatar stays in the middle of the picture.
                        const Vec3 middle{layout.viewer_x_m / 2.0, 1.0, layout.viewer_z_m / 2.0};
                        const Vec3 seen = transformPoint(inverse(at), middle);
                        CHECK(glm::length(seen - Vec3(0.0, 0.0, seen.z)) < 1e-9);
                        CHECK(-seen.z <= distance_m + 1e-9);
                        CHECK(-seen.z > 0.5);
                    }
    }

    TEST_CASE("With room enough the camera is as far away as was asked for") {
        OutsideView view;
        view.azimuth_rad = 0.0;
        view.distance_m = 2.0;
        CHECK(glm::distance(camera(across, view).position, Vec3(0.0, 1.0, 1.7)) == doctest::Approx(2.0));
    }
}
