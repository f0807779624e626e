#include "standing.hpp"

#include <fmt/core.h>

#include "results/participants.hpp"

namespace deixis::results {

std::string refusedConsent(std::string_view participant) {
    return fmt::format(
        "EXISTS (SELECT 1 FROM consents AS c WHERE c.participant = {} AND c.agreed = 0 AND c.session = "
        "(SELECT "
        "max(o.session) FROM consents AS o WHERE o.participant = c.participant AND o.stage = c.stage))",
        participant);
}

std::string participantsStanding() {
    return fmt::format(
        "(SELECT id, number, language, registered_utc_s, "
        "iif(status = 'active' AND {0}, 'dropped', status) AS status, "
        "iif(status = 'active' AND {0}, '{1}', reason) AS reason FROM participants)",
        refusedConsent("participants.id"), declined_reason);
}

}  // namespace deixis::results
