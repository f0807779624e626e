#include "results/database/participant_token.hpp"

#include <fmt/core.h>

#include <random>

#include "core/hash.hpp"

namespace deixis::results {

std::string drawToken() {
    std::random_device system;  // getrandom(2) or the like: no state, no seed
    std::string out;
    for (int words = 0; words < 4; ++words) out += fmt::format("{:08x}", system());
    return out;
}

std::optional<std::string> tokenFrom(const BeforeTokens& facts) {
    if (!facts.session_started_utc_s) return std::nullopt;
    constexpr std::size_t digits = 32;
    // The shortest text that reads back as the number: the same for SQLite's double and PostgreSQL's.
    const auto text = [](const std::optional<double>& number) {
        return number ? fmt::format("{}", *number) : std::string("none");
    };
    return sha256Hex(fmt::format("participant token of version 5\n{}\n{}\n{}\n{}", facts.participant,
                                 text(facts.session_started_utc_s), text(facts.first_event_time_s),
                                 text(facts.first_event_utc_s)))
        .substr(0, digits);
}

}  // namespace deixis::results
