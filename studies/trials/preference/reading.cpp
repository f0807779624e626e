#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "studies/study_file/standing.hpp"
#include "study_reading.hpp"

namespace deixis::studies {

namespace preference {
namespace {

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
    for (const std::string& name : stage.design.systems)
        if (const SystemSource* system = study.findSystem(name); system != nullptr && !system->compared)
            table.problem("systems",
                          fmt::format("found \"{}\", which is not to be compared, expected systems that "
                                      "are: a pair is a comparison",
                                      name));
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
    if (!table.has("systems"))
        std::erase_if(stage.design.systems, [&](const std::string& name) {
            const SystemSource* system = reading.reader.study.findSystem(name);
            return system != nullptr && !system->compared;
        });
    if (table.has("reasons")) stage.reasons = readReasons(table);
}

}  // namespace
}  // namespace preference

extern const KindReader pairwise_reader{preference::read, preference::checkLevels};

}  // namespace deixis::studies
