// Where commands have speeches with gestures from: a lab's folder, or a synthetic corpus that is made.
#pragma once

#include <string>
#include <vector>

#include "app/program/parser.hpp"
#include "core/error.hpp"
#include "learning/corpus/corpus.hpp"
#include "learning/gesture_scores/gesture_takes.hpp"

namespace deixis::app {

struct CorpusSource {
    std::string folder;       ///< of a lab; empty: synthetic
    std::string rules = "a";  ///< or "b": who gestures in a synthetic one
    double minutes = 120.0;   ///< of a synthetic one, all parts together
    /// Parts of a synthetic one that are made; a folder is read as a whole.
    std::vector<speech::CorpusPart> parts{speech::CorpusPart::training, speech::CorpusPart::validation,
                                          speech::CorpusPart::test};
};

/// --corpus and --minutes.
void addCorpusOptions(Parser command, CorpusSource& source);
/// --rules.
void addCorpusRules(Parser command, CorpusSource& source);

/// Takes of a folder that cannot be used are told on stderr. The synthetic corpus is always the same one.
[[nodiscard]] Result<learning::Corpus> makeOrReadCorpus(const CorpusSource& source);

/// Takes the takes of that part out of the corpus, for a trainer or an evaluation: hours of sound are not
/// there twice.
[[nodiscard]] std::vector<learning::GestureTake> takenFrom(learning::Corpus& corpus, speech::CorpusPart part);
[[nodiscard]] double minutesOf(const std::vector<learning::GestureTake>& takes);

}  // namespace deixis::app
