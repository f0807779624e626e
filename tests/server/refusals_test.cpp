// What every request passes before a route sees it: each refusal, over real sockets.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "running_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using httplib::Headers;
using nlohmann::json;

TEST_SUITE("server/refusals") {
    TEST_CASE("Without the token nothing is told, with it everything") {
        const RunningTestServer server;
        auto stranger = server.client(false);
        for (const char* path :
             {"/", "/v1/plain", "/v1/nothing", "/index.html", "/?token=", "/?token=wrong"}) {
            CAPTURE(path);
            const auto answer = stranger.Get(path);
            REQUIRE(answer);
            CHECK(answer->status == 401);
            CHECK(answer->get_header_value("WWW-Authenticate") == "Bearer");
            checkError(answer->body, nullptr);
        }
        const std::string right = test_token;
        for (const std::string& wrong : {right.substr(1), right + "x", std::string("x"), right + " " + right})
            CHECK(stranger.Get("/v1/plain", Headers{{"Authorization", "Bearer " + wrong}})->status == 401);
        CHECK(stranger.Get("/v1/plain", Headers{{"Authorization", "Basic " + right}})->status == 401);
        CHECK(stranger.Get("/v1/plain", Headers{{"Cookie", "deixis_token=" + right + "x"}})->status == 401);
        CHECK(stranger.Get("/v1/plain", Headers{{"Cookie", "other=1; xdeixis_token=" + right}})->status ==
              401);
        CHECK(stranger.Get("/v1/plain?token=" + right)->status == 401);

        CHECK(stranger.Get("/v1/plain", Headers{{"Authorization", "Bearer " + right}})->status == 200);
        CHECK(stranger.Get("/v1/plain", Headers{{"Authorization", "bearer  " + right}})->status == 200);
        CHECK(stranger.Get("/v1/plain", Headers{{"Cookie", "other=1; deixis_token=" + right}})->status ==
              200);
        // Of two of that name, such as another server's on another port of this machine, one suffices.
        CHECK(
            stranger.Get("/v1/plain", Headers{{"Cookie", "deixis_token=1; deixis_token=" + right}})->status ==
            200);
    }

    TEST_CASE("The address with the token sets a cookie and leads to the page") {
        const RunningTestServer server;
        const auto answer = server.client(false).Get(std::string("/?token=") + test_token);
        REQUIRE(answer);
        CHECK(answer->status == 303);
        CHECK(answer->get_header_value("Location") == "/");
        CHECK(answer->get_header_value("Set-Cookie") ==
              std::string("deixis_token=") + test_token + "; Path=/; HttpOnly; SameSite=Strict");
    }

    TEST_CASE("Without a token on the loopback, where none is asked for") {
        const RunningTestServer server{server::ServerSettings{}};
        CHECK(server.client(false).Get("/v1/plain")->status == 200);
        CHECK(server.client(false).Get("/v1/plain", Headers{{"Origin", "http://evil.example"}})->status ==
              403);
    }

    TEST_CASE("Another Host is another server: names that lead here do not open it") {
        const RunningTestServer server;
        auto client = server.client();
        const std::string port = std::to_string(server.http->port());
        for (const std::string& ours :
             {"127.0.0.1:" + port, "localhost:" + port, "LOCALHOST:" + port, "[::1]:" + port})
            CHECK_MESSAGE(client.Get("/v1/plain", Headers{{"Host", ours}})->status == 200, ours);
        for (const std::string& other :
             {"evil.example:" + port, std::string("localhost"),
              "localhost:" + std::to_string(server.http->port() + 1), "localhost.evil.example:" + port,
              "127.0.0.2:" + port, "localhost:" + port + "0", std::string("[::1"),
              "user@localhost:" + port}) {
            CAPTURE(other);
            const auto answer = client.Get("/v1/plain", Headers{{"Host", other}});
            REQUIRE(answer);
            CHECK(answer->status == 421);
            checkError(answer->body, nullptr);
        }
        const std::string line = "GET /v1/plain HTTP/1.1\r\n";
        CHECK(statusOf(server.answerTo(line + "\r\n")) == 400);
        CHECK(statusOf(server.answerTo(line + "Host: " + server.host() + "\r\nHost: evil.example\r\n\r\n")) ==
              400);
    }

    TEST_CASE("Pages of other origins may not ask") {
        const RunningTestServer server;
        auto client = server.client();
        const std::string port = std::to_string(server.http->port());
        for (const std::string& ours : {"http://127.0.0.1:" + port, "http://localhost:" + port})
            CHECK_MESSAGE(client.Get("/v1/plain", Headers{{"Origin", ours}})->status == 200, ours);
        for (const std::string& other :
             {std::string("http://evil.example"), std::string("null"), "https://localhost:" + port,
              std::string("http://localhost"), "http://localhost:" + port + ".evil.example",
              "localhost:" + port, "http://localhost:" + port + "/x", std::string("file://")}) {
            CAPTURE(other);
            const Headers from{{"Origin", other}};
            for (const auto& answer :
                 {client.Get("/v1/plain", from), client.Post("/v1/echo", from, "{}", "application/json"),
                  client.Put("/v1/things/x", from, "{}", "application/json"),
                  client.Delete("/v1/things/x", from)}) {
                REQUIRE(answer);
                CHECK(answer->status == 403);
                checkError(answer->body, nullptr);
            }
        }
    }

    TEST_CASE("Paths and methods") {
        const RunningTestServer server;
        auto client = server.client();
        CHECK(client.Get("/v1/things/a-B_9")->body == R"({"id":"a-B_9"})");
        CHECK(client.Delete("/v1/things/x")->body == R"({"gone":"x"})");
        const auto put = [&](const Headers& headers) {
            const auto answer = client.Put("/v1/things/x", headers, "{}", "application/json");
            REQUIRE(answer);
            CHECK(answer->status == 200);
            CHECK(answer->get_header_value("ETag") == "\"new\"");
            return json::parse(answer->body)["revision"].get<std::string>();
        };
        CHECK(put({}) == "none");
        for (const char* header : {"\"abc\"", "W/\"abc\"", "abc", " \"abc\" "})
            CHECK(put({{"If-Match", header}}) == "abc");
        CHECK(put({{"If-Match", "*"}}) == "*");
        auto stranger = server.client(false);
        CHECK(stranger.Put("/v1/things/x", "{}", "application/json")->status == 401);
        CHECK(stranger.Delete("/v1/things/x")->status == 401);
        CHECK(
            client.Put("/v1/things/x", Headers{{"Host", "evil.example"}}, "{}", "application/json")->status ==
            421);
        CHECK(client.Delete("/v1/things/x", Headers{{"Host", "evil.example"}})->status == 421);
        for (const char* path :
             {"/v1/things/", "/v1/things/a/b", "/v1/things/a.b", "/v1/things/..", "/v1/things/a%2Fb",
              "/v1/plain/", "//v1/plain", "/v1/../v1/plain", "/v1/%70lain", "/V1/plain", "/"}) {
            CAPTURE(path);
            const auto answer = client.Get(path);
            REQUIRE(answer);
            CHECK(answer->status == 404);
            checkError(answer->body, nullptr);
        }
        CHECK(client.Get(("/v1/things/" + std::string(65, 'a')).c_str())->status == 404);
        const auto wrong = client.Post("/v1/things/x", "{}", "application/json");
        CHECK(wrong->status == 405);
        CHECK(wrong->get_header_value("Allow") == "GET, DELETE, PUT");
        checkError(wrong->body, nullptr);
        CHECK(client.Put("/v1/echo", "{}", "application/json")->status == 405);
        CHECK(client.Options("/v1/plain")->status == 405);
        CHECK(client.Get("/v1/plain?x=1")->status == 400);
        const auto head = client.Head("/v1/plain");
        CHECK(head->status == 200);
        CHECK(head->body.empty());
        for (const char* method : {"TRACE", "CONNECT", "PATCH"})
            CHECK_MESSAGE(statusOf(server.answerTo(server.head(std::string(method) + " /v1/plain"))) == 405,
                          method);
        CHECK(statusOf(server.answerTo(server.head("BREW /v1/plain"))) == 400);
    }

    TEST_CASE("Bodies: their type, their size, their form") {
        const RunningTestServer server;
        auto client = server.client();
        CHECK(json::parse(client.Post("/v1/echo", R"({"text":"hi"})", "application/json")->body) ==
              json{{"text", "hi"}, {"seed", 7}});
        CHECK(client.Post("/v1/echo", "{}", "application/json; charset=utf-8")->status == 200);
        for (const char* type :
             {"text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", ""})
            CHECK_MESSAGE(client.Post("/v1/echo", "{}", type)->status == 415, type);
        CHECK(client.Post("/v1/echo", Headers{{"Content-Encoding", "gzip"}}, "{}", "application/json")
                  ->status == 415);

        const auto unknown = client.Post("/v1/echo", R"({"text":"hi","sed":1})", "application/json");
        CHECK(unknown->status == 400);
        checkError(unknown->body, "sed");
        const auto item = client.Post("/v1/echo", R"({"controls":[0,2]})", "application/json");
        CHECK(item->status == 400);
        checkError(item->body, "controls[1]");
        const auto broken = client.Post("/v1/echo", "{", "application/json");
        CHECK(broken->status == 400);
        checkError(broken->body, nullptr);

        const std::string full = R"({"text":")" + std::string(988, ' ') + R"("})";
        CHECK(client.Post("/v1/echo", full + " ", "application/json")->status ==
              400);  // 1000 bytes, the text too long
        const auto large = client.Post("/v1/echo", std::string(1001, ' '), "application/json");
        CHECK(large->status == 413);
        checkError(large->body, nullptr);
        // Far more than the sockets hold: the answer still comes.
        CHECK(client.Post("/v1/echo", std::string(20'000'000, ' '), "application/json")->status == 413);
        CHECK(
            server.client(false).Post("/v1/echo", std::string(20'000'000, ' '), "application/json")->status ==
            401);
        CHECK(client.Get("/v1/plain")->status == 200);
    }

    TEST_CASE("Uploads name their parts") {
        const RunningTestServer server;
        auto client = server.client();
        const std::string sound("RIFF\0\r\n--\xff", 11);
        const auto good =
            client.Post("/v1/upload", httplib::MultipartFormDataItems{
                                          {"text", "héllo", "", ""}, {"sound", sound, "a.wav", "audio/wav"}});
        REQUIRE(good);
        CHECK(json::parse(good->body) == json{{"text", "héllo"}, {"bytes", 11}});
        const auto field = [&](const httplib::MultipartFormDataItems& items, const char* name) {
            const auto answer = client.Post("/v1/upload", items);
            REQUIRE(answer);
            CHECK(answer->status == 400);
            checkError(answer->body, name);
        };
        field({{"text", "a", "", ""}}, "sound");
        field({{"sound", sound, "a.wav", ""}}, "text");
        field({{"text", "", "", ""}, {"sound", sound, "a.wav", ""}}, "text");
        field({{"text", "\xff", "", ""}, {"sound", sound, "a.wav", ""}}, "text");
        field({{"text", "a", "", ""}, {"text", "b", "", ""}, {"sound", sound, "a.wav", ""}}, "text");
        field({{"text", "a", "", ""}, {"sound", sound, "a.wav", ""}, {"extra", "x", "", ""}}, "extra");
        CHECK(client.Post("/v1/upload", "junk", "multipart/form-data; boundary=abc")->status == 400);
        CHECK(client.Post("/v1/upload", "junk", "multipart/form-data")->status == 400);
    }

    TEST_CASE("Requests that could be read in two ways are refused, and end the connection") {
        const RunningTestServer server;
        const std::string post = "POST /v1/echo";
        const std::string type = "Content-Type: application/json\r\n";
        const auto with = [&](const std::string& headers) {
            return server.head(post, type + headers) + "{}";
        };
        const std::string chunks = "2\r\n{}\r\n0\r\n\r\n";
        const std::vector<std::pair<std::string, int>> odd{
            {with("Content-Length: 2\r\nContent-Length: 3\r\n"), 400},
            {with("Content-Length: +2\r\n"), 400},
            {with("Content-Length: -2\r\n"), 400},
            {with("Content-Length: 0x2\r\n"), 400},
            {with("Content-Length: 99999999999999999999\r\n"), 400},
            {with("Content-Length : 2\r\n"), 400},
            {with(" Content-Length: 2\r\n"), 400},
            {with("Content-Length: 2\r\nnothing\r\n"), 400},
            {with("Content-Length: 2\nX: y\r\n"), 400},
            {with("Content-Length: 2\r\nX: a\rb\r\n"), 400},
            {with("Content-Length: 2\r\nX: a" + std::string(1, '\0') + "b\r\n"), 400},
            {with(""), 411},
            {server.head(post, type + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n") + chunks, 411},
            {server.head(post, type + "Transfer-Encoding: chunked\r\n") + chunks, 411},
            {"\r\n\r\n\r\n", 400},
            {"hello\r\n\r\n", 400},
            {"GET / HTTP/3.0\r\n\r\n", 400},
            {"GET http://evil.example/ HTTP/1.1\r\n\r\n", 400},
            {std::string("\x16\x03\x01\x02\x00\r\n\r\n", 9), 400}};
        for (const auto& one : odd) {
            const std::string& bytes = one.first;
            CAPTURE(bytes);
            RawClient raw(server.http->port());
            raw.send(bytes);
            const std::string answer = raw.receiveAll(std::chrono::milliseconds(4000));
            CHECK(statusOf(answer) == one.second);
            CHECK(raw.closed());
            CHECK(answer.find("HTTP/1.1", 1) ==
                  std::string::npos);  // what followed was not taken for a request
        }
        // A body that is refused unread is no next request.
        const std::string hidden = server.head("GET /v1/plain");
        const std::string answer =
            server.answerTo(server.head("POST /v1/nothing",
                                        type + "Content-Length: " + std::to_string(hidden.size()) + "\r\n") +
                            hidden);
        CHECK(statusOf(answer) == 404);
        CHECK(!contains(answer, "\"ok\""));
    }

    TEST_CASE("Heads are limited in all that they have") {
        const RunningTestServer server;
        CHECK(statusOf(server.answerTo(server.head("GET /v1/plain?" + std::string(3000, 'a')))) == 414);
        std::string many;
        for (int i = 0; i < 70; ++i) many += "X-" + std::to_string(i) + ": y\r\n";
        const std::string lines = server.answerTo(server.head("GET /v1/plain", many));
        CHECK(statusOf(lines) == 431);
        CHECK(contains(lines, "Content-Security-Policy: default-src 'self'"));
        checkError(lines.substr(lines.find("\r\n\r\n") + 4), nullptr);
        CHECK(statusOf(server.answerTo(
                  server.head("GET /v1/plain", "X: " + std::string(20'000, 'a') + "\r\n"))) == 431);
        // Without an end.
        CHECK(statusOf(server.answerTo("GET /v1/plain HTTP/1.1\r\nX: " + std::string(100'000, 'a'))) == 431);
        // What the library reads by regular expressions, as long as it may be.
        const std::string ranges = "Range: bytes=0-0" + [] {
            std::string out;
            for (int i = 0; i < 2000; ++i) out += ",1-1";
            return out;
        }() + "\r\n";
        CHECK(statusOf(server.answerTo(server.head("GET /v1/bytes", ranges))) != 0);
        CHECK(statusOf(server.answerTo(server.head("GET /" + std::string(2000, 'a')))) == 404);
        CHECK(server.client().Get("/v1/plain")->status == 200);
    }

    TEST_CASE("Several requests on one connection, and a part of a sound") {
        const RunningTestServer server;
        const std::string two =
            server.answerTo(server.head("GET /v1/things/one") + server.head("GET /v1/things/two"));
        CHECK(contains(two, R"({"id":"one"})"));
        CHECK(contains(two, R"({"id":"two"})"));
        auto client = server.client();
        const auto whole = client.Get("/v1/bytes");
        CHECK(whole->status == 200);
        CHECK(whole->get_header_value("Accept-Ranges") == "bytes");
        const auto part = client.Get("/v1/bytes", Headers{{"Range", "bytes=2-4"}});
        CHECK(part->status == 206);
        CHECK(part->body == "234");
        CHECK(part->get_header_value("Content-Range") == "bytes 2-4/10");
        CHECK(client.Get("/v1/bytes", Headers{{"Range", "bytes=20-30"}})->status == 416);
        CHECK(client.Get("/v1/bytes", Headers{{"Range", "bytes=0-1,3-4"}})->body == "0123456789");
        CHECK(client.Get("/v1/plain", Headers{{"Range", "bytes=2-4"}})->body == R"({"ok":true})");
        CHECK(server.client(false).Get("/v1/bytes", Headers{{"Range", "bytes=2-4"}})->status == 401);
    }

    TEST_CASE("Every answer has the headers that keep the page to itself; what fails inside says so") {
        const RunningTestServer server;
        auto client = server.client();
        for (const char* path : {"/v1/plain", "/v1/nothing", "/v1/throws"}) {
            CAPTURE(path);
            const auto answer = client.Get(path, Headers{{"Accept-Encoding", "gzip, br"}});
            REQUIRE(answer);
            const std::string policy = answer->get_header_value("Content-Security-Policy");
            for (const char* part :
                 {"default-src 'self';", "img-src 'self' blob: data:;", "media-src 'self' blob:;",
                  "connect-src 'self';", "frame-ancestors 'none'"})
                CHECK_MESSAGE(contains(policy, part), part);
            CHECK(answer->get_header_value("X-Content-Type-Options") == "nosniff");
            CHECK(answer->get_header_value("Referrer-Policy") == "no-referrer");
            CHECK(answer->get_header_value("Cache-Control") == "no-store");
            CHECK(answer->get_header_value("Content-Type") == "application/json");
            CHECK(!answer->has_header("Access-Control-Allow-Origin"));
        }
        const auto failed = client.Get("/v1/throws");
        CHECK(failed->status == 500);
        checkError(failed->body, nullptr);
        CHECK(contains(failed->body, "it broke"));
    }
}
