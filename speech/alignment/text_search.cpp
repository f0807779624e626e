#include "text_search.hpp"

#include <algorithm>

namespace deixis::speech {

namespace {

constexpr int frame_samples = sphinx_rate_hz / sphinx_frames_per_s;
constexpr int window_frames = 30 * sphinx_frames_per_s;
/// What is left is searched as a whole where it is not longer.
constexpr int whole_frames = 45 * sphinx_frames_per_s;
/// Words nearer to a window's end may be cut off, or be what fits a part of the next one.
constexpr int margin_frames = 3 * sphinx_frames_per_s;
/// More than anybody says in a window.
constexpr std::size_t window_words = 200;

/// The words in their order as far as the sound goes: each can be the last.
std::string anyBeginning(const std::vector<std::string>& names, std::size_t first, std::size_t end) {
    std::string out;
    for (std::size_t i = first; i < end; ++i) out += " [ " + names[i];
    for (std::size_t i = first; i < end; ++i) out += " ]";
    return out;
}

/// How many of a window's words are kept, and where it is cut: in the longest pause of its second half.
std::pair<std::size_t, int> cutOf(const std::vector<FoundWord>& found) {
    std::size_t kept = 0;
    int cut = 0, longest = -1;
    for (std::size_t i = 0; i < found.size() && found[i].last < window_frames - margin_frames; ++i) {
        const int next = i + 1 < found.size() ? found[i + 1].first : window_frames - margin_frames;
        const int pause = found[i].last < window_frames / 2 ? -1 : next - found[i].last - 1;
        if (pause < longest) continue;
        longest = pause;
        kept = i + 1;
        cut = (found[i].last + 1 + next) / 2;
    }
    return {kept, kept == 0 ? window_frames / 2 : cut};
}

}  // namespace

std::vector<std::int16_t> samplesIn(const Piece& piece, const std::vector<std::int16_t>& samples) {
    const auto at = [&](int frame) {
        return samples.begin() +
               std::min<std::ptrdiff_t>(std::ptrdiff_t{frame} * frame_samples, std::ssize(samples));
    };
    return {at(piece.first_frame), at(piece.end_frame)};
}

TextFound findText(Sphinx& sphinx, const std::vector<std::string>& names,
                   const std::vector<std::int16_t>& samples) {
    const auto frames = static_cast<int>(std::ssize(samples) / frame_samples) + 1;
    TextFound out;
    const auto add = [&](Piece piece, const std::vector<FoundWord>& found) {
        for (std::size_t i = 0; i < piece.end_word - piece.first_word; ++i) {
            out.words.push_back(found[i]);
            out.words.back().first += piece.first_frame;
            out.words.back().last += piece.first_frame;
        }
        out.pieces.push_back(piece);
    };
    Piece piece{0, window_frames, 0, 0};
    while (frames - piece.first_frame > whole_frames && piece.first_word < names.size()) {
        const std::size_t end = std::min(names.size(), piece.first_word + window_words);
        const auto found = sphinx.find(anyBeginning(names, piece.first_word, end), samplesIn(piece, samples));
        const auto [kept, cut] = cutOf(found);
        piece.end_word = piece.first_word + kept;
        piece.end_frame = piece.first_frame + cut;
        add(piece, found);
        piece = {piece.end_frame, piece.end_frame + window_frames, piece.end_word, piece.end_word};
    }
    if (piece.first_word == names.size()) return out;
    piece.end_frame = frames;
    piece.end_word = names.size();
    std::string rest;
    for (std::size_t i = piece.first_word; i < names.size(); ++i) rest += " " + names[i];
    // A text that goes on long after the sound would take long to search for.
    const double most_words = static_cast<double>(frames - piece.first_frame) / window_frames * window_words;
    const auto found = static_cast<double>(piece.end_word - piece.first_word) > most_words
                           ? std::vector<FoundWord>()
                           : sphinx.find(rest, samplesIn(piece, samples));
    if (found.size() != piece.end_word - piece.first_word) return {};
    add(piece, found);
    return out;
}

}  // namespace deixis::speech
