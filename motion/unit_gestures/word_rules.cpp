#include "motion/unit_gestures/word_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/text.hpp"

namespace deixis::motion {

namespace {

template <std::size_t count>
bool isOneOf(const std::array<std::string_view, count>& words, std::string_view word) {
    const std::string small = lowerCase(word);
    return std::find(words.begin(), words.end(), small) != words.end();
}

constexpr std::array<std::string_view, 8> hesitations{"uh", "um", "uhm", "er", "erm", "hm", "hmm", "mm"};

constexpr std::array<std::string_view, 106> plain_words{
    "a",       "an",    "the",   "i",       "me",    "my",      "you",     "your",    "he",       "him",
    "his",     "she",   "her",   "it",      "its",   "we",      "us",      "our",     "they",     "them",
    "their",   "who",   "which", "that",    "this",  "these",   "those",   "what",    "of",       "to",
    "in",      "on",    "at",    "by",      "for",   "with",    "from",    "as",      "and",      "or",
    "but",     "if",    "so",    "than",    "then",  "because", "is",      "are",     "was",      "were",
    "be",      "been",  "being", "am",      "do",    "does",    "did",     "have",    "has",      "had",
    "will",    "would", "can",   "could",   "may",   "might",   "shall",   "should",  "must",     "not",
    "there's", "it's",  "i'm",   "don't",   "think", "thinks",  "thought", "believe", "believes", "know",
    "knows",   "knew",  "guess", "suppose", "mean",  "means",   "want",    "wants",   "feel",     "feels",
    "felt",    "hope",  "hopes", "wish",    "like",  "likes",   "just",    "very",    "too",      "also",
    "some",    "any",   "no",    "when",    "where", "how"};

}  // namespace

const WordRules& usualWordRules() {
    static const WordRules rules{
        {{"right"}, {"point_right", "~point_left"}, true},
        {{"left"}, {"~point_right", "point_left"}, true},
        {{"up", "above", "sky", "top", "ceiling", "upstairs"}, {"point_up", "rising"}},
        {{"here", "now", "today"}, {"point_down", "beat_both"}},
        {{"there", "far", "away", "distan*", "horizon"}, {"point_far"}},
        {{"yourself", "yours", "audience"}, {"point_front", "offer"}},
        {{"mine", "myself", "ourselves"}, {"point_self"}},
        {{"past", "ago", "yesterday", "before", "behind", "history", "last"}, {"over_shoulder"}},
        {{"future", "tomorrow", "later", "next", "soon", "forward"}, {"future", "progress"}},
        {{"big*", "large*", "huge", "enormous", "great*", "giant", "vast"}, {"big"}},
        {{"small*", "little", "tiny", "short", "detail*"}, {"small", "beat_precision"}},
        {{"round", "ball*", "circle*", "globe", "earth", "sphere", "moon", "sun"}, {"round"}},
        {{"box", "boxes", "frame*", "picture*", "window*", "screen*", "square"}, {"frame"}},
        {{"bowl", "cup", "bag", "inside", "contain*", "hold*", "full"}, {"container"}},
        {{"ris*", "grow*", "grew", "increas*", "better", "higher", "climb*", "improv*"}, {"rising"}},
        {{"fall*", "fell", "drop*", "decreas*", "lower", "down", "less", "worse", "sink*"}, {"falling"}},
        {{"typ*", "computer*", "keyboard", "program*", "writ*", "wrote", "email*"}, {"typing"}},
        {{"read*", "book*", "page*", "text*", "report*", "paper*", "letter*"}, {"reading"}},
        {{"throw*", "threw", "discard*"}, {"throwing"}},
        {{"flat", "table*", "field*", "country", "land", "floor", "surface*", "wide"}, {"surface"}},
        {{"tall", "high", "tower*", "tree*", "mountain*", "building*"}, {"tall"}},
        {{"go", "went", "going", "travel*", "move*", "journey", "road*", "way", "cross*"}, {"travel"}},
        {{"turn*", "wheel*", "machine*", "process*", "cycle*", "roll*"}, {"turning", "continue"}},
        {{"idea*", "example*", "question*", "story", "give*", "gave", "offer*"}, {"offer", "present"}},
        {{"show*", "present*", "result*", "result", "introduc*"}, {"present"}},
        {{"maybe", "perhaps", "choose", "choice*", "either", "whether", "balanc*", "compar*"}, {"weighing"}},
        {{"step*", "progress*", "plan*", "continu*", "develop*"}, {"progress", "continue"}},
        {{"etcetera", "onward*", "keep*", "again"}, {"continue"}},
        {{"all", "everybody", "everyone", "everything", "whole", "world", "together"},
         {"embrace", "together"}},
        {{"several", "many", "list*", "various"}, {"listing"}},
        {{"first", "second", "third", "one", "two", "three", "four", "count*", "number*"},
         {"counting", "listing"}},
        {{"differ*", "separat*", "apart", "between", "divid*", "gap*"}, {"apart"}},
        {{"join*", "connect*", "combin*", "meet*", "friend*", "union"}, {"together"}},
        {{"must", "exactly", "precise*", "important", "really"}, {"beat_precision", "beat_chop"}},
        {{"strong*", "fight*", "power*", "win*"}, {"beat_fist"}},
        {{"hurray", "hooray", "won"}, {"raise_both"}},
        {{"hello", "hi", "bye", "goodbye"}, {"wave"}},
        {{"stop*", "wait*", "refus*", "against"}, {"refuse", "stop_both"}},
        {{"dunno", "unknown", "unclear", "unsure", "somehow", "whatever"}, {"shrug"}},
        {{"never", "end*", "over", "nothing", "finish*", "none"}, {"cut_off"}},
        {{"wonder*", "consider*"}, {"thinking"}},
        {{"thank*", "please"}, {"bow", "hand_on_heart"}},
        {{"yes", "agree*", "sure"}, {"nod"}},
        {{"no"}, {"shake_head"}},
        {{"welcome", "open*", "free*"}, {"open_arms"}},
        {{"slow*", "calm*", "quiet*", "gentl*"}, {"calm"}},
        {{"come*", "invit*"}, {"beckon"}},
        {{"bravo", "congratulat*", "applau*"}, {"clap"}},
        {{"love*", "heart", "sorry", "honest*", "promis*"}, {"hand_on_heart"}},
    };
    return rules;
}

const WordRule* ruleFor(const WordRules& rules, std::string_view word) {
    const std::string small = lowerCase(word);
    const WordRule* by_beginning = nullptr;
    for (const WordRule& rule : rules)
        for (const std::string& known : rule.words) {
            if (known == small) return &rule;
            if (by_beginning == nullptr && known.size() > 1 && known.back() == '*' &&
                small.starts_with(std::string_view(known).substr(0, known.size() - 1)))
                by_beginning = &rule;
        }
    return by_beginning;
}

Result<void> checkWordRules(const WordRules& rules, const GestureLibrary& library) {
    for (std::size_t r = 0; r < rules.size(); ++r) {
        if (rules[r].words.empty() || rules[r].gestures.empty())
            return fail(fmt::format("rule {}", r), "found no words or no gestures, expected some of both");
        for (const std::string& id : rules[r].gestures)
            if (findGesture(library, id.starts_with('~') ? id.substr(1) : id) == nullptr)
                return fail(fmt::format("rule {} ({})", r, rules[r].words.front()),
                            fmt::format("found the gesture '{}', expected one of the library", id));
    }
    return {};
}

UnitGesture gestureOfRule(const GestureLibrary& library, std::string_view id) {
    if (id.starts_with('~')) return mirrored(*findGesture(library, id.substr(1)));
    return *findGesture(library, id);
}

bool isPlainWord(std::string_view word) {
    return isOneOf(plain_words, word) || isHesitation(word);
}

bool isHesitation(std::string_view word) {
    return isOneOf(hesitations, word);
}

}  // namespace deixis::motion
