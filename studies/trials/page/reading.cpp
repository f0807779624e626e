#include "study_reading.hpp"

namespace deixis::studies {

namespace page {
namespace {

void read(TomlTable& table, StageReading& /*reading*/, Stage& stage) {
    stage.text = table.text("text");
    if (declarationOf(stage.kind).has("emphasis")) stage.emphasis = table.text("emphasis", "");
    stage.minimum_s = table.number("minimum_s", 0.0, 3600.0, 0.0);
}

}  // namespace
}  // namespace page

extern const KindReader instructions_reader{page::read};
extern const KindReader rest_reader{page::read};

}  // namespace deixis::studies
