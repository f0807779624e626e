// A single movement, rated on a scale.
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace rating {
namespace {

constexpr std::string_view keys[] = {"system_meets", "max_run_of_system", "measure", "scale", "max_replays"};
constexpr CheckKind checks[] = {CheckKind::number, CheckKind::repeat};
constexpr DeclaredMeasure measures[] = {{"rating", AnswerKind::rating, ""}};

}  // namespace
}  // namespace rating

extern const StageDeclaration rating_declaration{.name = "rating",
                                                 .keys = rating::keys,
                                                 .min_stimuli = 1,
                                                 .max_stimuli = 1,
                                                 .shown = eachByItself,
                                                 .checks = rating::checks,
                                                 .questions = ratingQuestion,
                                                 .measures = rating::measures};

}  // namespace deixis::studies
