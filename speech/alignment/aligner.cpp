#include "speech/alignment/aligner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "fitting.hpp"
#include "speech/voice/flite_voice.hpp"
#include "sphinx.hpp"
#include "text_search.hpp"

namespace deixis::speech {

namespace {

/// Three frames a phone: the model has three states for each.
constexpr double shortest_phone_s = 0.03;

constexpr const char* check_hint = "Check that the text is what is said, word by word";

/// One spoken word of the text and what it is called in grammars.
struct TextWord {
    std::size_t written = 0;  ///< index of the written word
    std::vector<PronouncedSyllable> syllables;
    std::string name;
};

std::vector<std::int16_t> samplesOf(const Sound& sound) {
    const Sound at_rate = resampled(sound, sphinx_rate_hz);
    std::vector<std::int16_t> out;
    out.reserve(at_rate.samples.size());
    for (const float sample : at_rate.samples)
        out.push_back(static_cast<std::int16_t>(std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767.0F)));
    return out;
}

std::vector<std::string> phonesOf(const std::vector<PronouncedSyllable>& syllables) {
    std::vector<std::string> out;
    for (const auto& syllable : syllables)
        out.insert(out.end(), syllable.phones.begin(), syllable.phones.end());
    return out;
}

double secondsAt(int frame) {
    return static_cast<double>(frame) / sphinx_frames_per_s;
}

/// All phones of the text by the sound's frames; before 0 where a piece's phones are not found.
std::vector<FoundWord> phonesIn(Sphinx& sphinx, const std::vector<Piece>& pieces,
                                const std::vector<TextWord>& words,
                                const std::vector<std::int16_t>& samples) {
    std::vector<FoundWord> out;
    for (const Piece& piece : pieces) {
        std::string grammar;
        std::size_t count = 0;
        for (std::size_t i = piece.first_word; i < piece.end_word; ++i)
            for (const std::string& phone : phonesOf(words[i].syllables)) {
                grammar += " " + phoneWord(phone);
                ++count;
            }
        if (count == 0) continue;
        auto found = sphinx.find(grammar, samplesIn(piece, samples));
        for (FoundWord& phone : found) {
            phone.first += piece.first_frame;
            phone.last += piece.first_frame;
        }
        if (found.size() != count) found.assign(count, FoundWord{"", -1, -1, 0.0});
        out.insert(out.end(), found.begin(), found.end());
    }
    return out;
}

/// The words and syllables at the times where they were found.
Alignment alignmentOf(const std::vector<WrittenWord>& written, const std::vector<TextWord>& words,
                      const std::vector<FoundWord>& found, const std::vector<FoundWord>& phones,
                      double duration_s) {
    Alignment out;
    std::size_t phone = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const double start_s = std::min(secondsAt(found[i].first), duration_s);
        const double end_s = std::min(secondsAt(found[i].last + 1), duration_s);
        const std::string& text = written[words[i].written].text;
        if (i > 0 && words[i].written == words[i - 1].written)
            out.words.back().end_s = end_s;
        else
            out.words.push_back({text, start_s, end_s});
        const auto index = static_cast<int>(out.words.size()) - 1;
        std::vector<std::size_t> lengths;
        for (const auto& syllable : words[i].syllables) lengths.push_back(syllable.phones.size());
        const auto bounds =
            syllableBounds(start_s, end_s, lengths, phones[phone].first < 0 ? nullptr : &phones[phone]);
        for (std::size_t s = 0; s < lengths.size(); ++s) {
            out.syllables.push_back(
                {bounds[s], bounds[s + 1], index, words[i].syllables[s].stressed, isWeakWord(text)});
            phone += lengths[s];
        }
    }
    return out;
}

}  // namespace

struct Aligner::State {
    Sphinx sphinx;
    std::map<std::string, std::string> names{};  ///< of words in grammars, by their pronunciations
    std::mutex mutex{};

    /// The spoken words of the text, which grammars may use from then on.
    [[nodiscard]] Result<std::vector<TextWord>> wordsOf(const std::vector<WrittenWord>& written,
                                                        const std::string& where) {
        const auto pronounced = pronunciationOf(written);
        std::vector<TextWord> out;
        for (std::size_t i = 0; i < pronounced.size(); ++i)
            for (const PronouncedWord& word : pronounced[i]) {
                auto pronunciations = sphinx.pronunciationsOf(word.text);
                const std::string by_flite = fmt::format("{}", fmt::join(phonesOf(word.syllables), " "));
                if (std::find(pronunciations.begin(), pronunciations.end(), by_flite) == pronunciations.end())
                    pronunciations.push_back(by_flite);
                auto& name = names[fmt::format("{}", fmt::join(pronunciations, "/"))];
                if (name.empty()) name = fmt::format("word_{}", names.size());
                if (!sphinx.addWord(name, pronunciations))
                    return fail(where,
                                fmt::format("the word \"{}\" has sounds that PocketSphinx does not know: {}",
                                            written[i].text, by_flite));
                out.push_back({i, word.syllables, name});
            }
        if (out.empty()) return fail(where, "found nothing that can be spoken, expected words");
        return out;
    }
};

Aligner::Aligner(std::unique_ptr<State> state) : state_(std::move(state)) {}
Aligner::Aligner(Aligner&&) noexcept = default;
Aligner& Aligner::operator=(Aligner&&) noexcept = default;
Aligner::~Aligner() = default;

std::filesystem::path Aligner::usualModel() {
    return "/usr/share/pocketsphinx/model/en-us";
}

Result<Aligner> Aligner::load(const std::filesystem::path& model) {
    auto sphinx = Sphinx::load(model);
    if (!sphinx) return tl::unexpected(sphinx.error());
    for (const std::string& phone : cmuPhones())
        if (!sphinx->addWord(phoneWord(phone), {phone}))
            return fail(model.string(), fmt::format("the model has no phone {}, expected CMU's set", phone));
    return Aligner(std::unique_ptr<State>(new State{std::move(*sphinx)}));
}

Result<Alignment> Aligner::align(const Sound& sound, std::string_view text, const std::string& where) {
    const auto written = writtenWords(text, where);
    if (!written) return tl::unexpected(written.error());
    const std::lock_guard lock(state_->mutex);
    const auto words = state_->wordsOf(*written, where);
    if (!words) return tl::unexpected(words.error());

    const double duration_s = durationOf(sound);
    std::vector<std::string> names;
    std::size_t phone_count = 0;
    for (const TextWord& word : *words) {
        names.push_back(word.name);
        phone_count += phonesOf(word.syllables).size();
    }
    const double shortest_s = static_cast<double>(phone_count) * shortest_phone_s;
    if (duration_s < shortest_s)
        return fail(where, fmt::format("found {:.2f} s of sound for {} words, expected at least {:.2f} s",
                                       duration_s, written->size(), shortest_s));

    const auto samples = samplesOf(sound);
    const TextFound found = findText(state_->sphinx, names, samples);
    if (found.words.empty())
        return fail(
            where,
            fmt::format("the text's {} words are not found in it one after the other", written->size()),
            check_hint);
    const auto anything = [&] { return state_->sphinx.find(anyPhones(), samples); };
    if (const auto stretch = doubtfulStretch(found.words, anything)) {
        const auto [first, last] = *stretch;
        return fail(
            where,
            fmt::format("from {:.1f} to {:.1f} s something else is heard than \"{}\" to \"{}\"",
                        secondsAt(found.words[first].first), secondsAt(found.words[last].last),
                        (*written)[(*words)[first].written].text, (*written)[(*words)[last].written].text),
            check_hint);
    }
    if (const auto more = soundBesides(found.words, samples))
        return fail(where,
                    fmt::format("from {:.1f} to {:.1f} s something is heard that is not in the text",
                                secondsAt(more->first), secondsAt(more->second)),
                    check_hint);
    return alignmentOf(*written, *words, found.words, phonesIn(state_->sphinx, found.pieces, *words, samples),
                       duration_s);
}

}  // namespace deixis::speech
