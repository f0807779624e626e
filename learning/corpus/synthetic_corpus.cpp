#include "learning/corpus/synthetic_corpus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "motion/phrase_gestures/phrase_gestures.hpp"
#include "motion/unit_gestures/rule_set_a.hpp"
#include "speech/prosody/utterance.hpp"

namespace deixis::learning {

namespace {

Result<void> checkSettings(const SyntheticCorpusSettings& settings) {
    if (!(settings.minutes > 0.0) || settings.parts.empty())
        return fail("", "found no minutes or no part to make, expected some");
    if (settings.gesturer == Gesturer::person)
        return fail("", "found a person as the one who gestures, expected rules A or rules B");
    if (settings.voices.empty()) return fail("", "found no voice, expected at least one");
    const auto known = speech::Voices().names();
    for (const std::string& voice : settings.voices)
        if (std::ranges::find(known, voice) == known.end())
            return fail("", fmt::format("found voice \"{}\", expected {}", voice, fmt::join(known, ", ")));
    if (!(settings.slowest >= 0.5 && settings.slowest <= settings.fastest && settings.fastest <= 2.0))
        return fail("", fmt::format("found rates from {} to {}, expected 0.5 to 2", settings.slowest,
                                    settings.fastest));
    if (!(settings.shortest_s > 0.0 && settings.shortest_s < settings.longest_s))
        return fail("", fmt::format("found speeches of {} to {} s", settings.shortest_s, settings.longest_s));
    return {};
}

/// As many texts as fill the time. Text number i is the same in a longer corpus.
Result<std::vector<speech::SpeechText>> textsFor(const SyntheticCorpusSettings& settings,
                                                 const speech::SentenceGrammar& grammar) {
    // Narrower than asked for, where there is room: voices differ from the estimate.
    constexpr double longer = 1.25, shorter = 0.85;
    speech::SpeechLengths lengths{longer * settings.shortest_s, shorter * settings.longest_s};
    if (lengths.min_s >= lengths.max_s) lengths = {settings.shortest_s, settings.longest_s};
    const double mean_s = 0.5 * (lengths.min_s + lengths.max_s);
    for (double share = 1.0;; share *= 1.5) {
        const auto count = static_cast<std::size_t>(share * 60.0 * settings.minutes / mean_s) + 1;
        auto texts = speech::drawSpeechTexts(grammar, settings.seed, count, lengths);
        if (!texts) return texts;
        double seconds = 0.0;
        for (std::size_t i = 0; i < texts->size(); ++i) {
            seconds += speech::spokenSeconds((*texts)[i].text);
            if (seconds < 60.0 * settings.minutes) continue;
            texts->resize(i + 1);
            return texts;
        }
    }
}

class TakeMaker {
  public:
    TakeMaker(const SyntheticCorpusSettings& settings, const motion::GestureLibrary& library)
        : settings_(settings), library_(library) {}

    [[nodiscard]] Result<CorpusTake> make(std::size_t number, const speech::SpeechText& text) const {
        Random random(settings_.seed, fmt::format("take {}", number));
        CorpusTake take;
        take.name = fmt::format("{:05}-{}", number + 1, text.theme);
        take.part = text.part;
        take.text = text.text;
        // Every tenth speech is for the test: its voice moves on each time.
        take.voice = settings_.voices[(number + number / 10) % settings_.voices.size()];
        take.gesturer = settings_.gesturer;
        auto spoken = speak(text.text, take.voice, random.uniform(settings_.slowest, settings_.fastest));
        if (!spoken) return tl::unexpected(spoken.error());
        take.samples = std::move(spoken->sound.samples);
        take.utterance = std::move(spoken->utterance);
        const std::uint64_t seed = random.next();
        auto gestured = take.gesturer == Gesturer::rules_a
                            ? motion::gesturesByRuleSetA(take.utterance, library_, seed)
                            : motion::gestureByPhrases(take.utterance, library_, seed);
        take.motion = std::move(gestured.motion);
        take.strokes = std::move(gestured.strokes);
        return take;
    }

  private:
    Result<speech::SpokenText> speak(const std::string& text, const std::string& voice, double rate) const {
        constexpr double slowest = 0.5, fastest = 2.0;
        auto spoken = speech::spokenText(voices_, nullptr, text, voice, {rate});
        if (!spoken) return spoken;
        const double duration_s = spoken->utterance.duration_s;
        const double wanted_s = std::clamp(duration_s, settings_.shortest_s, settings_.longest_s);
        if (wanted_s != duration_s) {
            constexpr double within = 0.99;  // rates are not met to the sample
            const double factor = wanted_s < duration_s ? wanted_s * within : wanted_s / within;
            spoken = speech::spokenText(voices_, nullptr, text, voice,
                                        {std::clamp(rate * duration_s / factor, slowest, fastest)});
        }
        if (spoken && spoken->sound.rate_hz != corpus_rate_hz)
            spoken->sound = speech::resampled(spoken->sound, corpus_rate_hz);
        return spoken;
    }

    const SyntheticCorpusSettings& settings_;
    const motion::GestureLibrary& library_;
    speech::Voices voices_;
};

}  // namespace

Result<Corpus> makeSyntheticCorpus(const SyntheticCorpusSettings& settings,
                                   const speech::SentenceGrammar& grammar,
                                   const motion::GestureLibrary& library,
                                   const std::function<void(std::size_t, std::size_t)>& progress) {
    if (auto fine = checkSettings(settings); !fine) return tl::unexpected(fine.error());
    const auto texts = textsFor(settings, grammar);
    if (!texts) return tl::unexpected(texts.error());
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < texts->size(); ++i)
        if (std::ranges::find(settings.parts, (*texts)[i].part) != settings.parts.end()) numbers.push_back(i);

    const TakeMaker maker(settings, library);
    Corpus corpus;
    corpus.synthetic = true;
    corpus.takes.resize(numbers.size());
    std::mutex mutex;
    std::optional<Error> problem;
    takeInTurn(
        numbers.size(), settings.threads,
        [&](unsigned) {
            return [&](std::size_t i) {
                auto take = maker.make(numbers[i], (*texts)[numbers[i]]);
                if (take) {
                    corpus.takes[i] = std::move(*take);
                    return;
                }
                const std::lock_guard lock(mutex);
                if (!problem) problem = take.error();
            };
        },
        [&](std::size_t done, std::size_t count) {
            if (progress) progress(done, count);
        });
    if (problem) return tl::unexpected(*problem);
    return corpus;
}

}  // namespace deixis::learning
