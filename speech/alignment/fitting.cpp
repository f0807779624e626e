#include "fitting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/order_statistics.hpp"

namespace deixis::speech {

namespace {

/// For each frame. Words that fit have -8 to -14, in noise of 10 dB -13 to -37, others about -55; any phones
/// -25 to -35.
constexpr double good_score = -40.0;
constexpr double doubtful_margin = 15.0;
/// Of the frames of all words.
constexpr double doubtful_part = 0.3;

/// Against the median within words: of what may be speech.
constexpr double loud_db = -12.0;

int framesOf(const FoundWord& word) {
    return word.last - word.first + 1;
}

double scorePerFrame(const std::vector<FoundWord>& words) {
    double score = 0.0, frames = 0.0;
    for (const FoundWord& word : words) {
        score += word.score;
        frames += framesOf(word);
    }
    return score / frames;
}

}  // namespace

const std::vector<std::string>& cmuPhones() {
    static const std::vector<std::string> phones{"AA", "AE", "AH", "AO", "AW", "AY", "B",  "CH", "D",  "DH",
                                                 "EH", "ER", "EY", "F",  "G",  "HH", "IH", "IY", "JH", "K",
                                                 "L",  "M",  "N",  "NG", "OW", "OY", "P",  "R",  "S",  "SH",
                                                 "T",  "TH", "UH", "UW", "V",  "W",  "Y",  "Z",  "ZH"};
    return phones;
}

std::string phoneWord(const std::string& phone) {
    return "phone_" + phone;
}

const std::string& anyPhones() {
    static const std::string grammar = [] {
        std::string out;
        for (const std::string& phone : cmuPhones()) out += (out.empty() ? "( " : " | ") + phoneWord(phone);
        return out + " )+";
    }();
    return grammar;
}

std::optional<Stretch> doubtfulStretch(const std::vector<FoundWord>& words,
                                       const std::function<std::vector<FoundWord>()>& any_phones) {
    double limit = good_score;
    double frames = 0.0, doubtful = 0.0;
    const auto count = [&] {
        frames = doubtful = 0.0;
        for (const FoundWord& word : words) {
            frames += framesOf(word);
            if (word.score < limit * framesOf(word)) doubtful += framesOf(word);
        }
        return doubtful > doubtful_part * frames;
    };
    if (!count()) return std::nullopt;
    if (const auto phones = any_phones(); !phones.empty())
        limit = std::min(limit, scorePerFrame(phones) - doubtful_margin);
    if (!count()) return std::nullopt;
    Stretch longest, current;
    int longest_frames = 0, current_frames = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].score >= limit * framesOf(words[i])) {
            current_frames = 0;
            continue;
        }
        if (current_frames == 0) current.first = i;
        current.last = i;
        current_frames += framesOf(words[i]);
        if (current_frames > longest_frames) {
            longest_frames = current_frames;
            longest = current;
        }
    }
    return longest;
}

std::optional<std::pair<int, int>> soundBesides(const std::vector<FoundWord>& words,
                                                const std::vector<std::int16_t>& samples) {
    constexpr std::size_t per_frame = sphinx_rate_hz / sphinx_frames_per_s;
    std::vector<double> powers(samples.size() / per_frame);
    for (std::size_t i = 0; i < powers.size(); ++i)
        for (std::size_t k = 0; k < per_frame; ++k) {
            const double sample = samples[i * per_frame + k];
            powers[i] += sample * sample;
        }
    const auto frames = static_cast<int>(powers.size());
    std::vector<double> in_words;
    for (const FoundWord& word : words)
        for (int i = word.first; i <= std::min(word.last, frames - 1); ++i)
            in_words.push_back(powers[static_cast<std::size_t>(i)]);
    if (in_words.empty()) return std::nullopt;
    const double loud = upperMedian(std::move(in_words)) * std::pow(10.0, loud_db / 10.0);
    for (std::size_t i = 0; i <= words.size(); ++i) {
        const int first = i == 0 ? 0 : words[i - 1].last + 1;
        const int end = i == words.size() ? frames : std::min(words[i].first, frames);
        int count = 0;
        for (int k = first; k < end; ++k) count += powers[static_cast<std::size_t>(k)] > loud ? 1 : 0;
        if (count >= sphinx_frames_per_s) return std::pair(first, end);
    }
    return std::nullopt;
}

std::vector<double> syllableBounds(double start_s, double end_s, const std::vector<std::size_t>& lengths,
                                   const FoundWord* phones) {
    std::vector<double> out{start_s};
    if (phones != nullptr) {
        std::size_t phone = 0;
        for (std::size_t i = 0; i + 1 < lengths.size(); ++i) {
            phone += lengths[i];
            out.push_back(static_cast<double>(phones[phone].first) / sphinx_frames_per_s);
        }
        out.push_back(end_s);
        constexpr double shortest_s = 1.0 / sphinx_frames_per_s;
        const bool within = std::adjacent_find(out.begin(), out.end(), [](double a, double b) {
                                return b - a < 0.999 * shortest_s;
                            }) == out.end();
        if (within || lengths.size() == 1) return out;
        out.resize(1);
    }
    double all = 0.0, until = 0.0;
    for (const std::size_t length : lengths) all += static_cast<double>(length);
    for (const std::size_t length : lengths) {
        until += static_cast<double>(length);
        out.push_back(start_s + (end_s - start_s) * until / all);
    }
    return out;
}

}  // namespace deixis::speech
