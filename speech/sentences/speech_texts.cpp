#include "speech/sentences/speech_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "core/random.hpp"
#include "core/text.hpp"

namespace deixis::speech {

namespace {

bool isVowel(char c) {
    return std::string_view("aeiouy").find(c) != std::string_view::npos;
}

bool endsSentence(char c) {
    return c == '.' || c == '?' || c == '!';
}

/// Whether a word, in small letters, begins with the sound of a vowel.
bool soundsLikeVowel(std::string_view word) {
    for (const std::string_view silent : {"hour", "honest", "heir"})
        if (word.starts_with(silent)) return true;
    for (const std::string_view glide : {"uni", "use", "usu", "eu", "one", "once"})
        if (word.starts_with(glide)) return false;
    return !word.empty() && word.front() != 'y' && isVowel(word.front());
}

/// One blank between words and none before marks, "an" before vowels, capital letters after ends.
std::string tidied(std::string_view raw) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < raw.size();) {
        const std::size_t end = std::min(raw.find(' ', at), raw.size());
        std::string word(raw.substr(at, end - at));
        at = end + 1;
        if (word.empty()) continue;
        const bool is_mark = word.front() == ',' || endsSentence(word.front());
        if (is_mark && !words.empty())
            words.back() += word;
        else
            words.push_back(std::move(word));
    }
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if ((words[i] == "a" || words[i] == "A") && i + 1 < words.size() &&
            soundsLikeVowel(lowerCase(words[i + 1])))
            words[i] += 'n';
        if (!out.empty()) out += ' ';
        const bool starts = out.empty() || endsSentence(out[out.size() - 2]);
        out += starts ? capitalised(words[i]) : words[i];
    }
    return out;
}

/// What a speech remembers while it is made.
struct SpeechMemory {
    std::map<std::pair<int, int>, std::size_t> bound;  ///< alternative by rule and label
    std::map<int, std::set<std::size_t>>
        used;  ///< alternatives by rule: none comes twice where others are left
};

class SpeechMaker {
  public:
    SpeechMaker(const SentenceGrammar& grammar, const SpeechLengths& lengths)
        : grammar_(grammar), lengths_(lengths) {}

    /// None where the theme has no sentences of that part, or not such a length, this time.
    std::optional<std::string> make(const GrammarTheme& theme, CorpusPart part, Random& random) const {
        const double wanted_s = random.uniform(lengths_.min_s, lengths_.max_s);
        constexpr double chance_of_maybe = 0.6;
        SpeechMemory memory;
        std::string text;
        const auto say = [&](int rule) {
            const auto sentence = draw(rule, part, memory, random);
            if (sentence) text += (text.empty() ? "" : " ") + *sentence;
            return sentence.has_value();
        };
        for (const GrammarStage& stage : theme.stages) {
            if (stage.times == GrammarStage::Times::maybe && random.uniform() >= chance_of_maybe) continue;
            if (!say(stage.rule)) {
                if (stage.times == GrammarStage::Times::maybe) continue;
                return {};
            }
            if (stage.times == GrammarStage::Times::many)
                while (spokenSeconds(text) < wanted_s && say(stage.rule)) {
                }
        }
        const double seconds = spokenSeconds(text);
        if (seconds < lengths_.min_s || seconds > lengths_.max_s) return {};
        return text;
    }

  private:
    /// A line of the rule whose sentences all belong to the part.
    std::optional<std::string> draw(int rule, CorpusPart part, SpeechMemory& memory, Random& random) const {
        constexpr int tries = 60;
        for (int i = 0; i < tries; ++i) {
            SpeechMemory next = memory;
            std::string raw;
            expand({"", rule}, next, random, raw);
            std::string text = tidied(raw);
            const auto sentences = sentencesOf(text);
            if (!std::ranges::all_of(sentences, [&](const auto& one) { return partOfSentence(one) == part; }))
                continue;
            memory = std::move(next);
            return text;
        }
        return {};
    }

    void expand(const GrammarPiece& piece, SpeechMemory& memory, Random& random, std::string& out) const {
        if (piece.rule < 0) {
            out += piece.words;
            return;
        }
        const std::size_t alternative = choose(piece, memory, random);
        const auto& forms = grammar_.rules[static_cast<std::size_t>(piece.rule)].alternatives[alternative];
        for (const GrammarPiece& part : forms[piece.form]) expand(part, memory, random, out);
    }

    std::size_t choose(const GrammarPiece& piece, SpeechMemory& memory, Random& random) const {
        const std::pair key{piece.rule, piece.label};
        if (piece.label > 0)
            if (const auto bound = memory.bound.find(key); bound != memory.bound.end()) return bound->second;
        const std::size_t count = grammar_.rules[static_cast<std::size_t>(piece.rule)].alternatives.size();
        std::set<std::size_t>& used = memory.used[piece.rule];
        if (used.size() == count) used.clear();
        std::size_t place = random.below(count - used.size());
        for (const std::size_t taken : used)  // in order
            if (taken <= place) ++place;
        used.insert(place);
        if (piece.label > 0) memory.bound[key] = place;
        return place;
    }

    const SentenceGrammar& grammar_;
    SpeechLengths lengths_;
};

}  // namespace

std::string_view corpusPartName(CorpusPart part) {
    constexpr std::array<std::string_view, 3> names{"training", "validation", "test"};
    return names[static_cast<std::size_t>(part)];
}

double spokenSeconds(std::string_view text) {
    constexpr double per_syllable_s = 0.19, per_comma_s = 0.2, per_end_s = 0.45;
    double seconds = 0.0;
    bool in_vowels = false, letters = false;
    std::size_t syllables = 0, in_word = 0;
    const auto endWord = [&](char last, char before) {
        // A silent e: "wide", "these"; but "the", "table".
        if (in_word > 1 && last == 'e' && !isVowel(before) && before != 'l') --syllables;
        in_word = 0;
        in_vowels = letters = false;
    };
    const std::string small = lowerCase(text) + ' ';
    for (std::size_t i = 0; i < small.size(); ++i) {
        const char c = small[i];
        if (c >= 'a' && c <= 'z') {
            letters = true;
            if (isVowel(c) && !in_vowels) ++syllables, ++in_word;
            in_vowels = isVowel(c);
        } else if (letters) {
            endWord(small[i - 1], i > 1 ? small[i - 2] : ' ');
        }
        if (c == ',') seconds += per_comma_s;
        if (endsSentence(c)) seconds += per_end_s;
    }
    return seconds + per_syllable_s * static_cast<double>(syllables);
}

std::vector<std::string> sentencesOf(std::string_view text) {
    std::vector<std::string> sentences;
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (i + 1 == text.size() || (endsSentence(text[i]) && text[i + 1] == ' ')) {
            if (const auto sentence = trimmed(text.substr(start, i + 1 - start)); !sentence.empty())
                sentences.emplace_back(sentence);
            start = i + 1;
        }
    return sentences;
}

CorpusPart partOfSentence(std::string_view sentence) {
    switch (deriveSeed(0, sentence) % 10) {
        case 8:
            return CorpusPart::validation;
        case 9:
            return CorpusPart::test;
        default:
            return CorpusPart::training;
    }
}

Result<std::vector<SpeechText>> drawSpeechTexts(const SentenceGrammar& grammar, std::uint64_t seed,
                                                std::size_t count, const SpeechLengths& lengths) {
    constexpr int tries = 400;
    const SpeechMaker maker(grammar, lengths);
    std::vector<SpeechText> speeches;
    std::set<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, fmt::format("speech {}", i));
        const std::size_t place = i % 10;
        const CorpusPart part = place < 8    ? CorpusPart::training
                                : place == 8 ? CorpusPart::validation
                                             : CorpusPart::test;
        bool made = false;
        for (int t = 0; t < tries && !made; ++t) {
            const GrammarTheme& theme = grammar.themes[random.below(grammar.themes.size())];
            const auto text = maker.make(theme, part, random);
            made = text && texts.insert(*text).second;
            if (made) speeches.push_back({theme.name, *text, part});
        }
        if (!made)
            return fail("",
                        fmt::format("found {} different speeches of {:.0f} to {:.0f} s, expected {}",
                                    speeches.size(), lengths.min_s, lengths.max_s, count),
                        "The grammar needs more rules or alternatives");
    }
    return speeches;
}

}  // namespace deixis::speech
