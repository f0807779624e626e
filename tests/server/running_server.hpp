// A real server on a free port, and its clients.
#pragma once

#include <doctest/doctest.h>
#include <httplib.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/http/http_server.hpp"
#include "server/raw_client.hpp"

#undef _res  // of <resolv.h>, which httplib.h includes; Eigen has parameters of this name

namespace deixis::tests {

inline constexpr const char* test_token = "0123456789abcdef-test";

/// Routes to try the server by: /v1/plain, /v1/echo (JSON), /v1/upload (a form), /v1/things/{id}, /v1/bytes,
/// which may be asked for in parts, and /v1/wait, which answers, at length, when it is let go.
class TestRoutes {
  public:
    [[nodiscard]] std::vector<server::Route> all() {
        using namespace server;
        std::vector<Route> routes;
        routes.push_back(plain("GET", "/v1/plain", [](const Call&) {
            return jsonReply(nlohmann::json{{"ok", true}});
        }));
        routes.push_back(plain("GET", "/v1/things/{id}", [](const Call& call) {
            return jsonReply(nlohmann::json{{"id", call.path.at("id")}});
        }));
        routes.push_back(plain("DELETE", "/v1/things/{id}", [](const Call& call) {
            return jsonReply(nlohmann::json{{"gone", call.path.at("id")}});
        }));
        Route put = plain("PUT", "/v1/things/{id}", [](const Call& call) {
            Reply reply = jsonReply(
                nlohmann::json{{"put", call.path.at("id")}, {"revision", call.revision.value_or("none")}});
            addRevision(reply, "new");
            return Answer(reply);
        });
        put.body = objectShape("", {});
        put.takes_revision = true;
        routes.push_back(put);
        routes.push_back(plain("GET", "/v1/bytes", [](const Call&) {
            Reply reply;
            reply.content_type = "audio/wav";
            reply.bytes = std::make_shared<const std::string>("0123456789");
            return Answer(reply);
        }));
        routes.back().in_parts = true;
        routes.push_back(plain("GET", "/v1/wait", [this](const Call&) {
            std::unique_lock lock(mutex_);
            ++waiting_;
            changed_.notify_all();
            changed_.wait(lock, [this] { return let_go_; });
            return jsonReply(nlohmann::json{{"waited", true}, {"much", std::string(8'000'000, 'x')}});
        }));
        routes.push_back(
            plain("GET", "/v1/throws", [](const Call&) -> Answer { throw std::runtime_error("it broke"); }));
        Route echo = plain("POST", "/v1/echo", [](const Call& call) { return jsonReply(call.body); });
        echo.body = objectShape(
            "", {mayField("text", textShape("", 1, 10)), mayField("seed", integerShape("", 0, 100), 7),
                 mayField("controls", listShape("", numberShape("", -1.0, 1.0), 0, 3))});
        echo.max_body_bytes = 1000;
        routes.push_back(echo);
        Route upload = plain("POST", "/v1/upload", [](const Call& call) {
            return jsonReply(
                nlohmann::json{{"text", call.form->at("text")}, {"bytes", call.form->at("sound").size()}});
        });
        upload.form = {{"text", textShape("", 1, 20)}, {"sound", textShape(""), true, true, "audio/wav"}};
        upload.max_form_bytes = 100'000;
        routes.push_back(upload);
        return routes;
    }

    void waitFor(int count) {
        std::unique_lock lock(mutex_);
        REQUIRE(changed_.wait_for(lock, std::chrono::seconds(20), [&] { return waiting_ >= count; }));
    }
    void letGo() {
        const std::lock_guard lock(mutex_);
        let_go_ = true;
        changed_.notify_all();
    }

  private:
    template <class Run>
    static server::Route plain(const char* method, const char* path, Run run) {
        server::Route route;
        route.method = method;
        route.path = path;
        route.run = [run](const server::Call& call) -> server::Answer { return run(call); };
        return route;
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    int waiting_ = 0;
    bool let_go_ = false;
};

struct RunningTestServer {
    explicit RunningTestServer(server::ServerSettings settings = withToken()) {
        auto started = server::HttpServer::start(settings, routes.all());
        REQUIRE_MESSAGE(started.has_value(), (started ? "" : started.error().text()));
        http = std::move(*started);
    }

    [[nodiscard]] static server::ServerSettings withToken() {
        server::ServerSettings settings;
        settings.token = test_token;
        return settings;
    }
    [[nodiscard]] httplib::Client client(bool with_token = true) const {
        httplib::Client client("127.0.0.1", http->port());
        if (with_token) client.set_bearer_token_auth(test_token);
        client.set_keep_alive(true);
        client.set_read_timeout(20);
        return client;
    }
    [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(http->port()); }
    /// A request's head up to the empty line, with token and Host.
    [[nodiscard]] std::string head(const std::string& line, const std::string& more = "") const {
        return line + " HTTP/1.1\r\nHost: " + host() + "\r\nAuthorization: Bearer " + test_token + "\r\n" +
               more + "\r\n";
    }
    /// The answer to any bytes.
    [[nodiscard]] std::string answerTo(const std::string& bytes) const {
        RawClient raw(http->port());
        raw.send(bytes);
        return raw.receiveAll(std::chrono::milliseconds(400));
    }

    TestRoutes routes;
    std::unique_ptr<server::HttpServer> http;
};

/// The one form of errors.
inline void checkError(const std::string& body, const nlohmann::json& field) {
    const auto json = nlohmann::json::parse(body, nullptr, false);
    REQUIRE_MESSAGE(json.is_object(), body);
    CHECK(json.size() == 1);
    REQUIRE(json["error"].is_object());
    CHECK(json["error"].size() == 2);
    CHECK(!json["error"]["message"].get<std::string>().empty());
    CHECK(json["error"]["field"] == field);
}

}  // namespace deixis::tests
