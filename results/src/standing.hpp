// Who counts.
#pragma once

#include <string>

namespace deixis::results {

/// SQL: the ids of participants who refused one of the study's consents when last asked for it.
inline constexpr const char* refusing_participants =
    "SELECT participant FROM consents AS c WHERE NOT agreed AND session = (SELECT max(session) FROM consents "
    "AS o WHERE o.participant = c.participant AND o.stage = c.stage)";

/// SQL in place of the table `participants`, for whatever asks who counts: without consent nobody is active,
/// whatever the table says.
[[nodiscard]] std::string participantsStanding();

}  // namespace deixis::results
