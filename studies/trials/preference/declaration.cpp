// A pair: two avatars side by side, which is better, and where a study asks for it, why.
#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "studies/study_file/standing.hpp"
#include "study_reading.hpp"

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

/// A pair stands to either side of the line of sight: none of the two on the participant's place.
void checkRoomForPair(TomlTable& table, const Study& study, const std::vector<std::string>& layouts) {
    constexpr double min_m = 1.0;
    for (const std::string& name : layouts) {
        const Layout* layout = study.findLayout(name);
        if (layout == nullptr || table.faulty("layouts")) continue;
        for (const Standing standing : {Standing::headset, Standing::desktop}) {
            const Pose viewer = viewerPose(viewerPlace(*layout, standing));
            for (const Vec3& place : pairPlaces(viewer))
                if (const double away_m = glm::length(place - viewer.position); away_m < min_m) {
                    table.problem("layouts",
                                  fmt::format("found \"{}\", where one avatar of a pair would be {:.2f} m "
                                              "from the participant; expected a layout with at least {} m",
                                              name, away_m, min_m));
                    return;
                }
        }
    }
}

void checkLevels(TomlTable& table, const Study& study, const Stage& stage) {
    if (!table.faulty("systems") && stage.design.systems.size() == 1)
        table.problem("systems", "found 1 system, expected 2 or more: a pair has two");
    checkRoomForPair(table, study, stage.design.layouts);
}

Question readReasons(TomlTable& parent) {
    TomlTable table = parent.below("reasons", parent.section("reasons", true), keys::reasons);
    Question question;
    question.id = "reasons";
    question.text = table.text("text");
    question.required = table.flag("required", true);
    constexpr std::string_view kinds[] = {"choice", "choices", "text"};
    constexpr QuestionKind values[] = {QuestionKind::choice, QuestionKind::choices, QuestionKind::text};
    question.kind = values[table.choice("kind", kinds, false).value_or(1)];
    if (question.kind != QuestionKind::text)
        question.options = readOptions(table);
    else
        table.reject("options", "in a question of kind \"text\"");
    return question;
}

void read(TomlTable& table, StageReading& reading, Stage& stage) {
    readTrials(table, reading, stage);
    if (table.has("reasons")) stage.reasons = readReasons(table);
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
                                                   .read = preference::read,
                                                   .min_stimuli = 2,
                                                   .max_stimuli = 2,
                                                   .shown = preference::eachPair,
                                                   .arrangement = Arrangement::sides,
                                                   .checks = preference::checks,
                                                   .checkLevels = preference::checkLevels,
                                                   .questions = preference::questions,
                                                   .measures = preference::measures};

}  // namespace deixis::studies
