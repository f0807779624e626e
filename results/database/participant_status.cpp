#include "results/database/participant_status.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace deixis::results {

namespace {

constexpr std::array<std::string_view, 3> status_names{"active", "excluded", "dropped"};

}  // namespace

std::string_view participantStatusName(ParticipantStatus status) {
    return status_names.at(static_cast<std::size_t>(status));
}

ParticipantStatus participantStatusNamed(std::string_view name) {
    const auto* const found = std::find(status_names.begin(), status_names.end(), name);
    if (found == status_names.end())
        throw std::invalid_argument("unknown participant status: " + std::string(name));
    return static_cast<ParticipantStatus>(found - status_names.begin());
}

}  // namespace deixis::results
