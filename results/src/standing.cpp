#include "standing.hpp"

#include <fmt/core.h>

#include "results/participants.hpp"

namespace deixis::results {

std::string participantsStanding() {
    return fmt::format(
        "(SELECT id, number, language, registered_utc_s, "
        "iif(status = 'active' AND id IN ({0}), 'dropped', status) AS status, "
        "iif(status = 'active' AND id IN ({0}), '{1}', reason) AS reason FROM participants)",
        refusing_participants, declined_reason);
}

}  // namespace deixis::results
