// What is said in a recording, as labs write it down: words with times in a table or in a TextGrid of Praat,
// or the text alone.
#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/utterance.hpp"

namespace deixis::learning {

/// A table of words: a header with word (or text, label), start_s (or start, begin, xmin) and end_s (or end,
/// xmax), in seconds; other columns are passed over, as are rows without a word. CSV of any separator, as
/// spreadsheets write it. Errors name file, line and column: columns that are missing, times that are no
/// numbers, below 0 or not in order. `name` stands for the file.
[[nodiscard]] Result<std::vector<SpokenWord>> parseWordTable(std::string bytes, const std::string& name);
/// The same as such a table, times with four decimals.
[[nodiscard]] std::string wordTable(const std::vector<SpokenWord>& words);

/// Praat's text files, long or short ("Praat, doing phonetics by computer", manual: TextGrid file formats),
/// in UTF-8 or UTF-16: the interval tier named "words" or "word", whatever the case, or one whose name ends
/// so
/// ("speaker - words"). Intervals without text, and those of silence or noise ("sil", "sp", "spn", "<p>",
/// "<unk>", "#"), are no words. Errors name the file: what is no TextGrid, is cut off, or has no such tier
/// (the tiers that it has are named) or several of them.
[[nodiscard]] Result<std::vector<SpokenWord>> parseTextGrid(std::string bytes, const std::string& name);

}  // namespace deixis::learning
