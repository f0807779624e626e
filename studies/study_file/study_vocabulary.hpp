// Every key that a study file and a questionnaire file may have, and which kinds of stages have which;
// private to studies.
#pragma once

#include <span>
#include <string_view>

#include "studies/study_file/study.hpp"

namespace deixis::studies {

using Keys = std::span<const std::string_view>;

namespace keys {
extern const Keys root, study, targets, distances, layouts, systems, between, stages, checks, confidence,
    reasons, scale, questions, options, headset, analysis, leave_out;
extern const Keys questionnaire, scores;
}  // namespace keys

/// The kinds as the file names them: those of StageKind in its order, and practice.
inline constexpr std::string_view kind_names[] = {"instructions",     "consent",         "questionnaire",
                                                  "rating",           "parallel-rating", "pairwise",
                                                  "referential-game", "break",           "practice"};
inline constexpr std::size_t practice_kind = 8;

/// Whether stages of a kind (its place in kind_names) may have a key.
[[nodiscard]] bool stageHasKey(std::size_t kind, std::string_view key);

}  // namespace deixis::studies
