// One calm sentence to the participant, on a small board beside everything else.
#pragma once

#include <string>

#include "studies/station/station.hpp"

namespace deixis::studies {

/// In lines of this height; as wide as the sentence, within bounds. Where it stands is the station's to say.
[[nodiscard]] Panel noticePanel(const std::string& sentence, double line_m);

}  // namespace deixis::studies
