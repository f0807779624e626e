#include "server/session/session_routes.hpp"

#include <chrono>
#include <utility>

#include "session_shapes.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;
using Kind = SessionRequest::Kind;
using Desk = std::shared_ptr<SessionDesk>;
using std::chrono::steady_clock;

constexpr auto page_time = std::chrono::seconds(10);
constexpr auto answer_time = std::chrono::seconds(5);  // a machine that is busy may stand still for long
constexpr std::size_t largest_work = std::size_t{16} << 20U;

Route sessionRoute(const char* method, const char* path, const char* name, const char* about) {
    Route route;
    route.method = method;
    route.path = path;
    route.name = name;
    route.about = about;
    return route;
}

Route pageRoute(const Desk& desk) {
    Route route = sessionRoute("GET", "/v1/session", "session",
                               "What the session shows: at once where it is another revision than `after`, "
                               "else as soon as it is one, "
                               "else after 10 s. Several pages of one session are shown the same.");
    route.query = {mayField("after", integerShape("The revision that is known", 0, 9e15), 0)};
    route.outcomes = {{200, "What is shown", "application/json", sessionShape()}};
    route.run = [desk](const Call& call) -> Answer {
        return jsonTextReply(sessionJson(
            desk->wait(call.query["after"].get<std::uint64_t>(), steady_clock::now() + page_time)));
    };
    return route;
}

/// Whose answer is the revision.
Route actRoute(const Desk& desk, Route route, std::function<SessionRequest(const json&)> read) {
    route.outcomes = {{200, "The session has answered to it", "application/json", revisionAnswer()}};
    route.run = [desk, read = std::move(read)](const Call& call) -> Answer {
        const auto page = desk->ask(read(call.body), steady_clock::now() + answer_time);
        if (!page) return tl::unexpected(page.error());
        return jsonReply(json{{"revision", page->revision}});
    };
    return route;
}

SessionRequest onBoard(Kind kind, const json& body, const char* id) {
    SessionRequest request;
    request.kind = kind;
    request.revision = body["revision"];
    request.id = body[id];
    return request;
}

SessionRequest workOf(Kind kind, const json& body) {
    SessionRequest request;
    request.kind = kind;
    request.trial = body["trial"];
    request.text = body["project"].dump();
    for (const json& edit : body["edits"]) request.edits.push_back({edit["at_s"], edit.dump()});
    request.generated = body["generated"];
    return request;
}

Route pressRoute(const Desk& desk) {
    Route route = sessionRoute("POST", "/v1/session/press", "press",
                               "Presses a button of the board. 409: the board is another one by now, or the "
                               "button cannot be pressed.");
    route.body = objectShape("", {revisionField(), mustField("button", integerShape("Its id", 0, 1e9))});
    return actRoute(desk, std::move(route),
                    [](const json& body) { return onBoard(Kind::press, body, "button"); });
}

Route slideRoute(const Desk& desk) {
    Route route =
        sessionRoute("POST", "/v1/session/slide", "slide", "Sets a slider of the board. 409: as of press.");
    route.body = objectShape("", {revisionField(), mustField("slider", integerShape("Its id", 0, 1e9)),
                                  mustField("value", integerShape("", -1e9, 1e9))});
    return actRoute(desk, std::move(route), [](const json& body) {
        SessionRequest request = onBoard(Kind::slide, body, "slider");
        request.value = body["value"];
        return request;
    });
}

Route typeRoute(const Desk& desk) {
    Route route = sessionRoute("POST", "/v1/session/type", "type",
                               "What a field of the board is to say. 409: as of press.");
    route.body = objectShape("", {revisionField(), mustField("field", integerShape("Its id", 0, 1e9)),
                                  mustField("text", textShape("All of it", 0, 500))});
    return actRoute(desk, std::move(route), [](const json& body) {
        SessionRequest request = onBoard(Kind::type, body, "field");
        request.text = body["text"];
        return request;
    });
}

Route workRoute(const Desk& desk) {
    Route route =
        sessionRoute("PUT", "/v1/session/work", "work",
                     "Tells what was authored, also while the session is paused. 409: another trial "
                     "is under way.");
    route.body = objectShape("", workFields());
    route.max_body_bytes = largest_work;
    route.outcomes = {{200, "It is taken", "application/json",
                       objectShape("", {mustField("left_s", numberShape("Of the trial's time", 0.0))})}};
    route.run = [desk](const Call& call) -> Answer {
        const auto page = desk->ask(workOf(Kind::work, call.body), steady_clock::now() + answer_time);
        if (!page) return tl::unexpected(page.error());
        return jsonReply(json{{"left_s", page->shown.left_s}});
    };
    return route;
}

Route finishRoute(const Desk& desk) {
    Route route =
        sessionRoute("POST", "/v1/session/finish", "finish",
                     "Tells what was authored, and ends the trial. 409: another trial is under way, "
                     "this one may not end early yet, or it is paused.");
    route.body = objectShape("", workFields());
    route.max_body_bytes = largest_work;
    return actRoute(desk, std::move(route), [](const json& body) { return workOf(Kind::finish, body); });
}

Route pauseRoute(const Desk& desk) {
    Route route = sessionRoute("POST", "/v1/session/pause", "pause",
                               "Pauses the session: a board says so, and has a button to go on.");
    route.body = objectShape("", {});
    return actRoute(desk, std::move(route), [](const json&) { return SessionRequest{}; });
}

}  // namespace

std::vector<Route> sessionRoutes(const std::shared_ptr<SessionDesk>& desk) {
    return {pageRoute(desk), pressRoute(desk),  slideRoute(desk), typeRoute(desk),
            workRoute(desk), finishRoute(desk), pauseRoute(desk)};
}

}  // namespace deixis::server
