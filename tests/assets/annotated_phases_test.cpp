// The phase detector against phases that were annotated by hand in real recordings.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "assets/joints/clip_import.hpp"
#include "motion/gestures/segmentation.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/pointing/phases.hpp"
#include "shared_data.hpp"

using namespace deixis;
using motion::Side;

namespace {

const std::string traffic = "pointing/cmu_directing_traffic/DERIVED_directing_traffic_4_30fps.bvh";
const std::string kinect = "pointing/labanotation_kinect/";

/// Who annotated, and how: one annotator, a language model that works on this program, once, by reading a
/// table of each frame's fingertip height over the shoulder, reach (shoulder to hand over the arm's length)
/// and fingertip speed (hand joint in the Kinect recordings); before this detector was run on them, but not
/// blind: what an earlier cutting by holds found in the traffic take had been seen. No video was seen and
/// nobody annotated a second time, so that agreement between annotators is not known. Onset: the last frame
/// at rest, or all but still, before the movement into the hold. Peak: the frame in which that movement is
/// over. Hold: the last frame before the hand sets out again. End: the frame in which it next rests, or all
/// but stops or turns. Each is uncertain by 2 frames (of 30 a second) where the hand stands still, by 4 and
/// more where it drifts; those marked -1 could not be told: the hand passes into another movement there.
///
/// Only the last one is a person who was asked to point. The traffic take is an actor who directs traffic:
/// arms held out, straight or nearly, with no target known and hardly a rest between; of the other Kinect
/// recordings the two in which an arm is held out still were taken.
struct Annotated {
    std::string file;
    Side hand;
    int onset, peak, hold, end;
    bool from_rest = false;  ///< the hand rests before it sets out, as in a clip
};
const std::vector<Annotated> annotated{
    {traffic, Side::left, 18, 53, 62, 74, true},
    {traffic, Side::left, 228, 237, 254, 269},
    {traffic, Side::right, 229, 239, 254, -1},
    {traffic, Side::left, 315, 324, 335, 360},
    {traffic, Side::right, 316, 323, 339, 359},
    {traffic, Side::left, 522, 538, 563, 584, true},
    {traffic, Side::right, 524, 538, 562, 583, true},
    {traffic, Side::left, 649, 663, 667, 688},
    {traffic, Side::right, 649, 662, 667, 688},
    {traffic, Side::left, 667, 688, 726, -1},
    {traffic, Side::right, 666, 688, 727, -1},
    {traffic, Side::left, 815, 824, 838, 857},
    {traffic, Side::right, -1, 823, 838, 856},
    {kinect + "Ges03_drawlines.csv", Side::right, 134, 157, 168, 188},
    {kinect + "Ges04_comehere.csv", Side::right, 15, 40, 131, 153, true},
    {kinect + "Ges05_demopoint.csv", Side::right, 78, 111, 132, 162, true},
};

constexpr std::array phase_names{"onset", "peak", "hold", "end"};

/// Distances to the annotation, frames, by phase.
struct Agreement {
    std::array<std::vector<int>, 4> off{};

    void add(const Annotated& by_hand, const motion::GesturePhases& found) {
        const std::array known{by_hand.onset, by_hand.peak, by_hand.hold, by_hand.end};
        const std::array frames{found.onset_frame, found.peak_frame, found.hold_frame, found.end_frame};
        std::string line;
        for (std::size_t i = 0; i < 4; ++i) {
            line += fmt::format(" {} {}", phase_names[i], frames[i]);
            if (known[i] < 0) continue;
            off[i].push_back(std::abs(frames[i] - known[i]));
            line += fmt::format(" ({:+})", frames[i] - known[i]);
        }
        MESSAGE(by_hand.file << " " << by_hand.peak << line);
    }
    [[nodiscard]] std::vector<int> all() const {
        std::vector<int> out;
        for (const auto& of : off) out.insert(out.end(), of.begin(), of.end());
        std::sort(out.begin(), out.end());
        return out;
    }
    [[nodiscard]] double within(int frames) const {
        const auto of = all();
        return static_cast<double>(std::upper_bound(of.begin(), of.end(), frames) - of.begin()) /
               static_cast<double>(of.size());
    }
    void tell(const std::string& what) const {
        std::string line;
        for (std::size_t i = 0; i < 4; ++i)
            line += fmt::format(
                " {} {:.1f}", phase_names[i],
                std::accumulate(off[i].begin(), off[i].end(), 0.0) / static_cast<double>(off[i].size()));
        const auto of = all();
        MESSAGE(what << ", " << of.size() << " phases, mean frames off:" << line << "; median "
                     << of[of.size() / 2] << ", within 3 frames " << within(3) << ", within 6 " << within(6)
                     << ", farthest " << of.back());
    }
};

struct Recording {
    motion::Clip clip;
    motion::HumanoidMap map;
};

Recording recording(const std::string& file) {
    auto imported = assets::importClip(tests::sharedData(file));
    REQUIRE(imported.has_value());
    const auto map = motion::detectHumanoid(imported->clip.skeleton);
    return {std::move(imported->clip), map};
}

}  // namespace

TEST_SUITE("assets/annotated_phases") {
    TEST_CASE("of gestures from rest, cut out one by one, the phases are found where they were annotated") {
        DEIXIS_SKIP_WITHOUT(tests::sharedData(traffic));
        Agreement agreement;
        for (const Annotated& by_hand : annotated) {
            if (!by_hand.from_rest) continue;
            const Recording whole = recording(by_hand.file);
            // From a little before the onset to a little after the end.
            constexpr int margin = 4;
            const int from = std::max(0, by_hand.onset - margin);
            const int to = std::min(whole.clip.frameCount() - 1, by_hand.end + margin);
            motion::Clip piece = whole.clip;
            piece.frames.assign(whole.clip.frames.begin() + from, whole.clip.frames.begin() + to + 1);
            const auto trajectory = motion::jointTrajectory(motion::worldPoses(piece),
                                                            whole.map[motion::armBones(by_hand.hand).hand]);
            auto found = motion::detectPhases(trajectory, by_hand.hand, piece.frame_time_s);
            REQUIRE(found.has_value());
            for (int* frame : {&found->phases.onset_frame, &found->phases.peak_frame,
                               &found->phases.hold_frame, &found->phases.end_frame})
                *frame += from;
            agreement.add(by_hand, found->phases);
        }
        agreement.tell("clips");
        CHECK(agreement.within(3) >= 0.75);
    }

    TEST_CASE("cut by holds, the straight-armed ones are found in the recordings as they are") {
        DEIXIS_SKIP_WITHOUT(tests::sharedData(traffic));
        Agreement agreement;
        int found = 0;
        for (const Annotated& by_hand : annotated) {
            const Recording whole = recording(by_hand.file);
            motion::SegmentationOptions by_holds;
            by_holds.by = motion::CutBy::holds;
            const auto made = motion::segment(whole.clip, whole.map, by_holds);
            REQUIRE(made.has_value());
            const auto same = std::find_if(
                made->gestures.begin(), made->gestures.end(), [&](const motion::Gesture& gesture) {
                    return gesture.phases.hand == by_hand.hand && gesture.phases.peak_frame <= by_hand.hold &&
                           gesture.phases.hold_frame >= by_hand.peak;
                });
            if (same == made->gestures.end()) continue;
            ++found;
            agreement.add(by_hand, same->phases);
        }
        agreement.tell("recordings, by holds");
        CHECK(found >= 10);
        CHECK(agreement.within(6) >= 0.75);
    }

    TEST_CASE("of the two hands the one that points is recognised") {
        DEIXIS_SKIP_WITHOUT(tests::sharedData(kinect + "Ges05_demopoint.csv"));
        const Recording whole = recording(kinect + "Ges05_demopoint.csv");
        CHECK(motion::recognisedHand(motion::worldPoses(whole.clip), whole.map).hand == Side::right);
    }
}
