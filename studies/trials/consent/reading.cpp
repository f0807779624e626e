#include "study_reading.hpp"

namespace deixis::studies {

namespace consent {
namespace {

void read(TomlTable& table, StageReading& /*reading*/, Stage& stage) {
    stage.text = table.text("text");
}

}  // namespace
}  // namespace consent

extern const KindReader consent_reader{consent::read};

}  // namespace deixis::studies
