// Pages to be read: instructions, and breaks.
#include "study_reading.hpp"

namespace deixis::studies {

namespace page {
namespace {

constexpr std::string_view instructions_keys[] = {"text", "emphasis", "minimum_s"};
constexpr std::string_view rest_keys[] = {"text", "minimum_s"};

void read(TomlTable& table, StageReading& /*reading*/, Stage& stage) {
    stage.text = table.text("text");
    if (declarationOf(stage.kind).has("emphasis")) stage.emphasis = table.text("emphasis", "");
    stage.minimum_s = table.number("minimum_s", 0.0, 3600.0, 0.0);
}

}  // namespace
}  // namespace page

extern const StageDeclaration instructions_declaration{
    .name = "instructions", .keys = page::instructions_keys, .read = page::read, .answered = false};

extern const StageDeclaration rest_declaration{
    .name = "break", .keys = page::rest_keys, .read = page::read, .answered = false, .is_break = true};

}  // namespace deixis::studies
