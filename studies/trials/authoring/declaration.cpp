// Authoring: the participant makes gestures to a speech in the studio's page (Yoon et al. 2021, 7.1). The
// system says by which means.
#include <algorithm>

#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace authoring {
namespace {

constexpr std::string_view keys[] = {"system_meets",     "max_run_of_system",     "limit_s",
                                     "may_end_early",    "keyframes_only",        "practice_per_block",
                                     "practice_limit_s", "practice_may_end_early"};
constexpr DeclaredMeasure measures[] = {{"time", AnswerKind::rating, "authoring time", "s"}};
constexpr KeptField authored[] = {
    {"project", KeptType::text, "What was authored: a project of the studio (JSON)"},
    {"edits", KeptType::whole, "How many changes led to it"},
    {"poses", KeptType::whole, "Pose controls in it"},
    {"styles", KeptType::whole, "Style controls in it"},
    {"generated", KeptType::whole, "How often gestures were generated in the trial"}};

/// Measured rather than asked: its text is for whoever reads the data.
std::vector<Question> questions(const Stage& stage, const LanguageTable& /*words*/) {
    Question time{"time", QuestionKind::number, "How long the gestures were worked on, in s"};
    time.high = std::max(stage.authoring.limit_s, stage.authoring.practice_limit_s);
    time.whole = false;
    return {time};
}

}  // namespace
}  // namespace authoring

extern const StageDeclaration authoring_declaration{.name = "authoring",
                                                    .keys = authoring::keys,
                                                    .min_stimuli = 1,
                                                    .max_stimuli = 1,
                                                    .shown = eachByItself,
                                                    .in_studio = true,
                                                    .questions = authoring::questions,
                                                    .measures = authoring::measures,
                                                    .response_values = {"authored", authoring::authored}};

}  // namespace deixis::studies
