#include "server/api/studio_api.hpp"

#include <memory>
#include <utility>

#include "openapi.hpp"
#include "studio_work.hpp"

namespace deixis::server {

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
    std::vector<Route> of_session;
    if (parts.session) of_session = std::move(parts.session->routes);
    const auto work = std::make_shared<StudioWork>(std::move(parts));
    std::vector<Route> routes{healthRoute(work)};
    routes.push_back(generateRoute(work));
    append(routes, speechRoutes(work));
    append(routes, libraryRoutes(work));
    routes.push_back(readRoute());
    append(routes, ruleRoutes(work));
    append(routes, projectRoutes(work));
    append(routes, clipRoutes(work));
    routes.push_back(pointRoute(work));
    append(routes, std::move(of_session));
    addDocument(routes, version);
    return routes;
}

}  // namespace deixis::server
