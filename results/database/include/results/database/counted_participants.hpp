// Which participants count, and why others do not.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace deixis::results {

/// Why somebody is a drop-out who has not agreed, and stops being one by agreeing.
inline constexpr const char* declined_reason = "consent was declined";
/// The same, of somebody who was let in again: the next session asks for consent before anything else.
inline constexpr const char* asked_anew_reason = "consent was declined; it is asked anew";

/// Why somebody is a drop-out whose session the operator ended without saying why.
inline constexpr const char* operator_ended_reason = "the operator ended the session";

/// SQL: whether a participant, given by an expression for the id such as `p.id`, declined one of the study's
/// consents when last asked for it. Looks at nobody else's. The view responses_flat says the same.
[[nodiscard]] std::string declinedConsent(std::string_view participant);

/// SQL in place of the table `participants`, for whatever asks who counts: without consent nobody is active,
/// whatever the table says.
[[nodiscard]] std::string effectiveParticipants();

/// A text as SQL has it.
[[nodiscard]] std::string quotedSql(std::string_view text);

/// Likewise, where of those who are active these, by id, are excluded for the reason given.
[[nodiscard]] std::string effectiveParticipants(const std::map<std::string, std::string>& excluded);

}  // namespace deixis::results
