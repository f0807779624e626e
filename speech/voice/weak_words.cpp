#include <algorithm>
#include <iterator>

#include "core/text.hpp"
#include "speech/voice/speech.hpp"

namespace deixis::speech {

bool isWeakWord(std::string_view word) {
    constexpr std::string_view words[]{
        "a",    "am",     "an",   "and",   "are",   "as",   "at",   "be",   "been", "but",  "by",
        "can",  "could",  "did",  "do",    "does",  "for",  "from", "had",  "has",  "have", "he",
        "her",  "him",    "his",  "i",     "i'm",   "if",   "in",   "into", "is",   "it",   "it's",
        "its",  "may",    "me",   "might", "must",  "my",   "of",   "on",   "or",   "our",  "shall",
        "she",  "should", "than", "the",   "their", "them", "they", "to",   "us",   "was",  "we",
        "were", "will",   "with", "would", "you",   "your"};
    return std::binary_search(std::begin(words), std::end(words), lowerCase(word));
}

}  // namespace deixis::speech
