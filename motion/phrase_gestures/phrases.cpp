#include "phrases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/text.hpp"

namespace deixis::motion {

namespace {

constexpr std::array<std::string_view, 7> fillers{"um", "uh", "er", "hmm", "ah", "erm", "mm"};

/// Words that seldom bear an accent; a phrase that is too long is parted before one of them.
constexpr std::array<std::string_view, 62> function_words{
    "a",    "an",   "the",   "and",   "or",    "but",     "so",   "if",    "that", "which", "who",
    "when", "than", "as",    "of",    "to",    "in",      "on",   "at",    "by",   "for",   "with",
    "from", "into", "is",    "are",   "was",   "were",    "be",   "been",  "am",   "it",    "its",
    "he",   "she",  "they",  "his",   "her",   "him",     "them", "their", "i",    "you",   "we",
    "me",   "us",   "my",    "your",  "our",   "do",      "does", "did",   "has",  "have",  "had",
    "will", "can",  "there", "would", "until", "because", "some"};

bool isOneOf(std::span<const std::string_view> list, std::string_view word) {
    return std::ranges::find(list, word) != list.end();
}

/// Parts a run of words, at the widest gap before a function word near its middle, until none is too long.
void part(const Utterance& utterance, std::size_t first, std::size_t end, const PhraseSpeaker& speaker,
          std::vector<SpokenPhrase>& out) {
    const auto& words = utterance.words;
    const double start_s = words[first].start_s, end_s = words[end - 1].end_s;
    constexpr std::size_t fewest_words = 4;
    std::size_t best = 0;
    double best_value = 0.0;
    if (end_s - start_s > speaker.longest_phrase_s && end - first >= fewest_words)
        for (std::size_t w = first + 1; w + 1 < end; ++w) {
            const double place = (words[w].start_s - start_s) / (end_s - start_s);
            double value = 1.0 - std::abs(2.0 * place - 1.0);
            if (isOneOf(function_words, lowerCase(words[w].text)) &&
                !isOneOf(function_words, lowerCase(words[w - 1].text)))
                value += 0.5;
            if (value > best_value) {
                best = w;
                best_value = value;
            }
        }
    if (best == 0) {
        out.push_back({first, end, start_s, end_s});
        return;
    }
    part(utterance, first, best, speaker, out);
    part(utterance, best, end, speaker, out);
}

std::vector<SpokenPhrase> phrasesOf(const Utterance& utterance, const PhraseSpeaker& speaker) {
    std::vector<SpokenPhrase> phrases;
    const auto& words = utterance.words;
    std::size_t first = 0;
    for (std::size_t w = 1; w <= words.size(); ++w)
        if (w == words.size() || words[w].start_s - words[w - 1].end_s >= speaker.pause_s) {
            part(utterance, first, w, speaker, phrases);
            first = w;
        }
    return phrases;
}

/// The strongest accents that are far enough from each other.
std::vector<Anchor> accentAnchors(const Utterance& utterance) {
    std::vector<Anchor> anchors;
    for (std::size_t a = 0; a < utterance.accents.size(); ++a) {
        const Accent& accent = utterance.accents[a];
        const std::string word = lowerCase(utterance.words[static_cast<std::size_t>(accent.word)].text);
        if (!isFiller(word))
            anchors.push_back(
                {accent.start_s, accent.end_s, accent.strength, static_cast<int>(a), accent.word});
    }
    std::ranges::stable_sort(anchors, std::greater{}, &Anchor::strength);
    return anchors;
}

/// Words that bear meaning and have no accent, in a random order.
std::vector<Anchor> otherAnchors(const Utterance& utterance, Random& random) {
    std::vector<bool> accented(utterance.words.size(), false);
    for (const Accent& accent : utterance.accents) accented[static_cast<std::size_t>(accent.word)] = true;
    std::vector<Anchor> anchors;
    for (std::size_t w = 0; w < utterance.words.size(); ++w) {
        const auto& [text, start_s, end_s] = utterance.words[w];
        const std::string word = lowerCase(text);
        if (accented[w] || isFiller(word) || isOneOf(function_words, word)) continue;
        // Most English words bear their stress early.
        constexpr double stressed_share = 0.6;
        anchors.push_back(
            {start_s, start_s + stressed_share * (end_s - start_s), 0.2, -1, static_cast<int>(w)});
    }
    random.shuffle(std::span(anchors));
    return anchors;
}

}  // namespace

bool isFiller(std::string_view small_word) {
    return isOneOf(fillers, small_word);
}

std::vector<SpokenPhrase> plannedPhrases(const Utterance& utterance, const PhraseSpeaker& speaker,
                                         Random& random) {
    std::vector<SpokenPhrase> phrases = phrasesOf(utterance, speaker);
    if (phrases.empty()) return phrases;
    std::vector<Anchor> chosen;
    const auto add = [&](const Anchor& anchor) {
        const bool is_free = std::ranges::none_of(chosen, [&](const Anchor& other) {
            return std::abs(other.middle_s() - anchor.middle_s()) < speaker.min_apex_gap_s;
        });
        if (is_free) chosen.push_back(anchor);
    };
    for (const Anchor& anchor : accentAnchors(utterance)) add(anchor);
    const double asked = speaker.strokes_per_min * utterance.duration_s / 60.0;
    const auto with_accent = static_cast<double>(chosen.size());
    if (with_accent > speaker.share_with_accent * asked)
        chosen.resize(static_cast<std::size_t>(std::lround(speaker.share_with_accent * asked)));
    constexpr double placed = 0.92;  // of strokes; the others follow in gestures that have several
    const double wanted =
        placed * std::min(asked, std::sqrt(asked * with_accent / speaker.share_with_accent));
    for (const Anchor& anchor : otherAnchors(utterance, random)) {
        if (static_cast<double>(chosen.size()) + 0.5 > wanted) break;
        add(anchor);
    }
    std::ranges::sort(chosen, {}, &Anchor::start_s);
    for (const Anchor& anchor : chosen) {
        const auto word = static_cast<std::size_t>(anchor.word);
        const auto phrase =
            std::ranges::find_if(phrases, [&](const SpokenPhrase& p) { return word < p.end_word; });
        phrase->anchors.push_back(anchor);
    }
    return phrases;
}

}  // namespace deixis::motion
