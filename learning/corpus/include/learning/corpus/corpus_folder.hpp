// A corpus as a folder: what a lab records, and what we write of a synthetic one.
//
// A take is NAME.wav, NAME.bvh (or .bvh.gz) and its transcript: NAME.csv (words with times), NAME.TextGrid,
// or NAME.txt (the text alone, which is then aligned). The folders training, validation and test part the
// takes; where there are none, they are parted by their names.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "learning/corpus/corpus.hpp"

namespace deixis::learning {

struct CorpusReadOptions {
    /// Between the durations of sound and motion: beyond it they are not of one recording, within it the
    /// motion is cut, or its last pose kept, to the sound's length.
    double most_difference_s = 0.5;
    /// Frames a second of the motions, where their files say something else.
    std::optional<double> fps{};
    unsigned threads = 2;
};

struct CorpusFolder {
    Corpus corpus;
    std::vector<Error> left_out;  ///< takes that could not be used, and why; each names its file
};

/// Reads all takes. Motions may have any skeleton that is a humanoid's (as `deixis clips` finds it, or a file
/// NAME.humanoid.toml says), sounds any rate. Accents are found in the sound: with a text alone by its
/// syllables, with words and times by words. Without such folders, of ten takes in the order of their names
/// the fifth is for validation and the tenth for the test; of fewer than ten the last is for validation.
/// Fails where there is no such folder or no take that can be used; then the first reason is told.
[[nodiscard]] Result<CorpusFolder> readCorpusFolder(
    const std::filesystem::path& folder, const CorpusReadOptions& options = {},
    const std::function<void(std::size_t done, std::size_t count)>& progress = {});

/// Writes each take into the folder of its part as NAME.wav (16 bits), NAME.bvh, NAME.csv and, where there is
/// a text, NAME.spoken (which is not read again); and corpus.csv, the list of all takes, which says what is
/// synthetic. BVH files are of the reference humanoid, and one frame longer than the motion where its last
/// frame is before the sound's end. Files of the same name are replaced.
[[nodiscard]] Result<void> writeCorpusFolder(const Corpus& corpus, const std::filesystem::path& folder);

}  // namespace deixis::learning
