#include "motion/gestures/segmentation.hpp"

#include <doctest/doctest.h>

#include "motion/pointing/placement.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

const Generator& builtIn(const std::string& name) {
    static const auto direct = makeGenerator("direct", referenceHumanoid(), {});
    static const auto demonstration = makeGenerator("demonstration-nn", referenceHumanoid(), {});
    return name == "direct" ? **direct : **demonstration;
}

/// A gesture whose times, seconds into the recording, are known.
struct Known {
    Side hand;
    double onset_s, peak_s, hold_s, end_s;
};

struct Recording {
    Clip clip;
    std::vector<Known> known;
};

void append(Clip& clip, const std::vector<LocalPose>& frames) {
    clip.frames.insert(clip.frames.end(), frames.begin(), frames.end());
}

void rest(Clip& clip, double time_s) {
    const LocalPose at_ease = clip.frames.back();
    clip.frames.insert(clip.frames.end(), static_cast<std::size_t>(time_s / clip.frame_time_s), at_ease);
}

/// Gestures at targets all about the front, by whichever hand the system takes, with rests between.
Recording record(int gestures, std::uint64_t seed) {
    Random random(seed, "recording");
    Recording out;
    for (int i = 0; i < gestures; ++i) {
        const GeneratedClip made = builtIn(random.below(2) == 0 ? "direct" : "demonstration-nn")
                                       .generate({"T", drawTarget(random), random.next(), {}});
        if (i == 0) {
            out.clip.skeleton = made.clip.skeleton;
            out.clip.frame_time_s = made.clip.frame_time_s;
            out.clip.frames.push_back(made.clip.frames.front());
        }
        rest(out.clip, random.uniform(0.0, 2.0));
        const double begin_s = out.clip.frameCount() * out.clip.frame_time_s;
        const auto at = [&](int frame) { return begin_s + frame * out.clip.frame_time_s; };
        out.known.push_back(
            {made.hand, at(made.onset_frame), at(made.peak_frame), at(made.hold_frame), at(made.end_frame)});
        append(out.clip, made.clip.frames);
    }
    rest(out.clip, random.uniform(0.0, 2.0));
    return out;
}

/// Marker noise: about 2 mm at the hands, 1 mm at the hips, each frame by itself.
void addNoise(Clip& clip, std::uint64_t seed) {
    Random random(seed, "noise");
    for (LocalPose& frame : clip.frames) {
        frame.joints[0].position += Vec3(random.normal(), random.normal(), random.normal()) * 1e-3;
        for (const Bone bone :
             {Bone::leftUpperArm, Bone::leftLowerArm, Bone::rightUpperArm, Bone::rightLowerArm}) {
            auto& q = frame.joints[static_cast<std::size_t>(referenceMap()[bone])].orientation;
            const Vec3 axis{random.normal(), random.normal(), random.normal()};
            q = q * glm::angleAxis(0.003 * random.normal(), glm::normalize(axis));
        }
    }
}

Segmentation segmented(const Clip& clip, const SegmentationOptions& options = {}) {
    auto made = segment(clip, referenceMap(), options);
    REQUIRE_MESSAGE(made.has_value(), (made ? "" : made.error().text()));
    for (const Gesture& g : made->gestures) {
        CHECK(g.first >= 0);
        CHECK(g.first <= g.phases.onset_frame);
        CHECK(g.phases.onset_frame < g.phases.peak_frame);
        CHECK(g.phases.peak_frame <= g.phases.hold_frame);
        CHECK(g.phases.hold_frame < g.phases.end_frame);
        CHECK(g.phases.end_frame <= g.last);
        CHECK(g.last < clip.frameCount());
    }
    return *made;
}

}  // namespace

TEST_SUITE("motion/segmentation") {
    TEST_CASE("every gesture of a noisy recording is found within 0.11 s, at any frame rate") {
        int found = 0;
        double worst_s = 0.0;
        for (std::uint64_t seed = 1; seed <= 24; ++seed) {
            CAPTURE(seed);
            const double fps = std::array{24.0, 30.0, 60.0, 120.0}[seed % 4];
            const Recording recording = record(6, seed);
            Clip clip = resample(recording.clip, 1.0 / fps).value();
            addNoise(clip, seed);
            const Segmentation made = segmented(clip);
            CHECK(made.left_out.empty());
            CHECK(made.remarks.empty());
            REQUIRE(made.gestures.size() == recording.known.size());
            for (std::size_t i = 0; i < made.gestures.size(); ++i) {
                const Gesture& g = made.gestures[i];
                const Known& k = recording.known[i];
                CAPTURE(i);
                CHECK(g.phases.hand == k.hand);
                CHECK(g.remarks.empty());
                for (const auto& [frame, known_s] :
                     {std::pair{g.phases.onset_frame, k.onset_s}, std::pair{g.phases.peak_frame, k.peak_s},
                      std::pair{g.phases.hold_frame, k.hold_s}, std::pair{g.phases.end_frame, k.end_s}}) {
                    const double off_s = std::abs(frame / fps - known_s);
                    CHECK(off_s <= 0.11);
                    worst_s = std::max(worst_s, off_s);
                }
                if (i > 0) CHECK(made.gestures[i - 1].last < g.first);
                ++found;
            }
        }
        MESSAGE(found << " gestures, the worst time off by " << worst_s << " s");
        CHECK(found == 24 * 6);
    }

    TEST_CASE("wherever a recording is turned and stands, the cuts are the same") {
        const Recording recording = record(4, 77);
        const Segmentation here = segmented(recording.clip);
        const Segmentation there = segmented(moved(recording.clip, {{3.0, 0.0, -2.0}, yawRotation(2.0)}));
        REQUIRE(here.gestures.size() == there.gestures.size());
        for (std::size_t i = 0; i < here.gestures.size(); ++i) {
            CHECK(here.gestures[i].phases.onset_frame == there.gestures[i].phases.onset_frame);
            CHECK(here.gestures[i].phases.end_frame == there.gestures[i].phases.end_frame);
            CHECK(here.gestures[i].phases.hand == there.gestures[i].phases.hand);
        }
    }

    TEST_CASE("the mirrored recording is cut at the same frames, with the other hands") {
        const Recording recording = record(4, 78);
        const Segmentation here = segmented(recording.clip);
        const Segmentation image = segmented(mirrored(recording.clip));
        REQUIRE(here.gestures.size() == image.gestures.size());
        for (std::size_t i = 0; i < here.gestures.size(); ++i) {
            CHECK(here.gestures[i].first == image.gestures[i].first);
            CHECK(here.gestures[i].phases.peak_frame == image.gestures[i].phases.peak_frame);
            CHECK(here.gestures[i].last == image.gestures[i].last);
            CHECK(here.gestures[i].phases.hand == opposite(image.gestures[i].phases.hand));
        }
    }

    TEST_CASE("a person at rest makes no gesture, and one gesture is one") {
        Recording one = record(1, 5);
        CHECK(segmented(one.clip).gestures.size() == 1);
        Clip still = *trimmed(one.clip, 0, 0);
        rest(still, 10.0);
        addNoise(still, 6);
        const Segmentation none = segmented(still);
        CHECK(none.gestures.empty());
        CHECK(none.left_out.empty());
    }

    TEST_CASE("a gesture that the recording's begin or end cuts off is named and left out") {
        for (std::uint64_t seed = 40; seed < 46; ++seed) {
            const Recording whole = record(3, seed);
            const auto frame = [&](double time_s) {
                return static_cast<int>(std::lround(time_s / whole.clip.frame_time_s));
            };
            const int begin = frame(whole.known[0].peak_s);
            const int end = frame(whole.known[2].hold_s);
            const Segmentation made = segmented(*trimmed(whole.clip, begin, end));
            REQUIRE(made.gestures.size() == 1);
            CHECK(std::abs(made.gestures[0].phases.onset_frame - (frame(whole.known[1].onset_s) - begin)) <=
                  3);
            CHECK(std::abs(made.gestures[0].phases.end_frame - (frame(whole.known[1].end_s) - begin)) <= 3);
            REQUIRE(made.left_out.size() == 2);
            CHECK(made.left_out[0].first == 0);
            CHECK(made.left_out[0].hand == whole.known[0].hand);
            CHECK(made.left_out[0].why.find("begins") != std::string::npos);
            CHECK(made.left_out[1].last == end - begin);
            CHECK(made.left_out[1].hand == whole.known[2].hand);
            CHECK(made.left_out[1].why.find("ends") != std::string::npos);
        }
    }

    TEST_CASE("where both arms rise together, one gesture is taken and the other named") {
        const GeneratedClip left = builtIn("direct").generate({"T", {1.2, 1.2, 1.6}, 3, {}});
        const GeneratedClip right = builtIn("direct").generate({"T", {-1.2, 1.2, 1.6}, 3, {}});
        REQUIRE(left.hand == Side::left);
        REQUIRE(right.hand == Side::right);
        Clip both = right.clip;
        for (std::size_t f = 0; f < std::min(both.frames.size(), left.clip.frames.size()); ++f)
            for (const Bone bone : {Bone::leftUpperArm, Bone::leftLowerArm, Bone::leftHand}) {
                const auto j = static_cast<std::size_t>(referenceMap()[bone]);
                both.frames[f].joints[j] = left.clip.frames[f].joints[j];
            }
        rest(both, 1.0);
        const Segmentation made = segmented(both);
        REQUIRE(made.gestures.size() == 1);
        REQUIRE(made.gestures[0].remarks.size() == 1);
        CHECK(made.gestures[0].remarks[0].find("out of rest too") != std::string::npos);
        REQUIRE(made.left_out.size() == 1);
        CHECK(made.left_out[0].hand == opposite(made.gestures[0].phases.hand));

        SegmentationOptions by_holds;
        by_holds.by = CutBy::holds;
        const Segmentation holds = segmented(both, by_holds);
        REQUIRE(holds.gestures.size() == 2);
        CHECK(holds.gestures[0].phases.hand != holds.gestures[1].phases.hand);
        for (const Gesture& g : holds.gestures) CHECK(g.remarks.size() == 1);
    }

    TEST_CASE("holds between which the arm stays up are told apart by holds, and remarked on by returns") {
        // From target to target, the arm never lowered: the middle of one hold goes over into the next.
        std::vector<GeneratedClip> parts;
        for (const Vec3& target : {Vec3(-1.4, 1.3, 1.4), Vec3(-0.2, 1.3, 2.0), Vec3(-1.4, 0.6, 1.4)})
            parts.push_back(builtIn("direct").generate({"T", target, 4, {}}));
        Clip clip = parts[0].clip;
        clip.frames.resize(static_cast<std::size_t>(parts[0].hold_frame) + 1);
        std::vector<std::pair<int, int>> known{{parts[0].peak_frame, parts[0].hold_frame}};
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const auto& frames = parts[i].clip.frames;
            const auto peak = static_cast<std::size_t>(parts[i].peak_frame);
            REQUIRE(parts[i].hand == Side::right);
            const LocalPose from = clip.frames.back();
            constexpr int way = 15;
            for (int f = 1; f < way; ++f) {
                LocalPose pose = from;
                for (std::size_t j = 0; j < pose.joints.size(); ++j)
                    pose.joints[j].orientation = glm::slerp(
                        from.joints[j].orientation, frames[peak].joints[j].orientation, f / double(way));
                clip.frames.push_back(pose);
            }
            const auto last =
                i + 1 < parts.size() ? static_cast<std::size_t>(parts[i].hold_frame) + 1 : frames.size();
            const int begin = clip.frameCount();
            known.emplace_back(begin, begin + parts[i].hold_frame - parts[i].peak_frame);
            clip.frames.insert(clip.frames.end(), frames.begin() + parts[i].peak_frame,
                               frames.begin() + static_cast<std::ptrdiff_t>(last));
        }
        SegmentationOptions by_holds;
        by_holds.by = CutBy::holds;
        const Segmentation made = segmented(clip, by_holds);
        REQUIRE(made.gestures.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            CAPTURE(i);
            // A hold counts from where the hand is slower than 0.5 m/s: some frames before it has arrived.
            CHECK(made.gestures[i].phases.hand == Side::right);
            CHECK(made.gestures[i].phases.peak_frame <= known[i].first + 1);
            CHECK(made.gestures[i].phases.peak_frame >= known[i].first - 5);
            CHECK(made.gestures[i].phases.hold_frame >= known[i].second - 1);
            CHECK(made.gestures[i].phases.hold_frame <= known[i].second + 5);
        }
        const Segmentation whole = segmented(clip);
        REQUIRE(whole.gestures.size() == 1);
        // Of holds of one length the first.
        CHECK(std::abs(whole.gestures[0].phases.peak_frame - known[0].first) <= 3);
        CHECK(std::abs(whole.gestures[0].phases.hold_frame - known[0].second) <= 3);
        REQUIRE(whole.gestures[0].remarks.size() == 1);
        CHECK(whole.gestures[0].remarks[0] == "holds 3 times before the hand is back");
    }

    TEST_CASE("the stance at rest is found in spite of an added T pose, and can be given") {
        Recording recording = record(2, 12);
        recording.clip.frames.insert(recording.clip.frames.begin(), restPose(recording.clip.skeleton));
        const Segmentation found = segmented(recording.clip);
        CHECK(found.gestures.size() == 2);
        SegmentationOptions options;
        options.rest_frame = 1;
        const Segmentation given = segmented(recording.clip, options);
        REQUIRE(given.gestures.size() == 2);
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(given.gestures[i].phases.onset_frame == found.gestures[i].phases.onset_frame);
        options.rest_frame = recording.clip.frameCount();
        const auto outside = segment(recording.clip, referenceMap(), options);
        REQUIRE_FALSE(outside.has_value());
        CHECK(outside.error().text().find("as the frame at rest, expected 0 to") != std::string::npos);
    }

    TEST_CASE("what cannot be cut is rejected with the reason") {
        const Skeleton& skeleton = referenceHumanoid();
        Clip t_pose;
        t_pose.skeleton = skeleton;
        t_pose.frames.assign(60, restPose(skeleton));
        const auto no_rest = segment(t_pose, referenceMap());
        REQUIRE_FALSE(no_rest.has_value());
        CHECK(no_rest.error().text().find("never hangs still") != std::string::npos);

        HumanoidMap no_hand = referenceMap();
        no_hand[Bone::leftHand] = -1;
        const auto missing = segment(t_pose, no_hand);
        REQUIRE_FALSE(missing.has_value());
        CHECK(missing.error().text().find("leftHand") != std::string::npos);

        const Clip lying = moved(t_pose, {Vec3(0.0), glm::angleAxis(pi / 2, Vec3(1, 0, 0))});
        const auto not_upright = segment(lying, referenceMap());
        REQUIRE_FALSE(not_upright.has_value());
        CHECK(not_upright.error().text().find("upright") != std::string::npos);
    }

    TEST_CASE("in the person's own axes a clip begins over the origin and faces ahead") {
        const GeneratedClip made = builtIn("direct").generate({"T", {0.9, 1.1, 1.8}, 3, {}});
        const Pose away{{4.0, 0.0, -3.0}, yawRotation(-2.4)};
        const Clip recording = moved(made.clip, away);
        const Pose back = figureFromClip(recording, referenceMap(), 0);
        const Clip clip = moved(recording, back);
        const Vec3 hips = joint(worldAt(made.clip, 0), Bone::hips);
        for (int f = 0; f < clip.frameCount(); f += 20) {
            const Vec3 a = joint(worldAt(made.clip, f), Bone::rightHand) - Vec3(hips.x, 0.0, hips.z);
            CHECK(glm::length(a - joint(worldAt(clip, f), Bone::rightHand)) < 1e-9);
        }
        const Vec3 target = transformPoint(back, transformPoint(away, {0.9, 1.1, 1.8}));
        CHECK(glm::length(target - Vec3(0.9 - hips.x, 1.1, 1.8 - hips.z)) < 1e-9);
        CHECK(liesBehind({0.1, 1.0, -0.1}));
        CHECK_FALSE(liesBehind({2.0, 1.0, 0.1}));
    }
}
