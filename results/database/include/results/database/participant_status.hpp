// Whether a participant's answers count.
#pragma once

#include <cstdint>
#include <string_view>

namespace deixis::results {

enum class ParticipantStatus : std::uint8_t {
    active,
    excluded,
    dropped  ///< of their own accord or the operator's, or without consent
};

/// "active", "excluded", "dropped", as databases have it.
[[nodiscard]] std::string_view participantStatusName(ParticipantStatus status);
/// Throws std::invalid_argument for any other name: databases hold no others.
[[nodiscard]] ParticipantStatus participantStatusNamed(std::string_view name);

}  // namespace deixis::results
