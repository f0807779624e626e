// Rules from words to motions, as people want them.
#include "kept_json.hpp"
#include "own_rules.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

Reply rulesReply(const OwnRules& rules) {
    Reply reply = jsonReply(json{{"rules", ownRulesJson(rules.rules)},
                                 {"revision", rules.revision},
                                 {"damaged", damagedJson(rules.damaged)}});
    addRevision(reply, rules.revision);
    return reply;
}

Outcome rulesOutcome() {
    return {200, "The rules as they are", "application/json",
            objectShape(
                "", {mustField("rules", ownRulesShape()),
                     mustField("revision", textShape("Of these rules; also the ETag", 1)), damagedField()})};
}

}  // namespace

std::vector<Route> ruleRoutes(const std::shared_ptr<StudioWork>& work) {
    Route get;
    get.method = "GET";
    get.path = "/v1/rules";
    get.name = "rules";
    get.about = "Which motions go with which words, as people want it: before the program's own rules.";
    get.outcomes = {rulesOutcome()};
    get.run = [work](const Call&) -> Answer { return rulesReply(work->ownRules()); };
    Route put = get;
    put.method = "PUT";
    put.name = "replace_rules";
    put.about =
        "All rules anew. Where If-Match names another revision than they are of, nothing is changed (412).";
    put.body = objectShape("", {mustField("rules", ownRulesShape()),
                                mayField("revision", textShape("Where If-Match is not sent", 1, 64))});
    put.max_body_bytes = std::size_t{8} << 20U;
    put.takes_revision = true;
    put.run = [work](const Call& call) -> Answer {
        if (!work->folder()) return noFolder();
        auto revision = call.revision;
        if (!revision && call.body.contains("revision")) revision = call.body["revision"].get<std::string>();
        const auto rules = replaceOwnRules(*work->folder(), work->motionIds(), call.body["rules"], revision);
        if (!rules) return tl::unexpected(rules.error());
        return rulesReply(*rules);
    };
    return {get, put};
}

}  // namespace deixis::server
