// A page that is answered: whether the participant takes part.
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace consent {
namespace {

constexpr std::string_view keys[] = {"text"};

int onePage(const Stage& /*stage*/) {
    return 1;
}

}  // namespace
}  // namespace consent

extern const StageDeclaration consent_declaration{
    .name = "consent", .keys = consent::keys, .asks_consent = true, .pages = consent::onePage};

}  // namespace deixis::studies
