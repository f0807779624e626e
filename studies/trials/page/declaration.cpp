// Pages to be read: instructions, and breaks.
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace page {
namespace {

constexpr std::string_view instructions_keys[] = {"text", "emphasis", "minimum_s"};
constexpr std::string_view rest_keys[] = {"text", "minimum_s"};

}  // namespace
}  // namespace page

extern const StageDeclaration instructions_declaration{
    .name = "instructions", .keys = page::instructions_keys, .answered = false};

extern const StageDeclaration rest_declaration{
    .name = "break", .keys = page::rest_keys, .answered = false, .is_break = true};

}  // namespace deixis::studies
