#include "speech/voice/written_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "characters.hpp"
#include "core/text.hpp"

namespace deixis::speech {

namespace {

bool isControl(char32_t c) {
    return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || (c >= 0x7F && c < 0xA0);
}

bool isLetterOrDigit(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Characters of one word, as they come between blanks.
class WordInMaking {
  public:
    void add(std::string_view written, const CharacterUse& use) {
        if (use.kind == CharacterKind::mark && word_.text.empty()) {
            word_.opening += use.ascii;
            return;
        }
        if (use.kind == CharacterKind::mark) {
            marks_written_.append(written);
            word_.closing += use.ascii;
            return;
        }
        // Marks that turn out to stand within the word, as in "don't" and "3.5".
        word_.text.append(marks_written_).append(written);
        word_.spelling.append(word_.closing).append(use.ascii);
        marks_written_.clear();
        word_.closing.clear();
    }

    /// Adds the word, where there is one; what is only punctuation goes to the word before.
    void finish(std::vector<WrittenWord>& words) {
        if (!word_.spelling.empty())
            words.push_back(std::move(word_));
        else if (!words.empty() && !word_.opening.empty())
            words.back().closing +=
                word_.opening.find_first_of(".!?") == std::string::npos ? "," : word_.opening;
        *this = {};
    }

  private:
    WrittenWord word_;
    std::string marks_written_;  ///< word_.closing as it was written
};

}  // namespace

Result<void> checkText(std::string_view text, const std::string& where) {
    if (text.size() > max_text_bytes)
        return fail(
            where,
            fmt::format("found a text of {} bytes, expected {} at the most", text.size(), max_text_bytes),
            "Cut it into several");
    if (const auto bad = firstUnstorable(text))
        return fail(
            where, fmt::format("found a byte at place {} that is no part of UTF-8, expected UTF-8", *bad + 1),
            "Save it as UTF-8");
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t place = at;
        const char32_t character = nextCharacter(text, at);
        if (isControl(character))
            return fail(where, fmt::format("found the control character U+{:04X} at byte {}, expected none",
                                           static_cast<unsigned>(character), place + 1));
    }
    if (trimmed(text).empty()) return fail(where, "found an empty text, expected words");
    return {};
}

Result<std::vector<WrittenWord>> writtenWords(std::string_view text, const std::string& where) {
    text = withoutByteOrderMark(text);
    if (auto checked = checkText(text, where); !checked) return tl::unexpected(checked.error());
    std::vector<WrittenWord> words;
    WordInMaking word;
    int lines_ended = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t place = at;
        const char32_t character = nextCharacter(text, at);
        const std::string_view written = text.substr(place, at - place);
        CharacterUse use = useOf(character);
        if (character == 0x2013 && place > 0 && isDigit(text[place - 1]) && at < text.size() &&
            isDigit(text[at]))
            use = {CharacterKind::word, "-"};  // "5-10" is spoken as "five to ten"
        if (use.kind == CharacterKind::foreign)
            return fail(
                where,
                fmt::format("found \"{}\" of {}, expected English in Latin letters", written, use.script),
                "Take a voice of its language where there is one, or give a recording");
        if (use.kind == CharacterKind::nothing) continue;
        if (use.kind == CharacterKind::blank || use.kind == CharacterKind::dash) {
            word.finish(words);
            if (use.kind == CharacterKind::dash && !words.empty()) words.back().closing += ',';
            if (character == '\n' && ++lines_ended > 1 && !words.empty()) words.back().ends_block = true;
            continue;
        }
        lines_ended = 0;
        word.add(written, use);
    }
    word.finish(words);
    const bool speakable = std::any_of(words.begin(), words.end(), [](const WrittenWord& w) {
        return std::any_of(w.spelling.begin(), w.spelling.end(), isLetterOrDigit);
    });
    if (!speakable) return fail(where, "found nothing that can be spoken, expected words");
    if (words.size() > max_words)
        return fail(where, fmt::format("found {} words, expected {} at the most", words.size(), max_words),
                    "Cut the text into several");
    for (const WrittenWord& w : words)
        if (w.spelling.size() > max_word_characters)
            return fail(where,
                        fmt::format("found a word of {} characters, \"{}...\", expected {} at the most",
                                    w.spelling.size(), w.spelling.substr(0, 20), max_word_characters));
    return words;
}

}  // namespace deixis::speech
