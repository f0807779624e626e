#include "study_reading.hpp"

namespace deixis::studies {

namespace placement {
namespace {

void read(TomlTable& table, StageReading& reading, Stage& stage) {
    readTrials(table, reading, stage);
    stage.feedback = table.flag("feedback", false);
    stage.time_limit_s = table.number("time_limit_s", 0.0, 600.0, 0.0);
}

}  // namespace
}  // namespace placement

extern const KindReader placement_reader{placement::read};

}  // namespace deixis::studies
