#include "speech/prosody/accents.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/order_statistics.hpp"
#include "speech/prosody/pitch.hpp"

namespace deixis::speech {

namespace {

constexpr double around_s = 1.0;
constexpr double neighbour_s = 0.15;
constexpr double pause_s = 0.1;
constexpr double lengthening = 1.4;
constexpr double most_of_one = 2.0;
constexpr double pitch_weight = 2.0;
constexpr double least_sum = 1.0;
constexpr double least_sum_of_weak = 2.0;

struct Heard {
    double middle_s = 0.0;
    std::optional<double> semitones{};  ///< above 1 Hz, its highest; none: unvoiced
    double loudest_db = silence_db;
    double octaves = 0.0;  ///< of its duration
    double sum = 0.0;
};

Heard heardOf(const std::vector<Syllable>& syllables, std::size_t at, const std::vector<double>& pitch,
              const std::vector<double>& loudness) {
    const Syllable& syllable = syllables[at];
    Heard out;
    out.middle_s = 0.5 * (syllable.start_s + syllable.end_s);
    auto first = static_cast<std::size_t>(std::lround(syllable.start_s * prosody_frames_per_s));
    auto last = static_cast<std::size_t>(std::lround(syllable.end_s * prosody_frames_per_s));
    // Frames at the border hear the neighbour, too.
    if (last > first + 2) {
        ++first;
        --last;
    }
    std::vector<double> voiced;
    for (std::size_t i = first; i <= last && i < loudness.size(); ++i) {
        out.loudest_db = std::max(out.loudest_db, loudness[i]);
        if (pitch[i] > 0.0) voiced.push_back(12.0 * std::log2(pitch[i]));
    }
    if (!voiced.empty()) {
        // Not the very highest: a frame may be wrong.
        const std::size_t rank = voiced.size() - 1 - voiced.size() / 10;
        out.semitones = orderStatistic(std::move(voiced), rank);
    }
    const bool before_pause =
        at + 1 == syllables.size() || syllables[at + 1].start_s - syllable.end_s > pause_s;
    out.octaves = std::log2((syllable.end_s - syllable.start_s) / (before_pause ? lengthening : 1.0));
    return out;
}

double medianOf(const std::vector<double>& values) {
    return values.empty() ? 0.0 : upperMedian(values);
}

double timesAbove(double value, double median, double unit) {
    return std::clamp((value - median) / unit, 0.0, most_of_one);
}

}  // namespace

std::vector<Accent> accentsOf(const std::vector<Syllable>& syllables, const std::vector<double>& pitch,
                              const std::vector<double>& loudness) {
    std::vector<Heard> heard;
    for (std::size_t i = 0; i < syllables.size(); ++i)
        heard.push_back(heardOf(syllables, i, pitch, loudness));

    std::size_t first = 0, last = 0;  // of those around, `last` not included
    for (Heard& here : heard) {
        while (heard[first].middle_s < here.middle_s - around_s) ++first;
        while (last < heard.size() && heard[last].middle_s <= here.middle_s + around_s) ++last;
        std::vector<double> semitones, loudest, octaves;
        for (std::size_t k = first; k < last; ++k) {
            if (heard[k].semitones) semitones.push_back(*heard[k].semitones);
            loudest.push_back(heard[k].loudest_db);
            octaves.push_back(heard[k].octaves);
        }
        here.sum = timesAbove(here.loudest_db, medianOf(loudest), 4.0) +
                   timesAbove(here.octaves, medianOf(octaves), 0.5);
        if (here.semitones) here.sum += pitch_weight * timesAbove(*here.semitones, medianOf(semitones), 2.0);
    }

    const auto canBeAccented = [&](std::size_t i) {
        return syllables[i].stressed && heard[i].sum >= (syllables[i].weak ? least_sum_of_weak : least_sum);
    };
    std::vector<Accent> out;
    for (std::size_t i = 0; i < heard.size(); ++i) {
        if (!canBeAccented(i)) continue;
        bool highest = true;
        for (std::size_t k = i; k-- > 0 && syllables[k].end_s > syllables[i].start_s - neighbour_s;)
            highest = highest && !(canBeAccented(k) && heard[k].sum > heard[i].sum);
        for (std::size_t k = i + 1;
             k < heard.size() && syllables[k].start_s < syllables[i].end_s + neighbour_s; ++k)
            highest = highest && !(canBeAccented(k) && heard[k].sum >= heard[i].sum);
        if (highest)
            out.push_back({syllables[i].start_s, syllables[i].end_s, 1.0 - std::exp(-heard[i].sum / 3.0),
                           syllables[i].word});
    }
    return out;
}

}  // namespace deixis::speech
