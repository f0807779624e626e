// What several benchmarks start from; all of it is generated.
#pragma once

#include <stdexcept>
#include <string_view>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/generator.hpp"
#include "studies/session_fixture.hpp"

namespace deixis::bench {

/// The value, or an exception with the error's words: a benchmark has nobody to report to.
template <typename T>
T valueOf(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().text());
    return std::move(*result);
}

/// What a session shows: one gesture of the system `direct`, about three seconds at 30 fps.
inline motion::Clip pointingClip() {
    const auto direct = valueOf(
        motion::makeGenerator("direct", motion::referenceHumanoid(), motion::DemonstrationParameters{}));
    return direct->generate({"T001", {0.8, 1.3, 1.9}, 1}).clip;
}

/// A frame of an immersive session at 90 Hz.
constexpr double frame_time_s = 1.0 / 90.0;

/// Somebody in a small study (half of its trials are games) with that gesture in every trial.
struct Participant : tests::Driver {
    Participant() {
        clips = tests::OneClip(pointingClip());
        tests::Driver::frame_time_s = bench::frame_time_s;
        start();
    }

    [[nodiscard]] static bool showsClip(studies::PresentedState state) {
        return state == studies::PresentedState::playing || state == studies::PresentedState::pointing;
    }

    /// Reads pages and answers, over and over, until a clip plays.
    void toPlayingClip() {
        while (!showsClip(frame.state)) {
            if (finished()) {
                left = {};
                restart();
            }
            if (tests::answersOpen(frame)) {
                step();
                answerSomehow(0);
            } else if (tests::resting(frame)) {
                leavePage();
            } else {
                step();
            }
        }
    }
};

}  // namespace deixis::bench
