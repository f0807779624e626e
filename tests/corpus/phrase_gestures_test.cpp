#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/random.hpp"
#include "core/text.hpp"
#include "library.hpp"
#include "motion/phrase_gestures/phrase_gestures.hpp"
#include "speech/sentences/speech_texts.hpp"

using namespace deixis;
using motion::GestureClass;
using motion::Hands;
using motion::SpeechStroke;

namespace {

/// A text in invented times: 0.07 s a letter, pauses at marks, and an accent on most of the longer words:
/// some hundred a minute, as people have (voices by flite have half of that).
Utterance spokenByNobody(const std::string& text, Random& random) {
    Utterance out;
    double time_s = 0.2;
    std::string word;
    for (const char c : text + " ") {
        if (c == ' ' || c == ',' || c == '.' || c == '?' || c == '!') {
            if (!word.empty()) {
                const double length_s = 0.07 * static_cast<double>(word.size()) + 0.04;
                if (word.size() > 3 && random.uniform() < 0.75)
                    out.accents.push_back({time_s, time_s + std::min(0.25, 0.7 * length_s),
                                           random.uniform(0.3, 1.0), static_cast<int>(out.words.size())});
                out.words.push_back({word, time_s, time_s + length_s});
                time_s += length_s;
            }
            word.clear();
            if (c != ' ') time_s += c == ',' ? 0.2 : 0.4;
        } else {
            word += c;
        }
    }
    out.duration_s = time_s + 0.2;
    return out;
}

struct Spoken {
    std::vector<Utterance> utterances;
    std::vector<motion::GesturedSpeech> speeches;
};

/// Fifty minutes.
const Spoken& fiftyMinutes() {
    static const Spoken spoken = [] {
        Spoken out;
        const auto texts = speech::drawSpeechTexts(tests::shippedGrammar(), 7, 260);
        REQUIRE(texts.has_value());
        Random random(3);
        double seconds = 0.0;
        for (std::size_t i = 0; i < texts->size() && seconds < 3000.0; ++i) {
            out.utterances.push_back(spokenByNobody((*texts)[i].text, random));
            seconds += out.utterances.back().duration_s;
            out.speeches.push_back(
                motion::gestureByPhrases(out.utterances.back(), tests::shippedLibrary(), i));
        }
        REQUIRE(seconds >= 3000.0);
        return out;
    }();
    return spoken;
}

motion::StrokeStatistics statisticsOf(const Spoken& spoken) {
    std::vector<std::vector<SpeechStroke>> strokes;
    for (const auto& one : spoken.speeches) strokes.push_back(one.strokes);
    return motion::strokeStatistics(spoken.utterances, strokes);
}

Vec3 wrist(const motion::UpperBodyPose& pose, bool right) {
    return motion::jointsOf(pose)[static_cast<std::size_t>(right ? motion::UpperJoint::right_wrist
                                                                 : motion::UpperJoint::left_wrist)];
}

/// Five words a second, each with an accent.
Utterance evenSpeech(const std::vector<std::string>& words) {
    Utterance out;
    for (std::size_t w = 0; w < words.size(); ++w) {
        const double start_s = 1.5 + 0.6 * static_cast<double>(w);
        out.words.push_back({words[w], start_s, start_s + 0.5});
        out.accents.push_back({start_s, start_s + 0.2, 0.7, static_cast<int>(w)});
    }
    out.duration_s = out.words.back().end_s + 2.5;
    return out;
}

}  // namespace

TEST_SUITE("corpus/phrase_gestures") {
    TEST_CASE("Over fifty minutes strokes are as published") {
        const auto found = statisticsOf(fiftyMinutes());
        const motion::PublishedGestures published;
        CAPTURE(found.apex_mean_s);
        CAPTURE(found.apex_sd_s);
        CHECK(found.strokes_per_minute == doctest::Approx(published.strokes_per_minute).epsilon(0.12));
        CHECK(found.with_accent == doctest::Approx(published.with_accent).epsilon(0.10));
        CHECK(found.beats_on_syllable == doctest::Approx(published.beats_on_syllable).epsilon(0.10));
        CHECK(std::abs(found.apex_mean_s - published.apex_mean_s) < 0.05);
        CHECK(found.apex_sd_s > 0.22);
        CHECK(found.apex_sd_s < 0.36);
        CHECK(found.right_hand == doctest::Approx(published.right_hand).epsilon(0.10));
        // Most are not referential, and metaphors are more than pictures.
        const auto share = [&](GestureClass c) { return found.classes[static_cast<std::size_t>(c)]; };
        CHECK(share(GestureClass::beat) > 0.5);
        CHECK(share(GestureClass::metaphoric) > 2.0 * share(GestureClass::iconic));
        CHECK(share(GestureClass::deictic) > 0.02);
    }

    TEST_CASE(
        "Motions are whole: as long as the sound, unit directions, at rest at both ends, never too fast") {
        const double most_m_s = motion::PhraseSpeaker{}.most_wrist_speed_m_s;
        const Spoken& spoken = fiftyMinutes();
        double fastest_m_s = 0.0;
        for (std::size_t i = 0; i < spoken.speeches.size(); ++i) {
            const auto& frames = spoken.speeches[i].motion.frames;
            REQUIRE(frames.size() == motion::frameCountOf(spoken.utterances[i].duration_s));
            for (const auto& pose : {frames.front(), frames.back()})
                for (std::size_t b = 0; b < motion::upper_bone_count; ++b)
                    CHECK(glm::length(pose.directions[b] - motion::relaxedUpperBody().directions[b]) < 1e-6);
            for (std::size_t f = 0; f < frames.size(); ++f)
                for (const Vec3& direction : frames[f].directions)
                    CHECK(std::abs(glm::length(direction) - 1.0) < 1e-9);
            for (std::size_t f = 1; f < frames.size(); ++f)
                for (const bool right : {true, false})
                    fastest_m_s = std::max(
                        fastest_m_s, glm::length(wrist(frames[f], right) - wrist(frames[f - 1], right)) *
                                         motion::upper_body_fps);
        }
        CHECK(fastest_m_s <= most_m_s);
        CHECK(fastest_m_s > 1.5);
    }

    TEST_CASE("Strokes are in order, begin before their apices and belong to their words") {
        const Spoken& spoken = fiftyMinutes();
        for (std::size_t i = 0; i < spoken.speeches.size(); ++i) {
            double before_s = 0.0;
            for (const SpeechStroke& stroke : spoken.speeches[i].strokes) {
                CHECK(stroke.begin_s <= stroke.stroke_s);
                CHECK(stroke.stroke_s < stroke.apex_s);
                CHECK(stroke.apex_s >= before_s);
                CHECK(stroke.apex_s < spoken.utterances[i].duration_s);
                before_s = stroke.apex_s;
                REQUIRE(stroke.word >= 0);
                REQUIRE(stroke.word < static_cast<int>(spoken.utterances[i].words.size()));
            }
        }
    }

    TEST_CASE("A stroke of the motion ends where the list says: the wrist is slower there than within it") {
        const Spoken& spoken = fiftyMinutes();
        int slower = 0, all = 0;
        for (const auto& speech : spoken.speeches)
            for (const SpeechStroke& stroke : speech.strokes) {
                if (stroke.hands == Hands::none) continue;
                const bool right = stroke.hands != Hands::left;
                const auto speed = [&](double time_s) {
                    constexpr double h = 0.02;
                    return glm::length(wrist(sample(speech.motion, time_s + h), right) -
                                       wrist(sample(speech.motion, time_s - h), right));
                };
                slower += speed(stroke.apex_s) < speed(0.5 * (stroke.stroke_s + stroke.apex_s));
                ++all;
            }
        CHECK(slower > 0.85 * all);
    }

    TEST_CASE("The same seed gives the same, another one something else") {
        const Utterance utterance = fiftyMinutes().utterances.front();
        const auto once = motion::gestureByPhrases(utterance, tests::shippedLibrary(), 5);
        const auto again = motion::gestureByPhrases(utterance, tests::shippedLibrary(), 5);
        const auto other = motion::gestureByPhrases(utterance, tests::shippedLibrary(), 6);
        CHECK(once.motion == again.motion);
        CHECK_FALSE(once.motion == other.motion);
    }

    TEST_CASE("Words get gestures that mean them, by the hand of that side or across") {
        std::map<std::string, int> of_left, of_big;
        double towards_left_m = 0.0;
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const Utterance left = evenSpeech({"left"}), big = evenSpeech({"enormous"});
            const auto pointing = motion::gestureByPhrases(left, tests::shippedLibrary(), seed);
            for (const auto& stroke : pointing.strokes) {
                ++of_left[stroke.gesture];
                if (stroke.gesture == "point_left" || stroke.gesture == "point_right")
                    towards_left_m +=
                        wrist(sample(pointing.motion, stroke.apex_s), stroke.hands == Hands::right).x;
            }
            for (const auto& stroke : motion::gestureByPhrases(big, tests::shippedLibrary(), seed).strokes)
                ++of_big[stroke.gesture];
        }
        CHECK(of_left["point_left"] + of_left["point_right"] > 20);
        CHECK(towards_left_m / (of_left["point_left"] + of_left["point_right"]) > 0.15);
        CHECK(of_big["apart"] > of_big["big"] / 2);
        CHECK(of_big["apart"] + of_big["embrace"] + of_big["big"] > 20);
    }

    TEST_CASE("Hands hold still at um and uh; without words nothing is gestured") {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const auto um =
                motion::gestureByPhrases(evenSpeech({"um", "uh", "er"}), tests::shippedLibrary(), seed);
            CHECK(um.strokes.empty());
        }
        // Nor where strokes are put on words without accents.
        Utterance filled = evenSpeech({"wonderful", "um", "uh", "er", "um", "day"});
        filled.accents.erase(filled.accents.begin() + 1, filled.accents.end() - 1);
        for (std::uint64_t seed = 0; seed < 20; ++seed)
            for (const auto& stroke : motion::gestureByPhrases(filled, tests::shippedLibrary(), seed).strokes)
                CHECK((stroke.word == 0 || stroke.word == 5));
        Utterance silence;
        silence.duration_s = 3.0;
        const auto still = motion::gestureByPhrases(silence, tests::shippedLibrary(), 1);
        CHECK(still.strokes.empty());
        CHECK(still.motion.frames.size() == 45);
        // A library without the gestures that are asked for: beats in an open posture.
        const auto poor = motion::gestureByPhrases(evenSpeech({"left", "big", "round"}), {}, 1);
        CHECK_FALSE(poor.strokes.empty());
        for (const auto& stroke : poor.strokes) CHECK(stroke.gesture == motion::held_beat);
    }
}
