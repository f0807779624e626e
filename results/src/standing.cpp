#include "standing.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

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

std::string participantsStanding(const std::map<std::string, std::string>& excluded) {
    if (excluded.empty()) return participantsStanding();
    std::string quoted;
    for (const char c : nlohmann::json(excluded).dump()) quoted += c == '\'' ? "''" : std::string(1, c);
    return fmt::format(
        "(SELECT p.id, p.number, p.language, p.registered_utc_s, "
        "iif(p.status = 'active' AND x.key IS NOT NULL, 'excluded', p.status) AS status, "
        "iif(p.status = 'active' AND x.key IS NOT NULL, x.value, p.reason) AS reason "
        "FROM {} AS p LEFT JOIN json_each('{}') AS x ON x.key = p.id)",
        participantsStanding(), quoted);
}

}  // namespace deixis::results
