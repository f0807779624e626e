#include "flite_utterance.hpp"

#include <csetjmp>

namespace deixis::speech {

namespace {

constexpr std::size_t longest_sentence = 100;

bool isCapital(char c) {
    return c >= 'A' && c <= 'Z';
}

bool sentenceEnds(const WrittenWord& word, const WrittenWord& next) {
    if (word.ends_block || word.closing.find_first_of("!?:;") != std::string::npos) return true;
    if (word.closing.find('.') == std::string::npos || !isCapital(next.spelling.front())) return false;
    // A capital may follow an abbreviation, too: "Dr. Smith", "J. S. Bach", "the U.S. Army".
    const bool initials = isCapital(word.spelling.back());
    const bool short_title = isCapital(word.spelling.front()) && word.spelling.size() < 4;
    return !initials && !short_title;
}

cst_utterance* withoutSound(cst_utterance* utterance) {
    return utterance;
}

/// flite leaves the program where it meets what it does not expect, unless it is given a place to jump to.
/// Nothing here and below has a destructor that the jump would pass over. What was allocated until then is
/// lost.
cst_utterance* synthesiseGuarded(cst_utterance* utterance) {
    std::jmp_buf back;
    cst_utterance* volatile out = nullptr;
    if (setjmp(back) == 0) {
        cst_errjmp = &back;
        out = utt_synth_tokens(utterance);
    }
    cst_errjmp = nullptr;
    return out;
}

}  // namespace

std::vector<std::size_t> sentenceStarts(const std::vector<WrittenWord>& words) {
    std::vector<std::size_t> out{0};
    for (std::size_t i = 1; i < words.size(); ++i)
        if (sentenceEnds(words[i - 1], words[i]) || i - out.back() >= longest_sentence) out.push_back(i);
    out.push_back(words.size());
    return out;
}

FliteUtterance synthesise(std::span<const WrittenWord> words, cst_voice* voice, double stretch, bool sound) {
    FliteUtterance out(new_utterance());
    utt_init(out.get(), voice);
    feat_set_float(out->features, "duration_stretch", static_cast<float>(stretch));
    if (!sound) feat_set(out->features, "wave_synth_func", uttfunc_val(&withoutSound));
    cst_relation* const tokens = utt_relation_create(out.get(), "Token");
    for (const WrittenWord& word : words) {
        cst_item* const token = relation_append(tokens, nullptr);
        item_set_string(token, "name", word.spelling.c_str());
        item_set_string(token, "whitespace", " ");
        item_set_string(token, "prepunctuation", word.opening.c_str());
        item_set_string(token, "punc", word.closing.c_str());
    }
    if (synthesiseGuarded(out.get()) == nullptr) return nullptr;
    return out;
}

std::vector<std::vector<FliteWord>> wordsIn(const cst_utterance* utterance) {
    std::vector<std::vector<FliteWord>> out;
    const cst_item* token = relation_head(utt_relation(utterance, "Token"));
    for (; token != nullptr; token = item_next(token)) {
        auto& words = out.emplace_back();
        for (const cst_item* word = item_daughter(token); word != nullptr; word = item_next(word)) {
            FliteWord& of_word = words.emplace_back(FliteWord{item_name(word), {}});
            const cst_item* syllable = item_daughter(item_as(word, "SylStructure"));
            for (; syllable != nullptr; syllable = item_next(syllable)) {
                FliteSyllable& of_syllable = of_word.syllables.emplace_back();
                of_syllable.stressed = std::string(item_feat_string(syllable, "stress")) == "1";
                for (const cst_item* phone = item_daughter(syllable); phone != nullptr;
                     phone = item_next(phone)) {
                    const cst_item* const segment = item_as(phone, "Segment");
                    const cst_item* const before = item_prev(segment);
                    of_syllable.phones.push_back(
                        {item_name(segment),
                         before == nullptr ? 0.0 : static_cast<double>(item_feat_float(before, "end")),
                         static_cast<double>(item_feat_float(segment, "end"))});
                }
                if (of_syllable.phones.empty()) of_word.syllables.pop_back();
            }
            if (of_word.syllables.empty()) words.pop_back();
        }
    }
    return out;
}

}  // namespace deixis::speech
