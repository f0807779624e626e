#include "results/database/counted_participants.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace deixis::results {

std::string declinedConsent(std::string_view participant) {
    return fmt::format(
        "EXISTS (SELECT 1 FROM consents AS c WHERE c.participant = {} AND c.agreed = 0 AND c.session = "
        "(SELECT "
        "max(o.session) FROM consents AS o WHERE o.participant = c.participant AND o.stage = c.stage))",
        participant);
}

std::string effectiveParticipants() {
    return fmt::format(
        "(SELECT id, number, language, registered_utc_s, "
        "iif(status = 'active' AND {0}, 'dropped', status) AS status, "
        "iif(status = 'active' AND {0}, '{1}', reason) AS reason FROM participants)",
        declinedConsent("participants.id"), declined_reason);
}

std::string quotedSql(std::string_view text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
    return out + "'";
}

std::string effectiveParticipants(const std::map<std::string, std::string>& excluded) {
    if (excluded.empty()) return effectiveParticipants();
    const std::string by_id = quotedSql(nlohmann::json(excluded).dump());
    return fmt::format(
        "(SELECT id, number, language, registered_utc_s, "
        "iif(status = 'active' AND id IN (SELECT key FROM json_each({1})), 'excluded', status) AS status, "
        "iif(status = 'active' AND id IN (SELECT key FROM json_each({1})), "
        "(SELECT value FROM json_each({1}) WHERE key = p.id), reason) AS reason FROM {0} AS p)",
        effectiveParticipants(), by_id);
}

}  // namespace deixis::results
