// Who counts.
#pragma once

#include <string>
#include <string_view>

namespace deixis::results {

/// SQL: whether a participant, given by an expression for the id such as `p.id`, refused one of the study's
/// consents when last asked for it. Looks at nobody else's. The view responses_flat says the same.
[[nodiscard]] std::string refusedConsent(std::string_view participant);

/// SQL in place of the table `participants`, for whatever asks who counts: without consent nobody is active,
/// whatever the table says.
[[nodiscard]] std::string participantsStanding();

}  // namespace deixis::results
