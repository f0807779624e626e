// Projects that the server keeps.
#include <utility>

#include "kept_json.hpp"
#include "kept_projects.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr const char* projects_path = "/v1/projects";
constexpr const char* project_path = "/v1/projects/{id}";

std::vector<ShapeField> listedFields() {
    return {mustField("id", textShape("", 1)), mustField("name", textShape("", 1)),
            mustField("saved", textShape("UTC, as in 2026-11-28T17:30:12.345Z", 1)),
            mustField("revision", textShape("Of its name and content; also the ETag", 1))};
}

Shape projectShape() {
    return openObjectShape("Any object of at most 16 MiB", {mustField("version", integerShape("", 0, 1e9))});
}

Shape savedProjectShape() {
    return objectShape("", {mustField("name", textShape("", 1, 120)), mustField("project", projectShape())});
}

Route projectRoute(const char* method, const char* path, const char* name, const char* about) {
    Route route;
    route.method = method;
    route.path = path;
    route.name = name;
    route.about = about;
    if (path == project_path) route.path_parts = {{"id", "Of a project that is kept"}};
    return route;
}

Route listRoute(const std::shared_ptr<StudioWork>& work) {
    Route route = projectRoute("GET", projects_path, "projects", "The projects that the server keeps.");
    auto fields = listedFields();
    fields.push_back(mustField("bytes", integerShape("Of its JSON", 1, largest_project)));
    route.outcomes = {
        {200, "Newest first", "application/json",
         objectShape("", {mustField("projects", listShape("", objectShape("", std::move(fields)))),
                          damagedField()})}};
    route.run = [work](const Call&) -> Answer {
        const KeptProjects all = work->folder() ? keptProjects(*work->folder()) : KeptProjects{};
        json projects = json::array();
        for (const KeptProject& one : all.projects)
            projects.push_back({{"id", one.id},
                                {"name", one.name},
                                {"saved", one.saved},
                                {"bytes", one.bytes},
                                {"revision", one.revision}});
        return jsonReply(json{{"projects", std::move(projects)}, {"damaged", damagedJson(all.damaged)}});
    };
    return route;
}

/// Small room is left for what stands around the project.
constexpr std::size_t largest_request = largest_project + (std::size_t{1} << 20U);

Route addRoute(const std::shared_ptr<StudioWork>& work) {
    Route route = projectRoute("POST", projects_path, "add_project", "Keeps a new project.");
    route.body = savedProjectShape();
    route.max_body_bytes = largest_request;
    route.outcomes = {
        {201, "It is on the disk", "application/json",
         objectShape("", {mustField("id", textShape("", 1)), mustField("revision", textShape("", 1))})}};
    route.run = [work](const Call& call) -> Answer {
        if (!work->folder()) return noFolder();
        const auto added = addProject(*work->folder(), call.body["name"], call.body["project"]);
        if (!added) return tl::unexpected(added.error());
        Reply reply = jsonReply(json{{"id", added->id}, {"revision", added->revision}});
        reply.status = 201;
        addRevision(reply, added->revision);
        return reply;
    };
    return route;
}

Route getRoute(const std::shared_ptr<StudioWork>& work) {
    Route route = projectRoute("GET", project_path, "project", "A project as it was kept.");
    auto fields = listedFields();
    fields.push_back(mustField("project", projectShape()));
    route.outcomes = {{200, "The project", "application/json", objectShape("", std::move(fields))}};
    route.run = [work](const Call& call) -> Answer {
        if (!work->folder()) return noFolder();
        const auto found = readProject(*work->folder(), call.path.at("id"));
        if (!found) return tl::unexpected(found.error());
        std::string text = json{
            {"id", found->id},
            {"name", found->name},
            {"saved", found->saved},
            {"revision",
             found->revision}}.dump();
        text.pop_back();  // the project is there as JSON already
        Reply reply = jsonTextReply(text + ",\"project\":" + found->content + "}");
        addRevision(reply, found->revision);
        return reply;
    };
    return route;
}

Route replaceRoute(const std::shared_ptr<StudioWork>& work) {
    Route route = projectRoute("PUT", project_path, "replace_project",
                               "Keeps a project in place of one that is kept, whose revision If-Match names: "
                               "where it is another one by now, nothing is changed (412); without: 428.");
    route.body = savedProjectShape();
    route.max_body_bytes = largest_request;
    route.takes_revision = true;
    route.outcomes = {{200, "It is on the disk", "application/json",
                       objectShape("", {mustField("revision", textShape("The new one", 1))})}};
    route.run = [work](const Call& call) -> Answer {
        if (!work->folder()) return noFolder();
        const auto kept = replaceProject(*work->folder(), call.path.at("id"), call.body["name"],
                                         call.body["project"], call.revision);
        if (!kept) return tl::unexpected(kept.error());
        Reply reply = jsonReply(json{{"revision", kept->revision}});
        addRevision(reply, kept->revision);
        return reply;
    };
    return route;
}

Route deleteRoute(const std::shared_ptr<StudioWork>& work) {
    Route route = projectRoute("DELETE", project_path, "delete_project", "Deletes a project.");
    route.takes_revision = true;
    route.outcomes = {{204, "It is deleted", ""}};
    route.run = [work](const Call& call) -> Answer {
        if (!work->folder()) return noFolder();
        const auto removed = removeProject(*work->folder(), call.path.at("id"), call.revision);
        if (!removed) return tl::unexpected(removed.error());
        return emptyReply();
    };
    return route;
}

}  // namespace

std::vector<Route> projectRoutes(const std::shared_ptr<StudioWork>& work) {
    return {listRoute(work), addRoute(work), getRoute(work), replaceRoute(work), deleteRoute(work)};
}

}  // namespace deixis::server
