#include "motion/synthesis/demonstration_library.hpp"

#include <doctest/doctest.h>

#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

const std::vector<Demonstration>& library() {
    static const auto made = makeDemonstrations(referenceHumanoid(), {});
    REQUIRE(made.has_value());
    return *made;
}

int countOf(const std::vector<Demonstration>& demonstrations, Side hand) {
    return static_cast<int>(std::count_if(demonstrations.begin(), demonstrations.end(),
                                          [&](const Demonstration& d) { return d.gesture.hand == hand; }));
}

}  // namespace

TEST_SUITE("motion/demonstration_library") {
    TEST_CASE("25 left-handed and 27 right-handed demonstrations mirror to 104") {
        CHECK(countOf(library(), Side::left) == 25);
        CHECK(countOf(library(), Side::right) == 27);
        const auto both = withMirrored(library());
        CHECK(both.size() == 104);
        CHECK(countOf(both, Side::left) == 52);
    }

    TEST_CASE(
        "a mirrored demonstration takes the mirrored way with the other hand, and twice mirrored it is "
        "itself") {
        for (const std::size_t i : {0U, 7U, 30U, 51U}) {
            const Demonstration& there = library()[i];
            const Demonstration image = mirrored(there);
            CHECK(image.target.x == -there.target.x);
            CHECK(image.gesture.hand == opposite(there.gesture.hand));
            for (int f = 0; f < there.gesture.clip.frameCount(); f += 5) {
                const Vec3 a = fingertipAt(there.gesture, f);
                CHECK(glm::length(Vec3(-a.x, a.y, a.z) - fingertipAt(image.gesture, f)) < 1e-9);
            }
            const Demonstration again = mirrored(image);
            CHECK(again.target == there.target);
            for (std::size_t f = 0; f < there.gesture.clip.frames.size(); ++f)
                for (std::size_t j = 0; j < there.gesture.clip.frames[f].joints.size(); ++j) {
                    const Pose& a = there.gesture.clip.frames[f].joints[j];
                    const Pose& b = again.gesture.clip.frames[f].joints[j];
                    REQUIRE(a.position == b.position);
                    REQUIRE(a.orientation == b.orientation);
                }
        }
    }

    TEST_CASE("targets lie on the half-cylinder, on the hand's side or nearly straight ahead") {
        for (const Demonstration& d : library()) {
            const double azimuth = degreesFromRadians(std::atan2(d.target.x, d.target.z));
            const double radius = std::sqrt(d.target.x * d.target.x + d.target.z * d.target.z);
            CHECK(std::abs(azimuth) <= 85.0);
            CHECK((d.gesture.hand == Side::left ? azimuth : -azimuth) >= -10.0);
            CHECK(radius >= 1.9);
            CHECK(radius <= 2.2);
            CHECK(d.target.y >= 0.0);
            CHECK(d.target.y <= 2.2);
        }
    }

    TEST_CASE("people miss by a few degrees along the eye's line, by more along the shoulder's") {
        // Real people (1,755 points): eye 3.9, shoulder 14.6 degrees in the median. One actor's bias differs.
        std::vector<double> eye, shoulder;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            DemonstrationParameters parameters;
            parameters.library_seed = seed;
            const auto made = makeDemonstrations(referenceHumanoid(), parameters);
            REQUIRE(made.has_value());
            for (const Demonstration& d : *made) {
                eye.push_back(errorDeg(d.gesture, d.target));
                const auto world = worldAt(d.gesture.clip, d.gesture.peak_frame);
                const Vec3 tip = fingertipAt(d.gesture, d.gesture.peak_frame);
                const Vec3 from = joint(world, armBones(d.gesture.hand).upper_arm);
                shoulder.push_back(degreesFromRadians(angleBetween(tip - from, d.target - tip)));
            }
        }
        CHECK(median(eye) > 2.0);
        CHECK(median(eye) < 9.0);
        CHECK(median(shoulder) > 10.0);
        CHECK(median(shoulder) < 21.0);
        CHECK(median(eye) < median(shoulder));
    }

    TEST_CASE("phases last as long as was asked for, to a frame at each end") {
        DemonstrationParameters parameters;
        auto& asked = parameters.timing;
        asked.raise_s = {0.9, 1.1};
        asked.hold_s = {0.5, 0.6};
        asked.retract_s = {1.2, 1.5};
        const auto made = makeDemonstrations(referenceHumanoid(), parameters);
        REQUIRE(made.has_value());
        const auto within = [](double found_s, const auto& range, double slack_s) {
            return found_s >= range.low - slack_s && found_s <= range.high + slack_s;
        };
        for (const Demonstration& d : *made) {
            const GeneratedClip& g = d.gesture;
            const double raise = (g.peak_frame - g.onset_frame) / 30.0;
            const double hold = (g.hold_frame - g.peak_frame) / 30.0;
            const double retract = (g.end_frame - g.hold_frame) / 30.0;
            constexpr double slack = 2.0 / 30.0;
            CHECK(within(raise, asked.raise_s, slack));
            CHECK(within(hold, asked.hold_s, slack));
            CHECK(within(retract, asked.retract_s, slack));
        }
    }

    TEST_CASE("emphasis lengthens raise and hold and leaves the way back") {
        DemonstrationParameters parameters;
        parameters.timing.emphasis = 2.0;
        const auto slow = makeDemonstrations(referenceHumanoid(), parameters);
        REQUIRE(slow.has_value());
        for (std::size_t i = 0; i < slow->size(); i += 7) {
            const GeneratedClip& a = library()[i].gesture;
            const GeneratedClip& b = (*slow)[i].gesture;
            CHECK(std::abs((b.peak_frame - b.onset_frame) - 2 * (a.peak_frame - a.onset_frame)) <= 4);
            CHECK(std::abs((b.hold_frame - b.peak_frame) - 2 * (a.hold_frame - a.peak_frame)) <= 4);
            CHECK(std::abs((b.end_frame - b.hold_frame) - (a.end_frame - a.hold_frame)) <= 2);
        }
    }

    TEST_CASE("another seed makes another library") {
        DemonstrationParameters parameters;
        parameters.library_seed = 2;
        const auto other = makeDemonstrations(referenceHumanoid(), parameters);
        REQUIRE(other.has_value());
        CHECK(other->front().target != library().front().target);
    }
}
