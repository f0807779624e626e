// Speakers who raise their hands as loud as they are: a corpus of which one knows what is to be learned.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "learning/gestures/training.hpp"

namespace deixis::tests {

/// Noise, as loud as a slow course from 0 to 1 says, with a word at its start. The arms rise with the
/// loudness, each by a share that is the take's own.
inline learning::GestureTake toyTake(std::uint64_t seed, double duration_s) {
    Random random(seed, "toy take");
    const double rate_a = random.uniform(0.3, 0.6), rate_b = random.uniform(0.15, 0.3);
    const double phase_a = random.uniform(0.0, 6.0), phase_b = random.uniform(0.0, 6.0);
    const auto loudnessAt = [=](double t) {
        const double wave =
            std::sin(2.0 * pi * rate_a * t + phase_a) + std::sin(2.0 * pi * rate_b * t + phase_b);
        return std::clamp(0.5 + 0.4 * wave, 0.0, 1.0);
    };
    const double left = random.uniform(0.2, 1.0), right = random.uniform(0.2, 1.0);
    learning::GestureTake out;
    for (int i = 0; i < static_cast<int>(duration_s * motion::speech_rate_hz); ++i)
        out.samples.push_back(static_cast<float>(
            0.3 * loudnessAt(static_cast<double>(i) / motion::speech_rate_hz) * random.normal()));
    out.utterance.duration_s = duration_s;
    out.utterance.words = {{"Well", 0.1, 0.4}};
    const std::size_t frames = motion::frameCountOf(duration_s);
    for (std::size_t f = 0; f < frames; ++f) {
        const double loudness = loudnessAt(static_cast<double>(f) * motion::upper_body_frame_time_s);
        motion::UpperBodyPose pose = motion::relaxedUpperBody();
        const auto raise = [&](motion::UpperBone upper, motion::UpperBone fore, double side, double share) {
            const double of_upper = 0.7 * share * loudness, of_fore = 2.2 * share * loudness;
            pose[upper] = {side * std::sin(of_upper), -std::cos(of_upper), 0.0};
            pose[fore] = {side * 0.6 * std::sin(of_fore), -std::cos(of_fore), 0.8 * std::sin(of_fore)};
        };
        raise(motion::UpperBone::left_upper_arm, motion::UpperBone::left_forearm, 1.0, left);
        raise(motion::UpperBone::right_upper_arm, motion::UpperBone::right_forearm, -1.0, right);
        out.motion.frames.push_back(pose);
    }
    return out;
}

inline learning::GestureTakes toyTakes(int training, int validation, double duration_s) {
    learning::GestureTakes out;
    for (int i = 0; i < training; ++i)
        out.training.push_back(toyTake(static_cast<std::uint64_t>(i), duration_s));
    for (int i = 0; i < validation; ++i)
        out.validation.push_back(toyTake(1000 + static_cast<std::uint64_t>(i), duration_s));
    motion::MatrixXf vectors(4, 2);
    vectors << 1.0F, 0.0F, 0.5F, -1.0F, 0.0F, 0.25F, 1.0F, 1.0F;
    out.words = motion::WordVectors({"well", "so"}, vectors);
    out.sha256 = "toy";
    return out;
}

/// A model that learns the toy corpus in half a minute.
inline learning::GestureSettings toySettings(int epochs) {
    learning::GestureSettings out;
    out.shape = {.sound_channels = 2,
                 .sound_size = 8,
                 .word_size = 4,
                 .word_channels = 8,
                 .word_levels = 2,
                 .text_size = 4,
                 .hidden = 64,
                 .layers = 2,
                 .controls = true};
    out.discriminator_hidden = 8;
    out.discriminator_layers = 1;
    out.epochs = epochs;
    out.stride = 15;
    out.batch = 16;
    out.learning_rate = 2e-3;
    out.gan_after = 15;
    out.foreign_share = 0.3;
    out.autoencoder_updates = 100;
    out.threads = 1;
    return out;
}

}  // namespace deixis::tests
