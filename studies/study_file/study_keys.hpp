// Every key that a study file and a questionnaire file may have, but for those of one kind of stage, which
// its declaration has; private to studies.
#pragma once

#include <span>
#include <string_view>

#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

using Keys = std::span<const std::string_view>;

namespace keys {
extern const Keys root, study, targets, distances, layouts, systems, between, checks, confidence, reasons,
    scale, questions, rates, options, headset, analysis, leave_out;
extern const Keys any_stage;  ///< every stage has these,
extern const Keys trials;     ///< every one that shows clips these, too,
extern const Keys practice;   ///< and practice these; what a kind has beside them it declares
extern const Keys questionnaire, scores;
}  // namespace keys

/// As the file names practice of another stage, which is no kind of its own.
inline constexpr std::string_view practice_name = "practice";
[[nodiscard]] bool practiceHas(std::string_view key);

/// Of stages of any kind, each once.
[[nodiscard]] Keys stageKeys();

}  // namespace deixis::studies
