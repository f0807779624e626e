// The token of a participant in the table of withdrawals: it does not reveal whose it was, and every copy
// of the participant's rows has it.
#pragma once

#include <optional>
#include <string>

namespace deixis::results {

/// 128 bits from the operating system's source of random numbers, as 32 hexadecimal digits.
[[nodiscard]] std::string drawToken();

/// What is known of a participant who took part before there were tokens, from the moment on in which the
/// first session began: copies of a database updated one by one agree on it.
struct BeforeTokens {
    std::string participant;
    std::optional<double> session_started_utc_s{};  ///< of the first session
    std::optional<double> first_event_time_s{};     ///< of that session's first event
    std::optional<double> first_event_utc_s{};
};

/// The same for the same facts. Who has neither these rows nor a copy of them has to guess three clock
/// readings to find it by the id: see docs/database.md. None if no session has begun yet: the id alone
/// would tell it, and nothing was answered that a copy could hold; the first session then draws it.
[[nodiscard]] std::optional<std::string> tokenFrom(const BeforeTokens& facts);

}  // namespace deixis::results
