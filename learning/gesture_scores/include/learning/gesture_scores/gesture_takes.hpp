// What a model of speech gestures learns from and is tried out on.
#pragma once

#include <string>
#include <vector>

#include "core/utterance.hpp"
#include "motion/speech_gestures/gesture_inputs.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::learning {

/// A speech and the motion of who spoke.
struct GestureTake {
    std::vector<float> samples;  ///< mono, 16 kHz
    Utterance utterance;
    motion::UpperBodyMotion motion;  ///< frame i is at i / 15 s of the sound
};

struct GestureTakes {
    std::vector<GestureTake> training;
    /// Held out: what the weights that are kept are chosen by.
    std::vector<GestureTake> validation;
    motion::WordVectors words;  ///< stay as they are, and go into the file
    std::string sha256;         ///< of what the takes were made from
    bool synthetic = true;      ///< whether they were
};

}  // namespace deixis::learning
