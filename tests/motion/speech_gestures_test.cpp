// Speech gestures at run time, by a model whose numbers are random: what holds for any weights. What a
// trained one does is in tests/learning.
#include "motion/speech_gestures/speech_gestures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gesture_weights.hpp"

using namespace deixis;
using namespace deixis::motion;
using tests::randomGestureWeights;
using tests::smallGestureShape;

namespace {

const SpeechGestureModel& model() {
    static const SpeechGestureModel out =
        SpeechGestureModel::read(randomGestureWeights(smallGestureShape())).value();
    return out;
}

const std::vector<float>& noise() {
    static const std::vector<float> out = [] {
        Random random(4);
        std::vector<float> samples;
        for (int i = 0; i < 16000 * 120; ++i)
            samples.push_back(static_cast<float>(random.normal() * std::abs(std::sin(i * 2e-4))));
        return samples;
    }();
    return out;
}

SpeechGestureRequest speech(double duration_s) {
    SpeechGestureRequest out;
    out.samples = std::span(noise()).first(static_cast<std::size_t>(duration_s * 16000));
    out.duration_s = duration_s;
    out.utterance.duration_s = duration_s;
    for (double at = 0.3; at + 0.4 < duration_s; at += 0.9)
        out.utterance.words.push_back({"shelf", at, at + 0.4});
    return out;
}

double apart(const UpperBodyPose& a, const UpperBodyPose& b) {
    double out = 0.0;
    for (std::size_t i = 0; i < upper_bone_count; ++i)
        out = std::max(out, glm::length(a.directions[i] - b.directions[i]));
    return out;
}
double largestStep(const UpperBodyMotion& motion, std::size_t first, std::size_t last) {
    double out = 0.0;
    for (std::size_t f = std::max<std::size_t>(1, first); f < last; ++f)
        out = std::max(out, apart(motion.frames[f], motion.frames[f - 1]));
    return out;
}

UpperBodyPose pointingUp() {
    UpperBodyPose out = relaxedUpperBody();
    out[UpperBone::right_upper_arm] = {-0.6, 0.8, 0.0};
    out[UpperBone::right_forearm] = {0.0, 0.8, 0.6};
    return out;
}

std::string refusal(const SpeechGestureRequest& request) {
    const auto made = model().generate(request);
    return made ? "made" : made.error().text();
}

}  // namespace

TEST_SUITE("motion/speech_gestures") {
    TEST_CASE(
        "motion is as long as the speech, of unit directions, the same each time, and hears and reads") {
        for (const double duration_s : {0.01, 1.0, 4.0, 4.01, 7.3}) {
            CAPTURE(duration_s);
            const auto made = model().generate(speech(duration_s)).value();
            CHECK(made.frames.size() == frameCountOf(duration_s));
            CHECK(model().generate(speech(duration_s)).value() == made);
            for (const UpperBodyPose& pose : made.frames)
                for (const Vec3& direction : pose.directions)
                    REQUIRE(glm::length(direction) == doctest::Approx(1.0));
        }
        const auto made = model().generate(speech(4.0)).value();
        SpeechGestureRequest other = speech(4.0);
        other.samples = std::span(noise()).subspan(16000, 64000);
        CHECK(model().generate(other).value() != made);
        other = speech(4.0);
        other.utterance.words.clear();
        CHECK(model().generate(other).value() != made);
        other.samples = {};
        CHECK(model().generate(other).has_value());
    }

    TEST_CASE("two minutes have no seams, and are at their end what they are at their beginning") {
        const auto made = model().generate(speech(120.0)).value();
        REQUIRE(made.frames.size() == 1800);
        const auto inside = [&](std::size_t f) { return apart(made.frames[f], made.frames[f - 1]); };
        double at_seams = 0.0, elsewhere = 0.0;
        int seams = 0, others = 0;
        for (std::size_t f = 60; f + 1 < 1800; ++f) {
            const bool seam = f % 30 <= 1 || f % 30 == 29;
            (seam ? at_seams : elsewhere) += inside(f);
            ++(seam ? seams : others);
        }
        CHECK(at_seams / seams < 1.5 * elsewhere / others);
        UpperBodyPose first{}, last{};
        for (std::size_t f = 0; f < 300; ++f)
            for (std::size_t b = 0; b < upper_bone_count; ++b) {
                first.directions[b] += made.frames[f].directions[b] / 300.0;
                last.directions[b] += made.frames[1799 - f].directions[b] / 300.0;
            }
        CHECK(apart(first, last) < 0.25);
    }

    TEST_CASE("a pose and a style change the motion around them, and 0 is a value other than none") {
        SpeechGestureRequest request = speech(6.0);
        const auto plain = model().generate(request).value();
        request.poses = {{45, pointingUp()}};
        const auto posed = model().generate(request).value();
        CHECK(posed != plain);
        CHECK(posed.frames.size() == plain.frames.size());
        // A style counts on posed frames, too.
        request.styles.assign(90, {.speed = 2.0});
        CHECK(model().generate(request).value().frames[45] != posed.frames[45]);
        SpeechGestureRequest zero = speech(6.0);
        zero.styles.assign(90, {});
        CHECK(model().generate(zero).value() == plain);
        zero.styles.assign(90, {.space = 0.0});
        CHECK(model().generate(zero).value() != plain);
        SpeechGestureRequest large = speech(6.0), larger = speech(6.0);
        large.styles.assign(90, {.handedness = 3.0});
        larger.styles.assign(90, {.handedness = 99.0});
        CHECK(model().generate(large).value() == model().generate(larger).value());
    }

    TEST_CASE("exact poses are met to the bit, one frame or many, wherever windows meet") {
        SpeechGestureRequest request = speech(10.0);
        request.exact = true;
        for (const int frame : {0, 29, 30, 31, 59, 60, 61, 62, 63, 89, 90, 120, 149})
            request.poses.push_back({frame, pointingUp()});
        const auto made = model().generate(request).value();
        for (const PoseControl& one : request.poses) {
            CAPTURE(one.frame);
            CHECK(made.frames[static_cast<std::size_t>(one.frame)] == one.pose);
        }
    }

    TEST_CASE(
        "what a window made is a pose for the next one, but just before a pose that only that one sees") {
        // Each frame is less far from the mean pose than the one nearer to the pose, or as far as it is
        // pinned to be.
        const auto copying = SpeechGestureModel::read(tests::copyingGestureWeights()).value();
        const UpperBodyPose mean = copying.meanPose();
        const auto off = [&](const UpperBodyMotion& motion, std::size_t f) {
            return apart(motion.frames[f], mean);
        };
        SpeechGestureRequest request = speech(10.0);
        CHECK(off(copying.generate(request).value(), 75) < 1e-5);
        request.poses = {{20, pointingUp()}};
        const auto early = copying.generate(request).value();
        CHECK(apart(early.frames[20], pointingUp()) < 1e-3);
        CHECK(off(early, 19) < off(early, 20));
        // Without what the first window made, the second one, from frame 30 on, would know nothing of it.
        CHECK(off(early, 58) > 0.02);
        request.poses = {{92, pointingUp()}};
        const auto late = copying.generate(request).value();
        CHECK(apart(late.frames[92], pointingUp()) < 1e-3);
        CHECK(off(late, 91) > 0.3);
        CHECK(off(late, 88) > 0.2);   // freed
        CHECK(off(late, 70) < 1e-3);  // pinned to what the window before made, which saw no pose
        // Seen by both, it needs no frame to be freed: that window made them with the pose in mind.
        request.poses = {{80, pointingUp()}};
        CHECK(off(copying.generate(request).value(), 70) > 0.1);
    }

    TEST_CASE("what is kept comes back to the bit, and what is changed joins it") {
        const auto before = model().generate(speech(20.0)).value();
        SpeechGestureRequest request = speech(20.0);
        request.keep = KeptMotion{before, {{100, 160}, {250, 260}}};
        request.poses = {{130, pointingUp()}};
        request.exact = true;
        const auto made = model().generate(request).value();
        const auto changed = [](std::size_t f) { return (f >= 100 && f < 160) || (f >= 250 && f < 260); };
        int different = 0;
        for (std::size_t f = 0; f < 300; ++f) {
            if (!changed(f)) REQUIRE(made.frames[f] == before.frames[f]);
            different += made.frames[f] != before.frames[f] ? 1 : 0;
        }
        CHECK(different > 40);
        CHECK(made.frames[130] == pointingUp());
        // No faster where the one joins the other than this restless model is anyway.
        for (const std::size_t seam : {100, 160, 250, 260})
            CHECK(largestStep(made, seam - 1, seam + 2) < largestStep(before, 0, 300));
        // Nothing to change: all of it.
        request = speech(20.0);
        request.keep = KeptMotion{before, {}};
        CHECK(model().generate(request).value() == before);
    }

    TEST_CASE("variety draws styles by the seed, and only those that are not set") {
        SpeechGestureRequest request = speech(6.0);
        const auto plain = model().generate(request).value();
        request.seed = 5;
        CHECK(model().generate(request).value() == plain);
        request.variety = 1.0;
        const auto drawn = model().generate(request).value();
        CHECK(drawn != plain);
        CHECK(model().generate(request).value() == drawn);
        SpeechGestureRequest other = request;
        other.seed = 6;
        CHECK(model().generate(other).value() != drawn);
        request.styles.assign(90, {.speed = 0.5, .space = 0.0, .handedness = -1.0});
        SpeechGestureRequest fixed = request;
        fixed.variety = 0.0;
        CHECK(model().generate(request).value() == model().generate(fixed).value());
    }

    TEST_CASE("requests that cannot be are refused by name") {
        SpeechGestureRequest request = speech(2.0);
        request.poses = {{30, relaxedUpperBody()}};
        CHECK(refusal(request).find("pose at frame 30, expected frames from 0 to 29") != std::string::npos);
        request = speech(2.0);
        request.styles.resize(29);
        CHECK(refusal(request).find("29 style controls, expected one for each of 30 frames") !=
              std::string::npos);
        request.styles.assign(30, {.space = NAN});
        CHECK(refusal(request).find("found nan at frame 0") != std::string::npos);
        request = speech(2.0);
        request.variety = -1.0;
        CHECK(refusal(request).find("variety: found -1") != std::string::npos);
        for (const double duration_s : {0.0, -1.0, 1e9, double(NAN)}) {
            request = speech(2.0);
            request.duration_s = duration_s;
            CHECK(refusal(request).find("found a duration") != std::string::npos);
        }
        request = speech(2.0);
        request.keep = KeptMotion{UpperBodyMotion{{relaxedUpperBody()}}, {}};
        CHECK(refusal(request).find("found a motion of 1 frames, expected 30") != std::string::npos);
        request.keep = KeptMotion{UpperBodyMotion{std::vector(30, relaxedUpperBody())}, {{5, 31}}};
        CHECK(refusal(request).find("range from 5 to 31") != std::string::npos);
        request.keep->changed = {{5, 10}};
        request.poses = {{10, relaxedUpperBody()}};
        CHECK(refusal(request).find("frame 10, which is kept") != std::string::npos);
        request.poses = {{9, relaxedUpperBody()}};
        CHECK(refusal(request) == "made");
        request.keep->motion.frames[3][UpperBone::neck] = {0.0, 2.0, 0.0};
        CHECK(refusal(request).find("length 2") != std::string::npos);
    }

    TEST_CASE("weights that are incomplete or of something else are refused by name") {
        const auto error = [](const NetworkWeights& weights) {
            return SpeechGestureModel::read(weights).error().text();
        };
        NetworkWeights weights = randomGestureWeights(smallGestureShape());
        weights.architecture = "moglow";
        CHECK(error(weights).find("these are weights of 'moglow', expected 'speech-gestures'") !=
              std::string::npos);
        weights = randomGestureWeights(smallGestureShape());
        weights.settings["hidden"] = 17.0;
        CHECK(error(weights).find("gru.0.forward.input_weight") != std::string::npos);
        weights.settings["hidden"] = -1.0;
        CHECK(error(weights).find("settings.hidden") != std::string::npos);
        for (const NamedArray& array : randomGestureWeights(smallGestureShape()).arrays) {
            weights = randomGestureWeights(smallGestureShape());
            std::erase_if(weights.arrays, [&](const NamedArray& one) { return one.name == array.name; });
            CHECK(error(weights).find(array.name + ": the array is missing") != std::string::npos);
        }
        weights = randomGestureWeights(smallGestureShape());
        weights.arrays.front().values.assign(27, 0.0F);
        CHECK(error(weights).find("mean_pose") != std::string::npos);
        CHECK(SpeechGestureModel::load("/nowhere/w").error().text().find("/nowhere/w") != std::string::npos);
        // The file and back, with the words in it.
        const auto back = decodeWeights(
            encodeWeights(randomGestureWeights(smallGestureShape()), WeightsPrecision::float16), "w");
        const auto read = SpeechGestureModel::read(back.value()).value();
        CHECK(read.words().count() == 2);
        CHECK(read.takesControls());
        CHECK(read.styleNorm().sd.handedness == 0.4);
    }
}
