// The referential game: which ball does the avatar point at? (Deichler et al. 2023, section 2.4.2.)
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace game {
namespace {

constexpr std::string_view keys_of_kind[] = {"system_meets", "max_run_of_system", "max_replays",
                                             "distances",    "distance_meets",    "feedback",
                                             "time_limit_s", "confidence"};
constexpr CheckKind checks[] = {CheckKind::catch_trial};
constexpr DeclaredMeasure measures[] = {{"", AnswerKind::accuracy, "accuracy"},
                                        {"confidence", AnswerKind::rating, "confidence"}};
constexpr KeptField planned[] = {
    {"distractors", KeptType::text, "Centres of the distractors, JSON [[x,y,z],...]", "m"},
    {"balls", KeptType::text, "Centres of the balls in the order shown, JSON [[x,y,z],...]", "m"},
    {"target_place", KeptType::whole, "Which of the balls is the target, from 0"}};
constexpr KeptField chosen[] = {
    {"chosen_place", KeptType::whole, "The chosen ball, from 0 in the order shown"},
    {"correct", KeptType::truth, "1 if the target was chosen"}};

std::vector<Question> questions(const Stage& stage, const LanguageTable& /*words*/) {
    if (!stage.confidence) return {};
    std::vector<Question> out{*stage.confidence};
    out.back().id = "confidence";
    return out;
}

}  // namespace
}  // namespace game

extern const StageDeclaration game_declaration{.name = "referential-game",
                                               .keys = game::keys_of_kind,
                                               .min_stimuli = 1,
                                               .max_stimuli = 1,
                                               .shown = eachByItself,
                                               .placed = true,
                                               .balls = true,
                                               .right_or_wrong = true,
                                               .checks = game::checks,
                                               .questions = game::questions,
                                               .measures = game::measures,
                                               .trial_values = {"game_trials", game::planned},
                                               .response_values = {"game_choices", game::chosen}};

}  // namespace deixis::studies
