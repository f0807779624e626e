#include "motion/unit_gestures/rule_set_a.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "assets/data/unit_gestures.hpp"
#include "paths.hpp"
#include "synthetic_speech.hpp"

using namespace deixis;
using namespace deixis::motion;
using deixis::tests::syntheticSpeech;
using doctest::Approx;

namespace {

const GestureLibrary& library() {
    static const GestureLibrary read =
        assets::loadUnitGestures(tests::sourceDir() / "assets/data/unit_gestures.toml").value();
    return read;
}

double fromRelaxed(const UpperBodyPose& pose) {
    const auto relaxed = jointsOf(relaxedUpperBody()), joints = jointsOf(pose);
    double most = 0.0;
    for (std::size_t j = 0; j < upper_joint_count; ++j)
        most = std::max(most, glm::length(joints[j] - relaxed[j]));
    return most;
}

/// Three words, the second accented.
Utterance threeWords(const std::string& second) {
    Utterance utterance;
    utterance.duration_s = 5.0;
    utterance.words = {{"the", 1.0, 1.2}, {second, 1.2, 1.8}, {"pencils", 1.8, 2.2}};
    utterance.accents = {{1.3, 1.5, 1.0, 1}};
    return utterance;
}

}  // namespace

TEST_SUITE("motion/rule_set_a") {
    TEST_CASE("Fifty minutes have the published numbers") {
        std::vector<Utterance> utterances;
        std::vector<std::vector<SpeechStroke>> strokes;
        double fastest = 0.0;
        for (std::uint64_t s = 0; s < 100; ++s) {
            utterances.push_back(syntheticSpeech(s, 30.0));
            const GesturedSpeech speech = gesturesByRuleSetA(utterances.back(), library(), s);
            REQUIRE(speech.motion.frames.size() == frameCountOf(30.0));
            strokes.push_back(speech.strokes);
            for (std::size_t f = 0; f < speech.motion.frames.size(); ++f) {
                for (const Vec3& d : speech.motion.frames[f].directions)
                    REQUIRE(glm::length(d) == Approx(1.0).epsilon(1e-12));
                if (f == 0) continue;
                const auto a = jointsOf(speech.motion.frames[f - 1]), b = jointsOf(speech.motion.frames[f]);
                for (const std::size_t wrist : {6, 9})
                    fastest = std::max(fastest, 15.0 * glm::length(b[wrist] - a[wrist]));
            }
            CHECK(fromRelaxed(speech.motion.frames.back()) < 1e-4);
        }
        const StrokeStatistics found = strokeStatistics(utterances, strokes);
        MESSAGE("strokes a minute " << found.strokes_per_minute << ", with accent " << found.with_accent
                                    << ", beats on syllable " << found.beats_on_syllable << ", apex "
                                    << found.apex_mean_s << " SD " << found.apex_sd_s << " s, right "
                                    << found.right_hand << ", iconic " << found.classes[0] << " metaphoric "
                                    << found.classes[1] << " deictic " << found.classes[2] << " beat "
                                    << found.classes[3] << " emblem " << found.classes[4] << ", fastest "
                                    << fastest << " m/s");
        const PublishedGestures published;
        CHECK(found.strokes_per_minute == Approx(published.strokes_per_minute).epsilon(0.10));
        CHECK(std::abs(found.with_accent - published.with_accent) < 0.04);
        CHECK(std::abs(found.beats_on_syllable - published.beats_on_syllable) < 0.06);
        CHECK(std::abs(found.apex_mean_s - published.apex_mean_s) < 0.03);
        CHECK(std::abs(found.apex_sd_s - published.apex_sd_s) < 0.05);
        CHECK(std::abs(found.right_hand - published.right_hand) < 0.06);
        for (std::size_t c = 0; c < gesture_class_count; ++c)
            CHECK(std::abs(found.classes[c] - published.classes[c]) < 0.05);
        CHECK(fastest < 3.0);
    }

    TEST_CASE("The same seed has the same bits, another one another motion") {
        const Utterance utterance = syntheticSpeech(3, 20.0);
        const GesturedSpeech a = gesturesByRuleSetA(utterance, library(), 5);
        CHECK(a.motion == gesturesByRuleSetA(utterance, library(), 5).motion);
        CHECK_FALSE(a.motion == gesturesByRuleSetA(utterance, library(), 6).motion);
    }

    TEST_CASE("Before the first preparation and at the end the body only sways") {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Utterance utterance = syntheticSpeech(seed, 12.0);
            for (SpokenWord& word : utterance.words) word = {word.text, word.start_s + 3.0, word.end_s + 3.0};
            for (Accent& accent : utterance.accents) {
                accent.start_s += 3.0;
                accent.end_s += 3.0;
            }
            utterance.duration_s += 6.0;
            const GesturedSpeech speech = gesturesByRuleSetA(utterance, library(), seed);
            REQUIRE_FALSE(speech.strokes.empty());
            double first_s = 100.0;
            for (const SpeechStroke& stroke : speech.strokes) first_s = std::min(first_s, stroke.begin_s);
            CHECK(first_s > 1.5);
            for (std::size_t f = 0; static_cast<double>(f) / 15.0 < first_s; ++f)
                CHECK(fromRelaxed(speech.motion.frames[f]) < 0.04);
            for (std::size_t f = speech.motion.frames.size() - 10; f < speech.motion.frames.size(); ++f)
                CHECK(fromRelaxed(speech.motion.frames[f]) < 0.04);
        }
    }

    TEST_CASE("A word's gesture is centred on it, one of its rule's, by the right side where sides matter") {
        int ruled = 0;
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const GesturedSpeech speech = gesturesByRuleSetA(threeWords("Right"), library(), seed);
            for (const SpeechStroke& stroke : speech.strokes) {
                if (!stroke.by_word_rule) continue;
                ++ruled;
                CHECK(stroke.word == 1);
                const bool own = stroke.gesture == "point_right" && stroke.hands == Hands::right;
                const bool across = stroke.gesture == "point_left" && stroke.hands == Hands::left;
                CHECK((own || across));
                CHECK(0.5 * (stroke.stroke_s + stroke.apex_s) == Approx(1.5));
                const auto frame = static_cast<std::size_t>(std::lround(stroke.apex_s * 15.0));
                const auto joints = jointsOf(speech.motion.frames[frame]);
                CHECK(std::min(joints[6].x, joints[9].x) < -0.12);
            }
        }
        CHECK(ruled > 20);
    }

    TEST_CASE("Plain words get beats at most, hesitations nothing") {
        int strokes = 0;
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            for (const SpeechStroke& stroke : gesturesByRuleSetA(threeWords("they"), library(), seed).strokes)
                if (stroke.word == 1 && stroke.hands != Hands::none) {
                    CHECK(stroke.gesture_class == GestureClass::beat);
                    ++strokes;
                }
            for (const SpeechStroke& stroke : gesturesByRuleSetA(threeWords("um"), library(), seed).strokes)
                CHECK(stroke.word != 1);
        }
        CHECK(strokes > 10);
    }

    TEST_CASE("A word mostly keeps its gesture from speech to speech") {
        std::vector<std::string> iconic;
        for (std::uint64_t seed = 0; seed < 200; ++seed)
            for (const SpeechStroke& stroke :
                 gesturesByRuleSetA(threeWords("garden"), library(), seed).strokes)
                if (stroke.word == 1 && stroke.gesture_class == GestureClass::iconic)
                    iconic.push_back(stroke.gesture);
        REQUIRE(iconic.size() > 30);
        const auto most = [&] {
            std::ptrdiff_t count = 0;
            for (const auto& id : iconic)
                count = std::max(count, std::count(iconic.begin(), iconic.end(), id));
            return static_cast<double>(count) / static_cast<double>(iconic.size());
        }();
        CHECK(most > 0.55);
        CHECK(most < 0.95);
    }

    TEST_CASE("Speeches without words or accents, short ones and odd ones are played, too") {
        Utterance silent;
        silent.duration_s = 3.0;
        const GesturedSpeech still = gesturesByRuleSetA(silent, library(), 1);
        CHECK(still.motion.frames.size() == 45);
        CHECK(still.strokes.empty());
        silent.duration_s = 0.0;
        CHECK(gesturesByRuleSetA(silent, library(), 1).motion.frames.size() == 1);
        Utterance odd = threeWords("x");
        odd.accents.push_back({4.9, 5.0, 1.0, 77});
        odd.accents.push_back({4.9, 5.0, 1.0, -1});
        CHECK(gesturesByRuleSetA(odd, library(), 1).motion.frames.size() == 75);
    }

    TEST_CASE("The usual rules name gestures that there are; others are refused") {
        CHECK(checkWordRules(usualWordRules(), library()).has_value());
        CHECK(usualWordRules().size() >= 40);
        CHECK(checkWordRules({{{"dance"}, {"tango"}}}, library()).error().where == "rule 0 (dance)");
        CHECK_FALSE(checkWordRules({{{}, {"nod"}}}, library()).has_value());
        CHECK(ruleFor(usualWordRules(), "Growing")->gestures.front() == "rising");
        CHECK(ruleFor(usualWordRules(), "PAST")->gestures.front() == "over_shoulder");
        CHECK(ruleFor(usualWordRules(), "zebra") == nullptr);
        CHECK(ruleFor(usualWordRules(), "") == nullptr);
        CHECK(isPlainWord("They"));
        CHECK_FALSE(isPlainWord("bridge"));
    }
}
