#include "kept_speeches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/hash.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::server {

namespace {

/// What a speech is told apart by: half a hash is enough.
constexpr std::size_t id_letters = 32;

std::string wordsText(const Utterance& utterance) {
    std::string out;
    for (const SpokenWord& word : utterance.words)
        out += fmt::format("{} {} {}\n", word.start_s, word.end_s, word.text);
    return out;
}

}  // namespace

std::size_t KeptSpeech::bytes() const {
    return wav.size() + spoken.sound.samples.size() * sizeof(float) +
           (spoken.pitch.size() + spoken.loudness.size()) * sizeof(double) +
           spoken.utterance.words.size() * sizeof(SpokenWord) +
           spoken.utterance.accents.size() * sizeof(Accent);
}

std::shared_ptr<const KeptSpeech> keptSpeech(speech::SpokenText spoken, std::string asked,
                                             std::string language) {
    auto out = std::make_shared<KeptSpeech>();
    out->wav = speech::wavBytes(spoken.sound);
    out->id = sha256Hex(wordsText(spoken.utterance) + out->wav).substr(0, id_letters);
    out->asked = std::move(asked);
    out->language = std::move(language);
    out->spoken = std::move(spoken);
    return out;
}

void KeptSpeeches::keep(std::shared_ptr<const KeptSpeech> speech) {
    const std::lock_guard lock(mutex_);
    newest_first_.remove_if([&](const auto& one) { return one->id == speech->id; });
    newest_first_.push_front(std::move(speech));
    std::size_t bytes = 0;
    const auto first_too_many =
        std::find_if(newest_first_.begin(), newest_first_.end(), [&](const auto& one) {
            bytes += one->bytes();
            return bytes > most_bytes_ && one != newest_first_.front();
        });
    newest_first_.erase(first_too_many, newest_first_.end());
}

template <class Is>
std::shared_ptr<const KeptSpeech> KeptSpeeches::findWhere(Is is) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(newest_first_.begin(), newest_first_.end(), is);
    if (found == newest_first_.end()) return nullptr;
    newest_first_.splice(newest_first_.begin(), newest_first_, found);
    return newest_first_.front();
}

std::shared_ptr<const KeptSpeech> KeptSpeeches::find(const std::string& id) {
    return findWhere([&](const auto& one) { return one->id == id; });
}

std::shared_ptr<const KeptSpeech> KeptSpeeches::findAsked(const std::string& asked) {
    return findWhere([&](const auto& one) { return one->asked == asked; });
}

}  // namespace deixis::server
