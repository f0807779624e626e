// Questions of any type, on as many pages as they need, from a file of their own or the study file.
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace questionnaire {
namespace {

constexpr std::string_view keys_of_kind[] = {
    "text", "file", "questions", "title", "per_page", "about_participant", "scale"};

int pages(const Stage& stage) {
    return stage.questionnaire.pages();
}

std::vector<Question> questions(const Stage& stage, const LanguageTable& /*words*/) {
    return stage.questionnaire.questions;
}

}  // namespace
}  // namespace questionnaire

extern const StageDeclaration questionnaire_declaration{.name = "questionnaire",
                                                        .keys = questionnaire::keys_of_kind,
                                                        .in_pages = true,
                                                        .pages = questionnaire::pages,
                                                        .questions = questionnaire::questions};

}  // namespace deixis::studies
