// What a simulated participant makes of what it saw: ratings, preferences, confidence, and answers to
// questions about itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/random.hpp"
#include "simulated_observer.hpp"
#include "studies/simulation/simulated_participant.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

/// What tells one simulated participant from another.
struct Traits {
    Traits(const SimulatedParameters& parameters, std::uint64_t seed);
    ObserverModel observer{};
    double rating_bias = 0.0;         ///< steps of a scale from 1 to 5
    double questionnaire_bias = 0.0;  ///< share of a scale's range
};

/// Judges on a scale from 1 to 5, not rounded nor clamped. Each kind of answer draws from random numbers of
/// its own, so that none depends on how many others there were.
class SimulatedRater {
  public:
    SimulatedRater(const SimulatedParameters& parameters, const Traits& traits, std::uint64_t seed);

    [[nodiscard]] double naturalness(const SeenGesture& seen);
    /// `margin_rad`: by how much more the next best ball was missed.
    [[nodiscard]] double confidence(double margin_rad);
    /// An answer to a question of a questionnaire with a scale or a range of numbers.
    [[nodiscard]] double questionnaireAnswer();
    /// One of several options that have no order.
    [[nodiscard]] std::size_t anyOption(std::size_t count);
    /// Whether it misses the number of an attention check.
    [[nodiscard]] bool overlooks();

  private:
    SimulatedParameters parameters_;
    Traits traits_;
    Random ratings_, confidences_, questions_, attention_;
};

/// The judgement (1 to 5) as a whole number of another scale.
[[nodiscard]] int onScale(double judgement, int low, int high);

/// Which of `options`, from clearly left to clearly right, says how two judgements differ. The middle one of
/// an odd number is no preference; of an even number there is none, and a difference within the tie zone goes
/// to its side.
[[nodiscard]] std::size_t preference(const SimulatedParameters& parameters, double left, double right,
                                     std::size_t options);

/// The last whole number that a board says; none where there is none.
[[nodiscard]] std::optional<int> lastNumberOn(const Panel& board);

}  // namespace deixis::studies
