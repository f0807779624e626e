#include "speech/voice/flite_voice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <mutex>

#include "core/text.hpp"
#include "flite_utterance.hpp"

// flite has no headers of its voices.
extern "C" {
cst_voice* register_cmu_us_slt(const char*);
cst_voice* register_cmu_us_rms(const char*);
cst_voice* register_cmu_us_awb(const char*);
cst_voice* register_cmu_us_kal16(const char*);
}

namespace deixis::speech {

namespace {

/// Held while anything of flite is called.
std::mutex& fliteMutex() {
    static std::mutex mutex;
    return mutex;
}

/// The voice of one of fliteVoices(), loaded once. fliteMutex() is held.
cst_voice* voiceOf(std::string_view name) {
    static std::map<std::string, cst_voice*, std::less<>> loaded;
    if (loaded.empty()) flite_init();
    const auto found = loaded.find(name);
    if (found != loaded.end()) return found->second;
    cst_voice* const voice = name == "rms"     ? register_cmu_us_rms(nullptr)
                             : name == "awb"   ? register_cmu_us_awb(nullptr)
                             : name == "kal16" ? register_cmu_us_kal16(nullptr)
                                               : register_cmu_us_slt(nullptr);
    loaded.emplace(name, voice);
    return voice;
}

/// The same numbers of rand() each time, and those that were to come afterwards.
class SameNoise {
  public:
    SameNoise() : before_(initstate(1, state_.data(), state_.size())) {}
    ~SameNoise() { setstate(before_); }
    SameNoise(const SameNoise&) = delete;
    SameNoise& operator=(const SameNoise&) = delete;

  private:
    std::array<char, 128> state_{};
    char* before_;
};

/// Adds what one sentence says behind what there is of the speech.
void addSentence(Speech& speech, std::span<const WrittenWord> written, const cst_utterance* utterance) {
    const double start_s = durationOf(speech.sound);
    const cst_wave* const wave = utt_wave(const_cast<cst_utterance*>(utterance));
    for (int i = 0; i < wave->num_samples; ++i)
        speech.sound.samples.push_back(static_cast<float>(wave->samples[i]) / 32768.0F);
    const double end_s = durationOf(speech.sound);
    const auto at = [&](double time_s) { return std::clamp(start_s + time_s, start_s, end_s); };

    const auto spoken = wordsIn(utterance);
    for (std::size_t i = 0; i < written.size(); ++i) {
        SpokenWord word{written[i].text, end_s, start_s};
        const auto index = static_cast<int>(speech.utterance.words.size());
        const bool weak = isWeakWord(written[i].spelling);
        for (const FliteWord& part : spoken[i])
            for (const FliteSyllable& syllable : part.syllables) {
                const Syllable heard{at(syllable.phones.front().start_s), at(syllable.phones.back().end_s),
                                     index, syllable.stressed, weak};
                if (heard.start_s >= heard.end_s) continue;
                word.start_s = std::min(word.start_s, heard.start_s);
                word.end_s = std::max(word.end_s, heard.end_s);
                speech.syllables.push_back(heard);
            }
        if (word.start_s < word.end_s) speech.utterance.words.push_back(std::move(word));
    }
}

/// In the set of CMU's dictionary.
std::string cmuPhone(const std::string& phone) {
    static const std::map<std::string, std::string> others{{"ax", "AH"}, {"axr", "ER"}, {"dx", "D"},
                                                           {"hv", "HH"}, {"nx", "N"},   {"el", "L"},
                                                           {"em", "M"},  {"en", "N"}};
    const auto found = others.find(phone);
    if (found != others.end()) return found->second;
    std::string out = phone;
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
}

}  // namespace

const std::vector<std::string>& fliteVoices() {
    static const std::vector<std::string> names{"slt", "rms", "awb", "kal16"};
    return names;
}

Result<Speech> speakByFlite(std::string_view text, std::string_view voice, const SpeakOptions& options,
                            const std::string& where) {
    const auto& names = fliteVoices();
    if (std::find(names.begin(), names.end(), voice) == names.end())
        return fail("voice", fmt::format("found \"{}\", expected one of {}", voice, fmt::join(names, ", ")));
    if (!(options.rate >= 0.5 && options.rate <= 2.0))
        return fail("rate", fmt::format("found {}, expected 0.5 to 2", options.rate));
    const auto words = writtenWords(text, where);
    if (!words) return tl::unexpected(words.error());

    const std::lock_guard lock(fliteMutex());
    const SameNoise noise;
    Speech speech;
    const auto starts = sentenceStarts(*words);
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        const std::span sentence(words->begin() + static_cast<std::ptrdiff_t>(starts[i]),
                                 words->begin() + static_cast<std::ptrdiff_t>(starts[i + 1]));
        const FliteUtterance utterance = synthesise(sentence, voiceOf(voice), 1.0 / options.rate, true);
        if (!utterance || utt_wave(utterance.get()) == nullptr)
            return fail(where, fmt::format("flite cannot speak the sentence that begins with \"{}\"",
                                           sentence.front().text));
        speech.sound.rate_hz = utt_wave(utterance.get())->sample_rate;
        addSentence(speech, sentence, utterance.get());
        if (durationOf(speech.sound) > max_sound_s)
            return fail(where, fmt::format("a speech of more than {:.0f} minutes", max_sound_s / 60.0),
                        "Cut the text into several");
    }
    if (speech.utterance.words.empty())
        return fail(where, "found nothing that can be spoken, expected words");
    speech.utterance.duration_s = durationOf(speech.sound);
    return speech;
}

std::vector<std::vector<PronouncedWord>> pronunciationOf(const std::vector<WrittenWord>& words) {
    const std::lock_guard lock(fliteMutex());
    std::vector<std::vector<PronouncedWord>> out;
    const auto starts = sentenceStarts(words);
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        const std::span sentence(words.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                                 words.begin() + static_cast<std::ptrdiff_t>(starts[i + 1]));
        const FliteUtterance utterance = synthesise(sentence, voiceOf("kal16"), 1.0, false);
        if (!utterance) {
            out.resize(starts[i + 1]);
            continue;
        }
        for (const auto& written : wordsIn(utterance.get())) {
            auto& spoken = out.emplace_back();
            for (const FliteWord& word : written) {
                PronouncedWord& pronounced = spoken.emplace_back(PronouncedWord{lowerCase(word.name), {}});
                for (const FliteSyllable& syllable : word.syllables) {
                    auto& added = pronounced.syllables.emplace_back();
                    added.stressed = syllable.stressed;
                    for (const FlitePhone& phone : syllable.phones)
                        added.phones.push_back(cmuPhone(phone.name));
                }
            }
        }
    }
    return out;
}

}  // namespace deixis::speech
