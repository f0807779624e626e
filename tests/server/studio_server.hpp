// The studio's server with the library that ships, as tests of its routes start it.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "assets/data/unit_gestures.hpp"
#include "paths.hpp"
#include "running_server.hpp"
#include "server/api/studio_api.hpp"

namespace deixis::tests {

/// A voice like a machine, which is quick.
inline constexpr const char* quick_voice = "kal16";

inline server::StudioParts studioParts() {
    auto library = assets::loadUnitGestures(sourceDir() / "assets/data/unit_gestures.toml");
    REQUIRE_MESSAGE(library.has_value(), (library ? "" : library.error().text()));
    server::StudioParts parts;
    parts.version = "1.2.3";
    parts.commit = "0123abc";
    parts.library = std::move(*library);
    return parts;
}

/// With a folder to keep things in.
inline server::StudioParts studioPartsIn(const std::filesystem::path& folder) {
    auto parts = studioParts();
    auto kept = server::KeptFolder::open(folder, server::KeptFolder::Make::now);
    REQUIRE_MESSAGE(kept.has_value(), (kept ? "" : kept.error().text()));
    parts.folder = std::move(*kept);
    return parts;
}

struct StudioServer {
    explicit StudioServer(server::StudioParts parts = studioParts()) {
        auto started =
            server::HttpServer::start(RunningTestServer::withToken(), server::studioRoutes(std::move(parts)));
        REQUIRE_MESSAGE(started.has_value(), (started ? "" : started.error().text()));
        http = std::move(*started);
    }

    [[nodiscard]] httplib::Client client() const {
        httplib::Client client("127.0.0.1", http->port());
        client.set_bearer_token_auth(test_token);
        client.set_read_timeout(120);
        client.set_keep_alive(true);
        return client;
    }
    struct Answered {
        int status = 0;
        nlohmann::json body{};
        [[nodiscard]] nlohmann::json field() const { return body["error"]["field"]; }
        [[nodiscard]] std::string message() const { return body["error"]["message"]; }
    };
    [[nodiscard]] Answered post(const std::string& path, const nlohmann::json& body) const {
        const auto answer = client().Post(path, body.dump(), "application/json");
        REQUIRE(answer);
        return {answer->status, nlohmann::json::parse(answer->body, nullptr, false)};
    }
    /// `revision`: of If-Match; empty: none.
    [[nodiscard]] Answered put(const std::string& path, const nlohmann::json& body,
                               const std::string& revision = "") const {
        httplib::Headers headers;
        if (!revision.empty()) headers.emplace("If-Match", '"' + revision + '"');
        const auto answer = client().Put(path, headers, body.dump(), "application/json");
        REQUIRE(answer);
        return {answer->status, nlohmann::json::parse(answer->body, nullptr, false)};
    }
    [[nodiscard]] Answered remove(const std::string& path, const std::string& revision = "") const {
        httplib::Headers headers;
        if (!revision.empty()) headers.emplace("If-Match", '"' + revision + '"');
        const auto answer = client().Delete(path, headers);
        REQUIRE(answer);
        return {answer->status, nlohmann::json::parse(answer->body, nullptr, false)};
    }
    [[nodiscard]] Answered ask(const std::string& path) const {
        const auto answer = client().Get(path);
        REQUIRE(answer);
        return {answer->status, nlohmann::json::parse(answer->body, nullptr, false)};
    }
    [[nodiscard]] nlohmann::json get(const std::string& path) const {
        const auto answer = client().Get(path);
        REQUIRE(answer);
        REQUIRE_MESSAGE(answer->status == 200, answer->body);
        return nlohmann::json::parse(answer->body);
    }

    std::unique_ptr<server::HttpServer> http;
};

}  // namespace deixis::tests
