#include "motion/pointing/measures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "motion/synthesis/demonstration_library.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;
using doctest::Approx;

namespace {

GeneratedClip generated(const std::string& system, const Vec3& target, std::uint64_t seed = 3) {
    const auto generator = makeGenerator(system, referenceHumanoid(), {});
    REQUIRE(generator.has_value());
    return (*generator)->generate({"T", target, seed});
}

GesturePhases known(const GeneratedClip& clip) {
    return clip;
}

PointingMeasures measured(const Clip& clip, const Vec3& target,
                          const std::optional<GesturePhases>& phases = {}) {
    const auto found = measurePointing(clip, referenceMap(), target, phases);
    REQUIRE_MESSAGE(found.has_value(), (found ? "" : found.error().text()));
    return *found;
}

double errorDegrees(const PointingMeasures& measures, PointingRay ray) {
    return degreesFromRadians(measures.rays[static_cast<std::size_t>(ray)].value().error_rad);
}

const Vec3 target(-1.2, 1.3, 1.6);

}  // namespace

TEST_SUITE("motion/pointing_measures") {
    TEST_CASE("the exact systems are exact, and a careful reader of the forearm is misled") {
        for (const char* system : {"direct", "stiff"}) {
            const auto clip = generated(system, target);
            const PointingMeasures m = measured(clip.clip, target);
            CHECK(m.phases.hand == Side::right);
            REQUIRE(m.detected.has_value());
            CHECK(m.detected->clear_hold);
            CHECK(errorDegrees(m, PointingRay::eye_fingertip) < 1.0);
            CHECK(errorDegrees(m, PointingRay::forearm) > 15.0);
            CHECK(errorDegrees(m, PointingRay::shoulder_fingertip) > 10.0);
            // Equation 2 by the forearm's error.
            const double theta = 1.0 - errorDegrees(m, PointingRay::forearm) / 180.0;
            CHECK(m.reward.value() == Approx((std::exp(theta) - 1.0) / std::exp(1.0)));
            CHECK(m.max_reward.value() >= m.reward.value());
            const auto& ray = *m.rays[static_cast<std::size_t>(PointingRay::forearm)];
            CHECK(ray.min_error_rad <= ray.error_rad);
            CHECK_FALSE(ray.points_away);
            CHECK(m.hold_s == Approx((m.phases.hold_frame - m.phases.peak_frame) / 30.0));
        }
    }

    TEST_CASE("an unsteady hold drifts and jitters more than a still one, in fingertip and ray") {
        const auto still = generated("direct", target);
        const auto moving = generated("drifting", target);
        const PointingMeasures a = measured(still.clip, target, known(still));
        const PointingMeasures b = measured(moving.clip, target, known(moving));
        CHECK(b.fingertip->jitter_rms > 3.0 * a.fingertip->jitter_rms);
        CHECK(b.fingertip->drift_per_s > a.fingertip->drift_per_s);
        const auto eye = static_cast<std::size_t>(PointingRay::eye_fingertip);
        CHECK(b.rays[eye]->steadiness->jitter_rms > 3.0 * a.rays[eye]->steadiness->jitter_rms);
    }

    TEST_CASE("a steady joint speed is less smooth than minimum jerk by both measures") {
        const PointingMeasures smooth = measured(generated("direct", target).clip, target);
        const PointingMeasures abrupt = measured(generated("stiff", target).clip, target);
        CHECK(smooth.log_dimensionless_jerk.value() > abrupt.log_dimensionless_jerk.value());
        CHECK(smooth.spectral_arc_length.value() > abrupt.spectral_arc_length.value());
        CHECK(smooth.log_dimensionless_jerk.value() < -4.5);
    }

    TEST_CASE("a clip that is turned, and its target with it, measures the same") {
        const auto clip = generated("demonstration-nn", target);
        const PointingMeasures before = measured(clip.clip, target);
        Clip turned = clip.clip;
        const Pose by{Vec3(2, 0, -1), yawRotation(1.0)};
        for (LocalPose& frame : turned.frames) frame.joints[0] = by * frame.joints[0];
        const PointingMeasures after = measured(turned, transformPoint(by, target));
        CHECK(after.phases.peak_frame == before.phases.peak_frame);
        CHECK(after.reward.value() == Approx(before.reward.value()));
        for (const PointingRay ray : all_pointing_rays)
            CHECK(errorDegrees(after, ray) == Approx(errorDegrees(before, ray)));
        CHECK(after.log_dimensionless_jerk.value() == Approx(before.log_dimensionless_jerk.value()));
        CHECK(after.foot_skate->speed_m_s == Approx(before.foot_skate->speed_m_s));
    }

    TEST_CASE("a clip seen in a mirror measures the same with the other hand") {
        const auto clip = generated("demonstration-nn", target);
        const Demonstration image = mirrored(Demonstration{target, clip});
        const PointingMeasures a = measured(clip.clip, target);
        const PointingMeasures b = measured(image.gesture.clip, image.target);
        CHECK(b.phases.hand == opposite(a.phases.hand));
        CHECK(b.phases.onset_frame == a.phases.onset_frame);
        CHECK(b.phases.end_frame == a.phases.end_frame);
        for (const PointingRay ray : all_pointing_rays)
            CHECK(errorDegrees(b, ray) == Approx(errorDegrees(a, ray)));
        CHECK(b.fingertip->jitter_rms == Approx(a.fingertip->jitter_rms));
    }

    TEST_CASE("the same movement at four times the frame rate measures nearly the same") {
        const auto clip = generated("direct", target);
        const PointingMeasures a = measured(clip.clip, target);
        const PointingMeasures b = measured(resample(clip.clip, 1.0 / 120.0).value(), target);
        CHECK(b.hold_s == Approx(a.hold_s).epsilon(0.1));
        CHECK(b.peak_speed_m_s == Approx(a.peak_speed_m_s).epsilon(0.02));
        CHECK(errorDegrees(b, PointingRay::forearm) ==
              Approx(errorDegrees(a, PointingRay::forearm)).epsilon(0.01));
        CHECK(b.spectral_arc_length.value() == Approx(a.spectral_arc_length.value()).epsilon(0.03));
    }

    TEST_CASE("without a target there are no rays; without a bone, a number or a gesture there is an error") {
        const auto clip = generated("stiff", target);
        const auto plain = measurePointing(clip.clip, referenceMap(), {});
        REQUIRE(plain.has_value());
        CHECK_FALSE(plain->reward.has_value());
        CHECK_FALSE(plain->rays[0].has_value());
        const auto rejection = [&](const Clip& c, const HumanoidMap& map,
                                   const std::optional<GesturePhases>& phases = {}) {
            const auto found = measurePointing(c, map, target, phases);
            REQUIRE_FALSE(found.has_value());
            return found.error().text();
        };
        HumanoidMap handless = referenceMap();
        handless[Bone::leftHand] = -1;
        CHECK(rejection(clip.clip, handless).find("'leftHand'") != std::string::npos);
        Clip broken = clip.clip;
        broken.frames[4].joints[0].position.x = std::nan("");
        CHECK(rejection(broken, referenceMap()).find("frame 4") != std::string::npos);
        Clip still = clip.clip;
        still.frames.resize(5);
        CHECK(rejection(still, referenceMap()).find("no gesture") != std::string::npos);
        GesturePhases late = known(clip);
        late.end_frame = 100000;
        CHECK(rejection(clip.clip, referenceMap(), late).find("100000") != std::string::npos);
    }
}
