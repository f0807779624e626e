// Demonstrations followed in the simulation.
#include "physics/projection/projection.hpp"

#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "bodies.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::physics;
using namespace deixis::tests;

namespace {

bool same(const motion::Clip& a, const motion::Clip& b) {
    if (a.frames.size() != b.frames.size()) return false;
    for (std::size_t f = 0; f < a.frames.size(); ++f)
        for (std::size_t j = 0; j < a.frames[f].joints.size(); ++j)
            if (a.frames[f].joints[j].orientation != b.frames[f].joints[j].orientation ||
                a.frames[f].joints[j].position != b.frames[f].joints[j].position)
                return false;
    return true;
}

/// Four of either hand.
std::vector<const motion::Clip*> eightClips() {
    std::vector<const motion::Clip*> out;
    for (std::size_t i = 0; i < 8; ++i) out.push_back(&demonstrations()[2 + 6 * i].gesture.clip);
    return out;
}

}  // namespace

TEST_SUITE("physics/projection") {
    TEST_CASE("eight demonstrations are followed to half a centimetre, and without feed-forward to two") {
        Body body = valueOf(Body::make(figureOf(Stance::pinned)));
        for (const motion::Clip* clip : eightClips()) {
            const Projection plain = valueOf(project(body, *clip, {.feed_forward = false}));
            const Projection made = valueOf(project(body, *clip, {}));
            CHECK(plain.tracking.mean_m > 0.01);
            CHECK(plain.tracking.max_m > 0.05);
            CHECK(made.tracking.mean_m < 0.005);
            CHECK(made.tracking.max_m < 0.05);
            CHECK(made.fit_distance_m < 0.025);
            CHECK(made.beyond_limit_rad == 0.0);
            CHECK(made.beyond_limit_of.empty());
        }
    }

    TEST_CASE("the new clip has the frames, rate and skeleton of the given one, and what the body lacks") {
        Body body = valueOf(Body::make(figureOf(Stance::pinned)));
        const motion::Clip& clip = *eightClips().front();
        const Projection made = valueOf(project(body, clip, {}));
        REQUIRE(made.clip.frames.size() == clip.frames.size());
        CHECK(made.clip.frame_time_s == clip.frame_time_s);
        CHECK_FALSE(same(made.clip, clip));
        for (std::size_t f = 0; f < clip.frames.size(); ++f)
            for (const motion::Bone bone : {motion::Bone::hips, motion::Bone::leftEye, motion::Bone::leftHand,
                                            motion::Bone::leftIndexDistal}) {
                const auto j = static_cast<std::size_t>(bone);
                CHECK(made.clip.frames[f].joints[j].orientation == clip.frames[f].joints[j].orientation);
                CHECK(made.clip.frames[f].joints[j].position == clip.frames[f].joints[j].position);
            }
        // It begins as the given one does, and comes to rest.
        const auto first = fitPose(body.figure(), made.clip.frames.front()).angles_rad;
        const auto given = fitPose(body.figure(), clip.frames.front()).angles_rad;
        for (std::size_t h = 0; h < first.size(); ++h)
            CHECK(first[h] == doctest::Approx(given[h]).epsilon(1e-9));
    }

    TEST_CASE("the same clip gives the same bits, with noise, too; another seed gives others") {
        const Figure figure = figureOf(Stance::pinned);
        Body one = valueOf(Body::make(figure));
        Body two = valueOf(Body::make(figure));
        const motion::Clip& clip = *eightClips()[3];
        CHECK(same(valueOf(project(one, clip, {})).clip, valueOf(project(two, clip, {})).clip));
        // Whatever the body did before.
        const ProjectionSettings noisy{.noise_rad = 0.02, .seed = 4};
        const Projection first = valueOf(project(one, clip, noisy));
        CHECK(same(first.clip, valueOf(project(two, clip, noisy)).clip));
        CHECK_FALSE(same(first.clip, valueOf(project(one, clip, {.noise_rad = 0.02, .seed = 5})).clip));
        CHECK(first.tracking.mean_m < 0.02);
        CHECK(first.tracking.mean_m > valueOf(project(one, clip, {})).tracking.mean_m);
    }

    TEST_CASE("clips of other rates are followed as well") {
        Body body = valueOf(Body::make(figureOf(Stance::pinned)));
        for (const double fps : {24.0, 25.0, 120.0}) {
            CAPTURE(fps);
            const motion::Clip clip = valueOf(motion::resample(*eightClips()[1], 1.0 / fps));
            const Projection made = valueOf(project(body, clip, {}));
            CHECK(made.clip.frames.size() == clip.frames.size());
            CHECK(made.tracking.mean_m < 0.006);
        }
    }

    TEST_CASE("a clip that stands still, or has one frame, stays where it is") {
        Body body = valueOf(Body::make(figureOf(Stance::pinned)));
        motion::Clip clip;
        clip.skeleton = motion::referenceHumanoid();
        clip.frames.assign(1, motion::relaxedPose(clip.skeleton));
        CHECK(valueOf(project(body, clip, {})).tracking.max_m < 1e-9);
        clip.frames.assign(90, motion::relaxedPose(clip.skeleton));
        CHECK(valueOf(project(body, clip, {})).tracking.max_m < 1e-4);
    }

    TEST_CASE("a body on its feet follows demonstrations without falling") {
        Body body = valueOf(Body::make(figureOf(Stance::free)));
        for (std::size_t i = 0; i < 8; i += 3) {
            const Projection made = valueOf(project(body, *eightClips()[i], {}));
            CHECK(made.tracking.mean_m < 0.06);
            const auto world = motion::worldPose(made.clip.skeleton, made.clip.frames.back());
            CHECK(world[static_cast<std::size_t>(motion::Bone::head)].position.y > 1.50);
            CHECK(std::abs(world[static_cast<std::size_t>(motion::Bone::leftFoot)].position.y - 0.085) <
                  0.01);
        }
    }

    TEST_CASE("what is beyond the limits is said") {
        Body body = valueOf(Body::make(figureOf(Stance::pinned)));
        motion::Clip clip;
        clip.skeleton = motion::referenceHumanoid();
        clip.frames.assign(30, motion::restPose(clip.skeleton));
        for (auto& pose : clip.frames)
            pose.joints[static_cast<std::size_t>(motion::Bone::head)].orientation = yawRotation(1.4);
        const Projection made = valueOf(project(body, clip, {}));
        CHECK(made.beyond_limit_of == "neck rotation");
        CHECK(degreesFromRadians(made.beyond_limit_rad) == doctest::Approx(degreesFromRadians(1.4) - 60.0));
    }

    TEST_CASE("numbers that are not finite and other skeletons are rejected, with frame and joint") {
        Body body = valueOf(Body::make(figureOf(Stance::pinned)));
        motion::Clip clip = *eightClips().front();
        clip.frames[7].joints[static_cast<std::size_t>(motion::Bone::neck)].orientation.y =
            std::numeric_limits<double>::quiet_NaN();
        const auto broken = project(body, clip, {});
        REQUIRE_FALSE(broken.has_value());
        CHECK(contains(broken.error().text(), "frame 7, joint 'neck'"));

        clip = *eightClips().front();
        clip.skeleton.joints[4].name = "nape";
        const auto other = project(body, clip, {});
        REQUIRE_FALSE(other.has_value());
        CHECK(contains(other.error().text(), "another skeleton"));
    }
}
