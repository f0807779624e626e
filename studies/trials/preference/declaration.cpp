// A pair: two avatars side by side, which is better, and where a study asks for it, why.
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace preference {
namespace {

constexpr std::string_view keys_of_kind[] = {"system_meets", "measure", "reasons"};
constexpr CheckKind checks[] = {CheckKind::repeat};
constexpr DeclaredMeasure measures[] = {{"preference", AnswerKind::preference, "preference"}};

std::vector<std::vector<int>> eachPair(int systems) {
    std::vector<std::vector<int>> pairs;
    for (int i = 0; i < systems; ++i)
        for (int j = i + 1; j < systems; ++j) pairs.push_back({i, j});
    return pairs;
}

std::vector<Question> questions(const Stage& stage, const LanguageTable& words) {
    Scale preference;
    preference.low = -2;
    preference.high = 2;
    for (const char* key : {"prefer_left_clearly", "prefer_left_slightly", "prefer_neither",
                            "prefer_right_slightly", "prefer_right_clearly"})
        preference.labels.push_back(words(key));
    std::vector<Question> out{{"preference", QuestionKind::scale, stage.question, preference}};
    if (!stage.reasons) return out;
    out.push_back(*stage.reasons);
    out.back().id = "reasons";
    return out;
}

}  // namespace
}  // namespace preference

extern const StageDeclaration pairwise_declaration{.name = "pairwise",
                                                   .keys = preference::keys_of_kind,
                                                   .min_stimuli = 2,
                                                   .max_stimuli = 2,
                                                   .shown = preference::eachPair,
                                                   .arrangement = Arrangement::sides,
                                                   .checks = preference::checks,
                                                   .questions = preference::questions,
                                                   .measures = preference::measures};

}  // namespace deixis::studies
