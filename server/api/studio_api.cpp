#include "server/api/studio_api.hpp"

#include <memory>
#include <utility>

#include "openapi.hpp"
#include "studio_work.hpp"

namespace deixis::server {

Route healthRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "GET";
    route.path = "/v1/health";
    route.name = "health";
    route.about = "That the server runs, and what it can do.";
    const Shape names = listShape("The first is taken where none is named", textShape("", 1));
    route.outcomes = {
        {200, "It runs", "application/json",
         objectShape(
             "", {mustField("status", choiceShape("", {"ok"})),
                  mustField("version", textShape("Of the program", 1)),
                  mustField("commit", textShape("Of the program's sources", 1)), mustField("systems", names),
                  mustField("voices", names),
                  mustField("synthetic",
                            booleanShape("Gestures are by rules, or by what was trained on them"))})}};
    const Reply reply = jsonReply(nlohmann::ordered_json{{"status", "ok"},
                                                         {"version", work->parts().version},
                                                         {"commit", work->parts().commit},
                                                         {"systems", gestureSystems()},
                                                         {"voices", work->parts().voices.names()},
                                                         {"synthetic", true}});
    route.run = [reply](const Call&) -> Answer { return reply; };
    return route;
}

namespace {

/// Last, since it describes all of them and itself.
void addDocument(std::vector<Route>& routes, const std::string& version) {
    Route route;
    route.method = "GET";
    route.path = "/v1/openapi.json";
    route.name = "openapi";
    route.about = "This document.";
    route.outcomes = {{200, "OpenAPI 3.1", "application/json"}};
    routes.push_back(route);
    const Reply reply = jsonReply(openApiDocument(routes, version));
    routes.back().run = [reply](const Call&) -> Answer { return reply; };
}

void append(std::vector<Route>& routes, std::vector<Route> more) {
    for (Route& route : more) routes.push_back(std::move(route));
}

}  // namespace

std::vector<Route> studioRoutes(StudioParts parts) {
    const std::string version = parts.version;
    const auto work = std::make_shared<StudioWork>(std::move(parts));
    std::vector<Route> routes{healthRoute(work)};
    routes.push_back(generateRoute(work));
    append(routes, speechRoutes(work));
    append(routes, libraryRoutes(work));
    append(routes, clipRoutes());
    addDocument(routes, version);
    return routes;
}

}  // namespace deixis::server
