// What the gesture model learns from: speeches with their words, accents and the motion of who spoke; made by
// us, or recorded by a lab.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/utterance.hpp"
#include "motion/unit_gestures/speech_strokes.hpp"
#include "motion/upper_body/upper_body.hpp"
#include "speech/sentences/speech_texts.hpp"

namespace deixis::learning {

constexpr int corpus_rate_hz = 16000;

/// Who made the gestures.
enum class Gesturer : unsigned char { rules_a, rules_b, person };
[[nodiscard]] std::string_view gesturerName(Gesturer gesturer);  ///< "rules A", "rules B", "person"

struct CorpusTake {
    std::string name;  ///< unique in its corpus; fit for a file
    speech::CorpusPart part = speech::CorpusPart::training;
    std::string text;
    std::string voice;  ///< of a synthetic speech
    Gesturer gesturer = Gesturer::person;
    std::vector<float> samples;  ///< mono, corpus_rate_hz
    Utterance utterance;
    motion::UpperBodyMotion motion;             ///< frameCountOf(utterance.duration_s) frames
    std::vector<motion::SpeechStroke> strokes;  ///< where rules made them
};

struct Corpus {
    std::vector<CorpusTake> takes;
    bool synthetic = false;
};

/// SHA-256 of all that a model learns from: parts, samples, words and motions, in order.
[[nodiscard]] std::string corpusHash(const Corpus& corpus);

}  // namespace deixis::learning
