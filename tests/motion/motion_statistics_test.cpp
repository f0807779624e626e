#include "motion/gestures/motion_statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "motion/gestures/gesture_style.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;
using doctest::Approx;

namespace {

/// Two joints along x: the left hand at these places, the right one still.
JointTrajectories trajectories(const std::vector<double>& places, double frame_time_s = 0.5) {
    JointTrajectories out;
    out.frame_time_s = frame_time_s;
    out.joints = {Bone::leftHand, Bone::rightHand};
    out.positions.resize(2);
    for (const double x : places) {
        out.positions[0].emplace_back(x, 0, 0);
        out.positions[1].emplace_back(0, 1, 0);
    }
    return out;
}

}  // namespace

TEST_SUITE("motion/motion_statistics") {
    TEST_CASE("speed, acceleration and jerk are plain differences") {
        // 0, 1, 4, 9 at 2 Hz: differences 1 3 5, 2 2, 0; times 2, 4, 8.
        const auto trajectory = trajectories({0, 1, 4, 9}).positions[0];
        CHECK(magnitudes(trajectory, 0.5, Derivative::speed) == std::vector<double>{2, 6, 10});
        CHECK(magnitudes(trajectory, 0.5, Derivative::acceleration) == std::vector<double>{8, 8});
        CHECK(magnitudes(trajectory, 0.5, Derivative::jerk) == std::vector<double>{0});
        CHECK(magnitudes({Vec3(1.0)}, 0.5, Derivative::jerk).empty());
    }

    TEST_CASE("averages are over frames, then joints, then clips, the deviation over clips") {
        // Mean speed of the moving hand 6 and 1, of the still one 0: clips 3 and 0.5.
        const auto found = motionStatistics({trajectories({0, 1, 4, 9}), trajectories({0, 0.5, 1, 1.5})});
        REQUIRE(found.has_value());
        CHECK(found->average[0].mean == Approx(1.75));
        CHECK(found->average[0].sd == Approx(1.25));
        CHECK(found->average[1].mean == Approx(2.0));
        CHECK(found->average[2].mean == Approx(0.0));
        double counted = 0.0;
        for (const auto& histogram : found->histograms[0])
            for (const double c : histogram.counts) counted += c;
        CHECK(counted == 12.0);
    }

    TEST_CASE("values are counted from their bin's lower edge on, those beyond the last bin in it") {
        Histogram h{0.5, std::vector<double>(3, 0.0)};
        count(h, {0.0, 0.49, 0.5, 1.0, 1.49, 1.5, 70.0});
        CHECK(h.counts == std::vector<double>{2, 1, 4});
    }

    TEST_CASE("the Hellinger distance is 0 to itself, 1 without overlap, and what a hand finds between") {
        const Histogram a{1.0, {1, 1, 0, 0}};
        CHECK(hellingerDistance(a, {1.0, {7, 7, 0, 0}}) == Approx(0.0).epsilon(1e-7));
        CHECK(hellingerDistance(a, {1.0, {0, 0, 2, 3}}) == Approx(1.0));
        // Half and half against all in the first: 1 - sqrt(0.5).
        CHECK(hellingerDistance(a, {1.0, {4, 0, 0, 0}}) == Approx(std::sqrt(1.0 - std::sqrt(0.5))));
        CHECK(hellingerDistance({1.0, {4, 0, 0, 0}}, a) == hellingerDistance(a, {1.0, {4, 0, 0, 0}}));
    }

    TEST_CASE("clips of other joints, other rates, too few frames or none at all are rejected") {
        const auto rejection = [](const std::vector<JointTrajectories>& clips) {
            const auto found = motionStatistics(clips);
            REQUIRE_FALSE(found.has_value());
            return found.error().text();
        };
        CHECK(rejection({}).find("no clips") != std::string::npos);
        CHECK(rejection({trajectories({0, 1, 2})}).find("3 frames") != std::string::npos);
        CHECK(
            rejection({trajectories({0, 1, 2, 3}), trajectories({0, 1, 2, 3}, 0.1)}).find("clip 2 has 10") !=
            std::string::npos);
        auto other = trajectories({0, 1, 2, 3});
        other.joints[0] = Bone::head;
        CHECK(rejection({trajectories({0, 1, 2, 3}), other}).find("clip 2 has other joints") !=
              std::string::npos);
    }

    TEST_CASE("a system is nearer to itself with other seeds than to one that moves otherwise") {
        const auto statistics = [](const std::string& name, std::uint64_t seed) {
            const auto generator = makeGenerator(name, referenceHumanoid(), {});
            REQUIRE(generator.has_value());
            std::vector<JointTrajectories> clips;
            for (const Vec3& target : drawTargets(12, seed))
                clips.push_back(jointTrajectories((*generator)->generate({"T", target, seed++}).clip,
                                                  referenceMap(), comparedBones()));
            return motionStatistics(clips).value();
        };
        const auto direct = statistics("direct", 1);
        const auto again = motionDistances(direct, statistics("direct", 50)).value();
        const auto stiff = motionDistances(direct, statistics("stiff", 1)).value();
        for (std::size_t d = 0; d < derivative_count; ++d) {
            CHECK(again[d].pooled < 0.5 * stiff[d].pooled);
            CHECK(again[d].mean < stiff[d].mean);
            CHECK(stiff[d].pooled <= 1.0);
        }
    }
}

TEST_SUITE("motion/gesture_style") {
    TEST_CASE("style is what equations 4 to 6 give by hand") {
        // Window 4: frame 2 of 5 sees all five. The left hand makes steps 1, 1, 3, 3 (sum 8), the right one
        // none.
        const auto style = gestureStyle(trajectories({0, 1, 2, 5, 8}), 4);
        REQUIRE(style.has_value());
        // A full window at frame 2 has five frames but four steps (none leads to frame 0): 8/4 steps x 5/4.
        CHECK((*style)[2].speed == Approx(8.0 / 4.0 * 5.0 / 4.0));
        CHECK((*style)[2].handedness == Approx(1.0));
        double space = 0.0;
        for (const double x : {0.0, 1.0, 2.0, 5.0, 8.0}) space += std::hypot(x, 1.0);
        CHECK((*style)[2].space == Approx(space / 4.0));
        // Seven frames: the window about frame 3 is whole and has a step for each of its five frames.
        const auto whole = gestureStyle(trajectories({0, 0, 1, 2, 5, 8, 8}), 4);
        CHECK((*whole)[3].speed == Approx((0.0 + 1 + 1 + 3 + 3) / 4.0));
    }

    TEST_CASE("handedness runs from -1, right hand only, by 0 to 1, left hand only, and mirrors its sign") {
        auto both = trajectories({0, 1, 2, 3});
        for (std::size_t f = 0; f < 4; ++f) both.positions[1][f] = {0, 4.0 * static_cast<double>(f), 0};
        CHECK(gestureStyle(both, 2).value()[1].handedness == Approx(1.0 / 4.0 - 1.0));
        std::swap(both.positions[0], both.positions[1]);
        CHECK(gestureStyle(both, 2).value()[1].handedness == Approx(1.0 - 1.0 / 4.0));
        CHECK(gestureStyle(trajectories({2, 2, 2}), 2).value()[1].handedness == 0.0);
    }

    TEST_CASE("styles are normalised by the corpus and clamped to 3 deviations") {
        const StyleNorm norm = styleNorm({{{1, 0, 5}, {3, 0, 5}}, {{5, 0, 5}, {7, 0, 5}}});
        CHECK(norm.mean.speed == Approx(4.0));
        CHECK(norm.sd.speed == Approx(std::sqrt(5.0)));
        CHECK(normalisedStyle({4 + std::sqrt(5.0), 9, 5}, norm).speed == Approx(1.0));
        CHECK(normalisedStyle({100, 9, 5}, norm).speed == 3.0);
        CHECK(normalisedStyle({-100, 9, 5}, norm).speed == -3.0);
        CHECK(normalisedStyle({4, 9, 5}, norm).space == 0.0);  // the corpus does not vary there
    }

    TEST_CASE("compliance is the mean absolute difference where poses or styles were asked for") {
        auto reference = trajectories(std::vector<double>(20, 1.0));
        auto generated = trajectories(std::vector<double>(20, 1.0));
        generated.positions[0][12].x += 0.6;   // one of 2 joints x 3 coordinates x 5 frames
        generated.positions[0][15].x += 50.0;  // not asked for
        CHECK(poseCompliance(reference, generated).value() == Approx(0.6 / 30.0));
        CHECK_FALSE(poseCompliance(reference, trajectories({0, 1, 2, 3})).has_value());
        generated.frame_time_s = 0.25;
        CHECK(poseCompliance(reference, generated)
                  .error()
                  .text()
                  .find("have 2 frames per second, the motion 4") != std::string::npos);
        CHECK(poseBones().size() == 9);
        CHECK(styleCompliance({{1, 2, 3}, {0, 0, 0}}, {{1, 1, 3}, {0, 0.5, 0.3}}).value() ==
              Approx((1.0 + 0.5 + 0.3) / 6.0));
        CHECK_FALSE(styleCompliance({{1, 2, 3}}, {}).has_value());
    }
}
