// deixis-espeak: speech of many languages by eSpeak NG, for deixis serve and deixis studio.
//
//   deixis-espeak --list                  a line "LANGUAGE NAME" for each language, in order
//   deixis-espeak --language LANGUAGE     reads a text (UTF-8) from standard input until that ends; writes a
//   line
//                                         "START END WORD" for each word, in seconds, an empty line, and a
//                                         WAV file
//
// This program is a work of its own under the GNU General Public License, version 3 or later, since it is
// linked with eSpeak NG, which is (LICENCE.md). Deixis is not: it starts this program and talks to it by
// pipes.
#include <espeak-ng/speak_lib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

constexpr std::size_t longest_text = 200'000;
constexpr std::size_t longest_speech_s = 30 * 60;
constexpr double milliseconds = 1e-3;

struct Word {
    double start_s = 0.0, end_s = 0.0;
    std::size_t first = 0, count = 0;  ///< characters of the text
};

struct Speech {
    std::vector<std::int16_t> samples;
    std::vector<Word> words;
    std::size_t most_samples = 0;
    bool too_long = false;
};

int refuse(const std::string& why) {
    std::fprintf(stderr, "deixis-espeak: %s\n", why.c_str());
    return 1;
}

/// A word lasts to the next one, or to the end of its clause.
void endLastWord(Speech& speech, double at_s) {
    if (!speech.words.empty() && speech.words.back().end_s == 0.0)
        speech.words.back().end_s = std::max(at_s, speech.words.back().start_s);
}

/// A written word that is spoken as several, such as 250, is told part by part.
void beginWord(Speech& speech, const Word& word) {
    if (!speech.words.empty() && word.first < speech.words.back().first + speech.words.back().count)
        speech.words.back().end_s = 0.0;
    else
        speech.words.push_back(word);
}

int take(short* samples, int count, espeak_EVENT* events) {
    auto& speech = *static_cast<Speech*>(events->user_data);
    if (samples != nullptr && count > 0)
        speech.samples.insert(speech.samples.end(), samples, samples + count);
    for (; events->type != espeakEVENT_LIST_TERMINATED; ++events) {
        const double at_s = milliseconds * events->audio_position;
        if (events->type != espeakEVENT_WORD && events->type != espeakEVENT_END &&
            events->type != espeakEVENT_SENTENCE)
            continue;
        endLastWord(speech, at_s);
        if (events->type == espeakEVENT_WORD && events->text_position > 0)
            beginWord(speech, {at_s, 0.0, static_cast<std::size_t>(events->text_position - 1),
                               static_cast<std::size_t>(std::max(events->length, 0))});
    }
    speech.too_long = speech.samples.size() > speech.most_samples;
    return speech.too_long ? 1 : 0;
}

std::string allOfInput() {
    std::string text;
    std::array<char, 65536> some{};
    for (std::size_t count = 0; (count = std::fread(some.data(), 1, some.size(), stdin)) > 0;) {
        text.append(some.data(), count);
        if (text.size() > longest_text) break;
    }
    return text;
}

/// Where each character begins, and the end.
std::vector<std::size_t> characterPlaces(const std::string& text) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) out.push_back(i);
    out.push_back(text.size());
    return out;
}

constexpr std::array<const char*, 34> marks{
    " ",      ".",      ",",      ";",      ":",      "!",      "?",      "\"",     "'",
    "(",      ")",      "[",      "]",      "-",      "\u2013", "\u2014", "\u2026", "\u00AB",
    "\u00BB", "\u201E", "\u201C", "\u201D", "\u2018", "\u2019", "\u00BF", "\u00A1", "\u3002",
    "\u3001", "\uFF0C", "\uFF01", "\uFF1F", "\uFF1B", "\u060C", "\u061F"};

void removeMarksAround(std::string& text) {
    for (bool removed = true; removed;) {
        removed = false;
        for (const std::string mark : marks) {
            if (text.starts_with(mark)) removed = true, text.erase(0, mark.size());
            if (text.ends_with(mark)) removed = true, text.erase(text.size() - mark.size());
        }
    }
}

/// As it was written, without marks around it. eSpeak tells where a word begins; of "l'homme" the first part
/// only.
std::string wordAt(const std::string& text, const std::vector<std::size_t>& places, const Word& word,
                   std::size_t next) {
    const std::size_t last = places.size() - 1;
    const std::size_t from = places[std::min(word.first, last)];
    const std::size_t end = places[std::min(std::max(next, word.first), last)];
    const std::size_t blank =
        std::min(text.find_first_of(" \t\r\n", places[std::min(word.first + word.count, last)]), end);
    std::string out = text.substr(from, std::max(blank, from) - from);
    std::replace_if(
        out.begin(), out.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; }, ' ');
    removeMarksAround(out);
    return out;
}

void appendNumber(std::string& to, std::uint32_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) to += static_cast<char>((number >> (8 * i)) & 0xFFU);
}

/// One channel of 16 bits.
std::string wavHead(std::uint32_t rate, std::size_t samples) {
    const auto bytes = static_cast<std::uint32_t>(2 * samples);
    std::string out = "RIFF";
    appendNumber(out, 36 + bytes, 4);
    out += "WAVEfmt ";
    appendNumber(out, 16, 4);
    appendNumber(out, 1, 2);
    appendNumber(out, 1, 2);
    appendNumber(out, rate, 4);
    appendNumber(out, 2 * rate, 4);
    appendNumber(out, 2, 2);
    appendNumber(out, 16, 2);
    out += "data";
    appendNumber(out, bytes, 4);
    return out;
}

std::string asBytes(const std::vector<std::int16_t>& samples) {
    std::string out;
    out.reserve(2 * samples.size());
    for (const std::int16_t sample : samples) appendNumber(out, static_cast<std::uint16_t>(sample), 2);
    return out;
}

bool put(const std::string& bytes) {
    return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
}

int list() {
    std::map<std::string, std::string> names;
    const espeak_VOICE** voices = espeak_ListVoices(nullptr);
    for (; *voices != nullptr; ++voices) {
        // A byte of priority stands before each of a voice's languages; the first is its own.
        const std::string language = (*voices)->languages + 1;
        if (!language.empty()) names.emplace(language, (*voices)->name);
    }
    for (const auto& [language, name] : names) std::printf("%s %s\n", language.c_str(), name.c_str());
    return std::fflush(stdout) == 0 ? 0 : 1;
}

int speak(const std::string& language, int rate) {
    if (espeak_SetVoiceByName(language.c_str()) != EE_OK)
        return refuse("there is no voice of the language '" + language + "'");
    const std::string text = allOfInput();
    if (text.size() > longest_text)
        return refuse("the text is longer than " + std::to_string(longest_text) + " bytes");
    Speech speech;
    speech.most_samples = longest_speech_s * static_cast<std::size_t>(rate);
    espeak_SetSynthCallback(take);
    if (espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0, espeakCHARS_UTF8, nullptr,
                     &speech) != EE_OK)
        return refuse("eSpeak NG could not speak the text");
    espeak_Synchronize();
    if (speech.too_long) return refuse("the speech is longer than half an hour");
    if (speech.samples.empty() || speech.words.empty())
        return refuse("there is nothing in the text that can be spoken");
    endLastWord(speech, static_cast<double>(speech.samples.size()) / rate);
    const auto places = characterPlaces(text);
    for (std::size_t i = 0; i < speech.words.size(); ++i) {
        const Word& word = speech.words[i];
        const bool last = i + 1 == speech.words.size();
        const std::string written =
            wordAt(text, places, word, last ? places.size() : speech.words[i + 1].first);
        std::array<char, 64> times{};
        std::snprintf(times.data(), times.size(), "%.3f %.3f ", word.start_s, word.end_s);
        if (!written.empty() && !put(times.data() + written + "\n")) return 1;
    }
    const bool written = put("\n" + wavHead(static_cast<std::uint32_t>(rate), speech.samples.size()) +
                             asBytes(speech.samples));
    return written && std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const bool lists = arguments.size() == 1 && arguments[0] == "--list";
    const bool speaks = arguments.size() == 2 && arguments[0] == "--language";
    if (!lists && !speaks) {
        refuse("expected --list or --language LANGUAGE");
        return 2;
    }
    const int rate = espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_DONT_EXIT);
    if (rate <= 0) return refuse("eSpeak NG cannot start: is espeak-ng-data installed?");
    return lists ? list() : speak(arguments[1], rate);
}
