// Free placement: the participant puts a ball where they believe that the avatar points.
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace placement {
namespace {

constexpr std::string_view keys[] = {"system_meets", "max_run_of_system", "max_replays", "feedback",
                                     "time_limit_s"};
constexpr CheckKind checks[] = {CheckKind::repeat};
constexpr DeclaredMeasure measures[] = {{"distance", AnswerKind::rating, "placement distance", "cm"},
                                        {"angle", AnswerKind::rating, "placement angle", "degrees"}};
constexpr KeptField placed[] = {
    {"placed_x_m", KeptType::number, "Where the ball was put: its centre in the avatar's frame", "m"},
    {"placed_y_m", KeptType::number, "", "m"},
    {"placed_z_m", KeptType::number, "", "m"}};

constexpr double farthest_cm = 1000.0;  ///< beyond what a ball within reach of the ray can be off
constexpr double opposite_deg = 180.0;

/// Measured rather than asked: their texts are for whoever reads the data.
std::vector<Question> questions(const Stage& /*stage*/, const LanguageTable& /*words*/) {
    Question distance{"distance", QuestionKind::number, "From the target to where the ball was put, in cm"};
    distance.high = farthest_cm;
    distance.whole = false;
    Question angle{"angle", QuestionKind::number,
                   "Between target and ball as seen by the avatar, in degrees"};
    angle.high = opposite_deg;
    angle.whole = false;
    return {distance, angle};
}

}  // namespace
}  // namespace placement

extern const StageDeclaration placement_declaration{.name = "free-placement",
                                                    .keys = placement::keys,
                                                    .min_stimuli = 1,
                                                    .max_stimuli = 1,
                                                    .shown = eachByItself,
                                                    .placed = true,
                                                    .checks = placement::checks,
                                                    .questions = placement::questions,
                                                    .measures = placement::measures,
                                                    .response_values = {"placements", placement::placed}};

}  // namespace deixis::studies
