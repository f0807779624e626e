#include "simulated_rater.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis::studies {

namespace {

double share(double value, double none, double all) {
    return std::clamp((value - none) / (all - none), 0.0, 1.0);
}

}  // namespace

Traits::Traits(const SimulatedParameters& parameters, std::uint64_t seed) {
    Random person(seed, "person");
    observer = parameters.observer;
    observer.noise_rad *= std::max(0.2, 1.0 + parameters.pointing_noise_between * person.normal());
    rating_bias = parameters.rating_bias_between * person.normal();
    questionnaire_bias = parameters.questionnaire_bias_between * person.normal();
}

SimulatedRater::SimulatedRater(const SimulatedParameters& parameters, const Traits& traits,
                               std::uint64_t seed)
    : parameters_(parameters),
      traits_(traits),
      ratings_(seed, "ratings"),
      confidences_(seed, "confidences"),
      questions_(seed, "questions"),
      attention_(seed, "attention") {}

double SimulatedRater::naturalness(const SeenGesture& seen) {
    const double profile = share(seen.peak_over_mean, parameters_.profile_abrupt, parameters_.profile_smooth);
    const double participation = 1.0 - std::exp(-seen.participation_deg / parameters_.participation_deg);
    const double steadiness =
        share(seen.hold_speed_m_s, parameters_.unsteady_speed_m_s, parameters_.steady_speed_m_s);
    return parameters_.rating_base + parameters_.rating_profile_weight * profile +
           parameters_.rating_participation_weight * participation +
           parameters_.rating_steadiness_weight * steadiness + traits_.rating_bias +
           parameters_.rating_noise_within * ratings_.normal();
}

double SimulatedRater::confidence(double margin_rad) {
    const double clear = 1.0 - std::exp(-margin_rad / radiansFromDegrees(parameters_.confidence_margin_deg));
    return 1.0 + 4.0 * clear + parameters_.confidence_noise_within * confidences_.normal();
}

double SimulatedRater::questionnaireAnswer() {
    const double of_range =
        0.5 + traits_.questionnaire_bias + parameters_.questionnaire_noise_within * questions_.normal();
    return 1.0 + 4.0 * of_range;
}

std::size_t SimulatedRater::anyOption(std::size_t count) {
    return questions_.below(count);
}

bool SimulatedRater::overlooks() {
    return attention_.uniform() < parameters_.attention_lapse_rate;
}

int onScale(double judgement, int low, int high) {
    const double value = low + (judgement - 1.0) * (high - low) / 4.0;
    return static_cast<int>(std::floor(std::clamp<double>(value, low, high) + 0.5));
}

std::size_t preference(const SimulatedParameters& parameters, double left, double right,
                       std::size_t options) {
    const double difference = right - left;
    const double size = std::abs(difference);
    const std::size_t half = options / 2;  // answers on each side
    if (options % 2 == 1 && size <= parameters.preference_tie_zone) return half;
    // From 1, the slightest on its side, to `half`.
    const std::size_t strength =
        size <= parameters.preference_clear_zone ? std::min<std::size_t>(1, half) : half;
    if (difference < 0.0) return half - strength;
    return options - 1 - half + strength;
}

std::optional<int> lastNumberOn(const Panel& board) {
    std::optional<int> found;
    for (const PanelText& line : board.texts) {
        const std::string& text = line.text;
        for (std::size_t start = 0; start < text.size(); ++start) {
            if (!isDigit(text[start])) continue;
            std::size_t stop = start;
            while (stop < text.size() && isDigit(text[stop])) ++stop;
            // A minus belongs to the number where nothing stands before it that it could be a hyphen of.
            const bool negative =
                start > 0 && text[start - 1] == '-' && (start == 1 || text[start - 2] == ' ');
            if (const auto number = wholeNumber(text.substr(start, stop - start)))
                found = static_cast<int>(negative ? -*number : *number);
            start = stop;
        }
    }
    return found;
}

}  // namespace deixis::studies
