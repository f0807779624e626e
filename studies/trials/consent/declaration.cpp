// A page that is answered: whether the participant takes part.
#include "study_reading.hpp"

namespace deixis::studies {

namespace consent {
namespace {

constexpr std::string_view keys[] = {"text"};

void read(TomlTable& table, StageReading& /*reading*/, Stage& stage) {
    stage.text = table.text("text");
}

int onePage(const Stage& /*stage*/) {
    return 1;
}

}  // namespace
}  // namespace consent

extern const StageDeclaration consent_declaration{.name = "consent",
                                                  .keys = consent::keys,
                                                  .read = consent::read,
                                                  .asks_consent = true,
                                                  .pages = consent::onePage};

}  // namespace deixis::studies
