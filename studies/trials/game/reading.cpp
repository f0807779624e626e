#include "study_reading.hpp"

namespace deixis::studies {

namespace game {
namespace {

Question readConfidence(TomlTable& parent) {
    TomlTable table = parent.below("confidence", parent.section("confidence", true), keys::confidence);
    Question question;
    question.id = "confidence";
    question.text = table.text("text");
    question.scale = readScale(table, "scale");
    return question;
}

void read(TomlTable& table, StageReading& reading, Stage& stage) {
    readTrials(table, reading, stage);
    stage.feedback = table.flag("feedback", false);
    stage.time_limit_s = table.number("time_limit_s", 0.0, 600.0, 0.0);
    if (table.has("confidence")) stage.confidence = readConfidence(table);
}

}  // namespace
}  // namespace game

extern const KindReader game_reader{game::read};

}  // namespace deixis::studies
