// PocketSphinx, as far as both its versions have it: 0.8+5prealpha (Debian 12) and 5 (Debian 13).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

struct ps_decoder_s;

namespace deixis::speech {

inline constexpr int sphinx_rate_hz = 16000;
inline constexpr int sphinx_frames_per_s = 100;

/// A word as it was found in a sound; fillers, such as silence, are none.
struct FoundWord {
    std::string name;
    int first = 0;       ///< frame
    int last = 0;        ///< frame, of the word too
    double score = 0.0;  ///< of its frames together: a logarithm, 0 at best
};

class Sphinx {
  public:
    /// Errors: as Aligner::load().
    [[nodiscard]] static Result<Sphinx> load(const std::filesystem::path& model);

    /// Of the dictionary: phones parted by spaces; each pronunciation, none for an unknown word.
    [[nodiscard]] std::vector<std::string> pronunciationsOf(const std::string& word) const;

    /// Makes a word that can stand in grammars, unless it is there. `name` is of letters, digits and "_".
    /// False where a phone is unknown.
    [[nodiscard]] bool addWord(const std::string& name, const std::vector<std::string>& pronunciations);

    /// The words of a grammar (the right side of a JSGF rule) that fit the samples best; empty where none do.
    [[nodiscard]] std::vector<FoundWord> find(const std::string& grammar,
                                              const std::vector<std::int16_t>& samples);

  private:
    struct Free {
        void operator()(ps_decoder_s* decoder) const;
    };
    explicit Sphinx(ps_decoder_s* decoder) : decoder_(decoder) {}
    std::unique_ptr<ps_decoder_s, Free> decoder_;
};

}  // namespace deixis::speech
