#include "motion/speech_gestures/gesture_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "core/text.hpp"
#include "motion/networks/layers.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

namespace {

constexpr std::size_t largest_vector = 1000;

/// Letters and digits alone, in lower case. Beyond ASCII all but quotes, dashes and dots (U+2000 to U+203F,
/// three bytes each) counts as letters.
std::string plainWord(std::string_view word) {
    std::string out;
    const std::string lower = lowerCase(word);
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const auto byte = static_cast<unsigned char>(lower[i]);
        if (lower.compare(i, 2, "\xE2\x80") == 0)
            i += 2;
        else if (byte >= 0x80 || std::isalnum(byte) != 0)
            out += lower[i];
    }
    return out;
}

/// Root mean square of the blocks of 20 ms that are at least a tenth as loud as the loudest.
double loudnessOf(const std::vector<float>& sound) {
    constexpr std::size_t block = 324;
    constexpr double least = 0.01;  // of the loudest's power
    std::vector<double> powers;
    for (std::size_t begin = 0; begin < sound.size(); begin += block) {
        const std::size_t end = std::min(begin + block, sound.size());
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) sum += static_cast<double>(sound[i]) * sound[i];
        powers.push_back(sum / static_cast<double>(end - begin));
    }
    if (powers.empty()) return 0.0;
    const double loudest = *std::ranges::max_element(powers);
    double sum = 0.0;
    int count = 0;
    for (const double power : powers)
        if (power >= least * loudest) {
            sum += power;
            ++count;
        }
    return std::sqrt(sum / count);
}

}  // namespace

std::vector<float> heardSound(std::span<const float> samples) {
    const auto given = static_cast<std::ptrdiff_t>(samples.size());
    if (given == 0) return {};
    const auto at = [&](std::ptrdiff_t i) {
        const float value = samples[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, given - 1))];
        return std::isfinite(value) ? static_cast<double>(value) : 0.0;
    };
    // 80 samples at 16 kHz are 81 at 16.2 kHz.
    std::vector<float> out(static_cast<std::size_t>(given * 81 / 80));
    for (std::size_t n = 0; n < out.size(); ++n) {
        const auto i = static_cast<std::ptrdiff_t>(n * 80 / 81);
        const double t = static_cast<double>(n * 80 % 81) / 81.0;
        const double a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        // Catmull & Rom (1974)
        out[n] = static_cast<float>(
            b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a))));
    }
    constexpr double silence = 1e-4;  // a recording that is no louder has nothing but noise
    const double loudness = std::max(silence, loudnessOf(out));
    for (float& value : out) value = static_cast<float>(value / loudness);
    return out;
}

std::vector<float> heardAround(std::span<const float> heard, int first, int count) {
    std::vector<float> out(static_cast<std::size_t>(sound_samples_per_frame) *
                               static_cast<std::size_t>(count - 1) +
                           sound_samples_heard);
    const std::ptrdiff_t begin = std::ptrdiff_t{sound_samples_per_frame} * first - sound_samples_heard / 2;
    const auto size = static_cast<std::ptrdiff_t>(heard.size());
    const auto from = std::clamp<std::ptrdiff_t>(begin, 0, size);
    const auto to = std::clamp<std::ptrdiff_t>(begin + static_cast<std::ptrdiff_t>(out.size()), from, size);
    std::copy(heard.begin() + from, heard.begin() + to,
              out.begin() + std::max<std::ptrdiff_t>(0, from - begin));
    return out;
}

WordVectors::WordVectors(std::vector<std::string> words, Eigen::MatrixXf vectors)
    : words_(std::move(words)), vectors_(std::move(vectors)) {
    if (vectors_.cols() != static_cast<Eigen::Index>(words_.size()))
        throw std::logic_error(fmt::format("found {} vectors of {} words", vectors_.cols(), words_.size()));
    for (std::size_t i = 0; i < words_.size(); ++i)
        if (std::string plain = plainWord(words_[i]); !plain.empty())
            places_.emplace(std::move(plain), static_cast<int>(i));
}

std::map<std::string, int, std::less<>>::const_iterator WordVectors::find(std::string_view word) const {
    const auto whole = places_.find(plainWord(word));
    if (whole != places_.end()) return whole;
    const std::size_t apostrophe = std::min(word.find('\''), word.find("\xE2\x80\x99"));
    if (apostrophe == std::string_view::npos || apostrophe == 0) return whole;
    return places_.find(plainWord(word.substr(0, apostrophe)));
}

Eigen::VectorXf WordVectors::vectorOf(std::string_view word) const {
    const auto at = find(word);
    if (at == places_.end()) return Eigen::VectorXf::Zero(vectors_.rows());
    return vectors_.col(at->second);
}

bool WordVectors::knows(std::string_view word) const {
    return find(word) != places_.end();
}

void WordVectors::append(NetworkWeights& weights) const {
    std::string joined;
    NamedArray array{"word_vectors", {words_.size(), static_cast<std::size_t>(vectors_.rows())}, {}};
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (i > 0) joined += ' ';
        joined += words_[i];
    }
    array.values.assign(vectors_.data(), vectors_.data() + vectors_.size());
    weights.settings["words"] = joined;
    weights.settings["word_size"] = static_cast<double>(vectors_.rows());
    if (!words_.empty()) weights.arrays.push_back(std::move(array));
}

Result<WordVectors> WordVectors::read(const NetworkWeights& weights) {
    const auto joined = weights.text("words");
    if (!joined) return tl::unexpected(joined.error());
    const auto size = weights.count("word_size", 1, static_cast<int>(largest_vector));
    if (!size) return tl::unexpected(size.error());
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < joined->size();) {
        const std::size_t end = std::min(joined->find(' ', begin), joined->size());
        words.push_back(joined->substr(begin, end - begin));
        begin = end + 1;
    }
    if (words.empty()) return WordVectors({}, Eigen::MatrixXf(*size, 0));
    auto rows = readMatrix(weights, "word_vectors", static_cast<int>(words.size()), *size);
    if (!rows) return tl::unexpected(rows.error());
    return WordVectors(std::move(words), rows->transpose());
}

Eigen::MatrixXf wordFrames(const Utterance& utterance, const WordVectors& vectors, int frames) {
    Eigen::MatrixXf out = Eigen::MatrixXf::Zero(vectors.size(), frames);
    double free_from = 0.0;
    for (const SpokenWord& word : utterance.words) {
        const double frame = std::max(free_from, std::floor(word.start_s * upper_body_fps));
        if (!(frame < frames)) break;
        out.col(static_cast<Eigen::Index>(frame)) = vectors.vectorOf(word.text);
        free_from = frame + 1.0;
    }
    return out;
}

}  // namespace deixis::motion
