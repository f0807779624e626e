// What goes over the wire compressed, unpacked by the programs gzip and, where it is there, brotli.
#include "server/http/http_server.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "app/program.hpp"
#include "running_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using httplib::Headers;

namespace {

/// As it came, without the client's unpacking.
httplib::Result raw(const RunningTestServer& server, const std::string& path, const Headers& headers) {
    auto client = server.client();
    client.set_decompress(false);
    return client.Get(path, headers);
}

/// Many words that are alike.
std::string longText() {
    std::string out;
    for (int i = 0; i < 20'000; ++i)
        out += "export const number" + std::to_string(i) + " = " + std::to_string(i * i);
    return out;
}

std::string unpacked(const std::string& command, const std::string& bytes) {
    const Scratch scratch;
    spill(scratch / "packed", bytes);
    return shell(command + " < " + (scratch / "packed")).out;
}

}  // namespace

TEST_SUITE("server/compression") {
    TEST_CASE("The page's files come as their reader takes them") {
        const Scratch scratch;
        const std::string text = longText();
        spill(scratch / "pages/app.js", text);
        spill(scratch / "pages/small.js", "1;");
        spill(scratch / "pages/picture.png", text);
        auto settings = RunningTestServer::withToken();
        settings.pages = scratch / "pages";
        const RunningTestServer server{settings};
        const auto coded = [&](const std::string& path, const std::string& accepted) {
            const auto answer = raw(server, path, {{"Accept-Encoding", accepted}});
            REQUIRE(answer);
            CHECK(answer->status == 200);
            CHECK(answer->get_header_value("Vary") == "Accept-Encoding");
            CHECK(answer->get_header_value("Content-Length") == std::to_string(answer->body.size()));
            return std::pair(answer->get_header_value("Content-Encoding"), answer->body);
        };
        const auto gzip = coded("/app.js", "gzip, deflate");
        CHECK(gzip.first == "gzip");
        CHECK(gzip.second.size() < text.size() / 3);
        CHECK(unpacked("gzip -dc", gzip.second) == text);
        const auto brotli = coded("/app.js", "gzip, deflate, br");
        CHECK(brotli.first == "br");
        CHECK(brotli.second.size() < gzip.second.size());
        if (shell("brotli --version").status == 0)
            CHECK(unpacked("brotli -dc", brotli.second) == text);
        else  // the client of cpp-httplib has Brotli, too
            CHECK(server.client().Get("/app.js", Headers{{"Accept-Encoding", "br"}})->body == text);
        for (const char* none :
             {"", "identity", "deflate", "gzip;q=0", "gzip; Q=0.0, br ;q=0", "xgzip", "gzipx", "*"})
            CHECK_MESSAGE(coded("/app.js", none) == std::pair(std::string(), text), none);
        for (const char* some : {"gzip;q=0.1", "GZIP", " gzip ,x", "br;q=0,gzip"})
            CHECK_MESSAGE(coded("/app.js", some).first == "gzip", some);
        CHECK(coded("/small.js", "gzip, br").first.empty());
        CHECK(coded("/picture.png", "gzip, br").first.empty());

        // Each form has its own tag.
        const auto tag = [&](const std::string& accepted) {
            return raw(server, "/app.js", {{"Accept-Encoding", accepted}})->get_header_value("ETag");
        };
        CHECK(tag("gzip") != tag("br"));
        CHECK(tag("gzip") != tag(""));
        const auto asked = [&](const std::string& accepted, const std::string& known) {
            return raw(server, "/app.js", {{"Accept-Encoding", accepted}, {"If-None-Match", known}})->status;
        };
        CHECK(asked("gzip", tag("gzip")) == 304);
        CHECK(asked("gzip", tag("br")) == 200);
        CHECK(asked("", tag("gzip")) == 200);
        auto client = server.client();
        client.set_decompress(false);
        CHECK(client.Head("/app.js", Headers{{"Accept-Encoding", "gzip"}})
                  ->get_header_value("Content-Length") == std::to_string(gzip.second.size()));
    }

    TEST_CASE("Long answers of routes are compressed, short ones, refusals and sounds are not") {
        RunningTestServer server;
        server.routes.letGo();
        const Headers takes{{"Accept-Encoding", "gzip"}};
        const auto long_one = raw(server, "/v1/wait", takes);
        REQUIRE(long_one);
        CHECK(long_one->get_header_value("Content-Encoding") == "gzip");
        CHECK(long_one->body.size() < 100'000);
        CHECK(unpacked("gzip -dc", long_one->body) ==
              raw(server, "/v1/wait", {{"Accept-Encoding", ""}})->body);
        // Of two the one that takes less time.
        CHECK(raw(server, "/v1/wait", {{"Accept-Encoding", "br, gzip"}})
                  ->get_header_value("Content-Encoding") == "gzip");
        CHECK(raw(server, "/v1/wait", {{"Accept-Encoding", "br"}})->get_header_value("Content-Encoding") ==
              "br");
        CHECK(raw(server, "/v1/plain", takes)->get_header_value("Content-Encoding").empty());
        CHECK(raw(server, "/v1/nothing", takes)->get_header_value("Content-Encoding").empty());
        const auto sound = raw(server, "/v1/bytes", {{"Accept-Encoding", "gzip"}, {"Range", "bytes=2-4"}});
        CHECK(sound->status == 206);
        CHECK(sound->body == "234");
    }
}
