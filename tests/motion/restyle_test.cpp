// Style put on a motion: measured by the paper's own statistics (Yoon et al. 2021, equations 4 to 6).
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "assets/data/unit_gestures.hpp"
#include "motion/unit_gestures/restyle.hpp"
#include "motion/upper_body/upper_body_style.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

/// The library's gesture of that name again and again.
UpperBodyMotion gesturing() {
    const auto library = assets::loadUnitGestures(sourceDir() / "assets/data/unit_gestures.toml");
    REQUIRE(library.has_value());
    UpperBodyMotion out;
    for (const UnitGesture& gesture : *library) {
        const UpperBodyMotion one = motionOf(gesture, 1.0);
        out.frames.insert(out.frames.end(), one.frames.begin(), one.frames.end());
    }
    REQUIRE(out.frames.size() > 600);
    return out;
}

struct MeanStyle {
    double speed = 0.0, space = 0.0, handedness = 0.0;
};
MeanStyle styleUnder(const UpperBodyMotion& motion, const WantedStyle& wanted) {
    const auto styles = styleOf(restyled(motion, std::vector<WantedStyle>(motion.frames.size(), wanted)));
    REQUIRE(styles.has_value());
    MeanStyle out;
    for (const Style& style : *styles) {
        out.speed += style.speed;
        out.space += style.space;
        out.handedness += style.handedness;
    }
    const auto count = static_cast<double>(styles->size());
    return {out.speed / count, out.space / count, out.handedness / count};
}

}  // namespace

TEST_SUITE("motion/restyle") {
    TEST_CASE("speed, space and handedness each go where they are wanted, and farther the more") {
        const UpperBodyMotion motion = gesturing();
        const MeanStyle plain = styleUnder(motion, {});
        double speed = -1.0, space = -1.0, handedness = -2.0;
        for (const double wanted : {-3.0, -1.0, 0.0, 1.0, 3.0}) {
            CAPTURE(wanted);
            const MeanStyle fast = styleUnder(motion, {.speed = wanted});
            const MeanStyle wide = styleUnder(motion, {.space = wanted});
            const MeanStyle left = styleUnder(motion, {.handedness = wanted});
            CHECK(fast.speed > speed);
            CHECK(wide.space > space);
            CHECK(left.handedness > handedness);
            speed = fast.speed;
            space = wide.space;
            handedness = left.handedness;
        }
        CHECK(styleUnder(motion, {.speed = 3.0}).speed > 1.3 * plain.speed);
        CHECK(styleUnder(motion, {.speed = -3.0}).speed < 0.7 * plain.speed);
    }

    TEST_CASE("what is not wanted stays to the bit, directions stay of unit length, and nothing jumps") {
        const UpperBodyMotion motion = gesturing();
        std::vector<WantedStyle> styles(motion.frames.size());
        CHECK(restyled(motion, styles) == motion);
        for (std::size_t i = 200; i < 400; ++i) styles[i] = {3.0, 3.0, -3.0};
        const UpperBodyMotion made = restyled(motion, styles);
        double before = 0.0, after = 0.0;
        for (std::size_t i = 0; i < motion.frames.size(); ++i) {
            if (i < 190 || i > 410) CHECK(made.frames[i] == motion.frames[i]);
            for (const Vec3& direction : made.frames[i].directions)
                CHECK(std::abs(glm::length(direction) - 1.0) < 1e-9);
            if (i == 0) continue;
            for (std::size_t bone = 0; bone < upper_bone_count; ++bone) {
                before = std::max(before, angleBetween(motion.frames[i - 1].directions[bone],
                                                       motion.frames[i].directions[bone]));
                after = std::max(after, angleBetween(made.frames[i - 1].directions[bone],
                                                     made.frames[i].directions[bone]));
            }
        }
        CHECK(after < 2.2 * before);
    }
}
