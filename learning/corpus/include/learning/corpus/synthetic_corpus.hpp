// A corpus that nobody spoke or gestured: texts from a grammar, spoken by flite's voices, gestured by rules.
#pragma once

#include <cstdint>
#include <functional>

#include "core/error.hpp"
#include "learning/corpus/corpus.hpp"
#include "motion/unit_gestures/unit_gesture.hpp"
#include "speech/sentences/sentence_grammar.hpp"

namespace deixis::learning {

struct SyntheticCorpusSettings {
    double minutes = 120.0;  ///< at least, of all parts together, by the texts' estimated length
    std::uint64_t seed = 1;
    /// One of the rule sets. The same seed gives the same speeches for either.
    Gesturer gesturer = Gesturer::rules_a;
    /// Parts that are made; the others are only drawn, so that what is made does not depend on them.
    std::vector<speech::CorpusPart> parts{speech::CorpusPart::training, speech::CorpusPart::validation,
                                          speech::CorpusPart::test};
    /// Each speech is spoken by one of them in turn, at a rate of its own.
    std::vector<std::string> voices{"slt", "rms", "awb", "kal16"};
    double slowest = 0.95, fastest = 1.15;      ///< against the voice's own rate
    double shortest_s = 5.0, longest_s = 24.0;  ///< a speech beyond them is spoken slower or faster
    unsigned threads = 2;
};

/// The same settings, grammar and library give the same takes, in whatever number of threads; flite speaks
/// one text at a time. Fails where the grammar cannot say so much, a voice is unknown, no time or no part is
/// asked for, or a rule set is not named.
[[nodiscard]] Result<Corpus> makeSyntheticCorpus(
    const SyntheticCorpusSettings& settings, const speech::SentenceGrammar& grammar,
    const motion::GestureLibrary& library,
    const std::function<void(std::size_t done, std::size_t count)>& progress = {});

}  // namespace deixis::learning
