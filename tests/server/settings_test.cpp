// What a server may be started with, the page's files, and TLS.
#include <doctest/doctest.h>
#include <openssl/ssl.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "app/program.hpp"
#include "running_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using server::HttpServer;
using server::ServerSettings;

namespace {

std::string settingsProblem(const ServerSettings& settings) {
    const auto checked = server::checkSettings(settings);
    return checked ? "" : checked.error().text();
}

/// A certificate for localhost, signed by itself, made by the openssl program.
ServerSettings withCertificate(const Scratch& folder) {
    auto settings = RunningTestServer::withToken();
    settings.certificate = folder / "cert.pem";
    settings.key = folder / "key.pem";
    const auto made =
        shell("openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj " +
              std::string("/CN=localhost -addext subjectAltName=DNS:localhost,IP:127.0.0.1 -keyout ") +
              settings.key.string() + " -out " + settings.certificate.string());
    REQUIRE_MESSAGE(made.status == 0, made.err);
    return settings;
}

}  // namespace

TEST_SUITE("server/settings") {
    TEST_CASE("Addresses that other machines reach need TLS or a proxy, and a token") {
        auto settings = RunningTestServer::withToken();
        for (const char* address : {"127.0.0.1", "127.1.2.3", "::1"}) {
            settings.address = address;
            CHECK(settingsProblem(settings) == "");
        }
        for (const char* address : {"0.0.0.0", "::", "192.0.2.1", "2001:db8::1", "::ffff:127.0.0.1"}) {
            CAPTURE(address);
            auto open = settings;
            open.address = address;
            CHECK(contains(settingsProblem(open), "needs TLS"));
            open.behind_proxy = true;
            CHECK(settingsProblem(open) == "");
            open.behind_proxy = false;
            open.certificate = open.key = "x.pem";
            CHECK(settingsProblem(open) == "");
            open.token = "short";
            CHECK(contains(settingsProblem(open), "token"));
            open.token.clear();
            CHECK(contains(settingsProblem(open), "token"));
        }
        settings.token.clear();
        CHECK(settingsProblem(settings) == "");
        settings.behind_proxy = true;  // the proxy brings others to the loopback
        CHECK(contains(settingsProblem(settings), "token"));
        const auto wrong = [](auto change) {
            auto one = RunningTestServer::withToken();
            change(one);
            return settingsProblem(one);
        };
        CHECK(contains(wrong([](auto& s) { s.address = "localhost"; }), "address in numbers"));
        CHECK(contains(wrong([](auto& s) { s.port = 65536; }), "65535"));
        CHECK(contains(wrong([](auto& s) { s.key = "k"; }), "certificate: is missing"));
        CHECK(contains(wrong([](auto& s) { s.certificate = "c"; }), "key: is missing"));
        CHECK(contains(wrong([](auto& s) { s.token = "a b"; }), "token"));
        CHECK(contains(wrong([](auto& s) { s.token = "a;b"; }), "token"));
        CHECK(contains(wrong([](auto& s) { s.hosts = {"http://x"}; }), "hosts"));
    }

    TEST_CASE("New tokens are of 128 bits and never the same") {
        std::set<std::string> tokens;
        for (int i = 0; i < 1000; ++i) {
            const std::string token = server::newToken();
            CHECK(token.size() == 32);
            CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
            tokens.insert(token);
        }
        CHECK(tokens.size() == 1000);
    }

    TEST_CASE("A port in use is one clear error") {
        const RunningTestServer server;
        auto settings = RunningTestServer::withToken();
        settings.port = server.http->port();
        const auto second = HttpServer::start(settings, {});
        REQUIRE(!second);
        CHECK(contains(second.error().text(), server.host() + ": another program listens on this port"));
    }

    TEST_CASE("A proxy's name counts in Host and Origin") {
        auto settings = RunningTestServer::withToken();
        settings.behind_proxy = true;
        settings.hosts = {"Studio.example.org"};
        const RunningTestServer server{settings};
        auto client = server.client();
        using httplib::Headers;
        const auto status = [&](const Headers& headers) { return client.Get("/v1/plain", headers)->status; };
        CHECK(status({{"Host", "studio.example.org"}}) == 200);
        CHECK(status({{"Host", "studio.example.org"}, {"Origin", "https://studio.example.org"}}) == 200);
        CHECK(status({{"Host", server.host()}, {"Origin", "https://studio.example.org"}}) == 200);
        CHECK(status({{"Host", "example.org"}}) == 421);
        CHECK(status({{"Host", "studio.example.org"}, {"Origin", "https://example.org"}}) == 403);
        CHECK(contains(client.Get(std::string("/?token=") + test_token)->get_header_value("Set-Cookie"),
                       "; Secure"));
    }

    TEST_CASE("The page's files, and none beside them") {
        const Scratch scratch;
        spill(scratch / "pages/index.html", "<html>studio</html>");
        spill(scratch / "pages/app.js", std::string(200'000, 'x'));
        spill(scratch / "pages/parts/a-1_b.css", "body {}");
        spill(scratch / "pages/parts/index.html", "parts");
        spill(scratch / "pages/.hidden", "secret");
        spill(scratch / "pages/odd name.txt", "secret");
        spill(scratch / "secret.txt", "secret");
        fs::create_symlink("../secret.txt", scratch / "pages/link.txt");
        fs::create_directory_symlink("..", scratch / "pages/up");
        auto settings = RunningTestServer::withToken();
        settings.pages = scratch / "pages";
        const RunningTestServer server{settings};
        auto client = server.client();
        const auto index = client.Get("/");
        REQUIRE(index);
        CHECK(index->body == "<html>studio</html>");
        CHECK(index->get_header_value("Content-Type") == "text/html; charset=utf-8");
        CHECK(index->get_header_value("Cache-Control") == "no-cache");
        CHECK(contains(index->get_header_value("Content-Security-Policy"), "default-src 'self'"));
        const std::string etag = index->get_header_value("ETag");
        CHECK(etag.size() > 10);
        CHECK(client.Get("/index.html?v=1")->get_header_value("ETag") == etag);
        const auto again = client.Get("/", httplib::Headers{{"If-None-Match", etag}});
        CHECK(again->status == 304);
        CHECK(again->body.empty());
        CHECK(client.Get("/app.js", httplib::Headers{{"Accept-Encoding", "br"}})->body.size() == 200'000);
        CHECK(client.Get("/app.js")->get_header_value("ETag") != etag);
        CHECK(client.Get("/parts/a-1_b.css")->get_header_value("Content-Type") == "text/css; charset=utf-8");
        CHECK(client.Get("/parts/")->body == "parts");
        CHECK(client.Head("/app.js")->get_header_value("Content-Length") == "200000");
        CHECK(client.Post("/app.js", "x", "text/plain")->status == 405);
        CHECK(server.client(false).Get("/")->status == 401);
        for (const std::string path :
             {"/../secret.txt", "/parts/../../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt",
              "/..%5csecret.txt", "/parts/..\\..\\secret.txt", "/link.txt", "/up/secret.txt", "/.hidden",
              "/odd%20name.txt", "/parts", "/app.js/", "/app.js%00.html", "/%61pp.js", "//app.js",
              "/./app.js", "/index.html/../app.js"}) {
            CAPTURE(path);
            const std::string answer = server.answerTo(server.head("GET " + path));
            CHECK(statusOf(answer) == 404);
            CHECK(!contains(answer, "secret\n"));
        }
        settings.pages = scratch / "absent";
        CHECK(contains(HttpServer::start(settings, {}).error().text(), "absent"));
    }

    TEST_CASE("TLS") {
        const Scratch scratch;
        const auto settings = withCertificate(scratch);
        const RunningTestServer server{settings};
        CHECK(server.http->address() == "https://127.0.0.1:" + std::to_string(server.http->port()) + "/");
        httplib::SSLClient client("localhost", server.http->port());
        client.set_ca_cert_path(settings.certificate.c_str());
        client.enable_server_certificate_verification(true);
        client.set_keep_alive(true);
        client.set_bearer_token_auth(test_token);
        for (int i = 0; i < 3; ++i) {
            const auto answer = client.Get("/v1/plain");
            REQUIRE_MESSAGE(answer, httplib::to_string(answer.error()));
            CHECK(answer->status == 200);
        }
        const std::string text = nlohmann::json{{"text", "ten letter"}}.dump();
        CHECK(client.Post("/v1/echo", text, "application/json")->status == 200);
        CHECK(client.Post("/v1/echo", std::string(2'000'000, ' '), "application/json")->status == 413);
        const std::string port = std::to_string(server.http->port());
        CHECK(client.Get("/v1/plain", httplib::Headers{{"Origin", "https://localhost:" + port}})->status ==
              200);
        CHECK(client.Get("/v1/plain", httplib::Headers{{"Origin", "http://localhost:" + port}})->status ==
              403);
        CHECK(contains(client.Get(std::string("/?token=") + test_token)->get_header_value("Set-Cookie"),
                       "; Secure"));
        // In the clear nothing is answered, and a handshake that stands still stops nobody.
        RawClient stalled(server.http->port());
        stalled.send("\x16\x03\x01");
        CHECK(statusOf(server.answerTo(server.head("GET /v1/plain"))) == 0);
        CHECK(client.Get("/v1/plain")->status == 200);
    }

    TEST_CASE("Certificates that cannot be used are errors that name the file") {
        const Scratch scratch;
        const auto good = withCertificate(scratch);
        const auto problem = [](const ServerSettings& settings) {
            const auto started = HttpServer::start(settings, {});
            return started ? "" : started.error().text();
        };
        auto settings = good;
        settings.certificate = scratch / "absent.pem";
        CHECK(contains(problem(settings), "absent.pem: no certificate"));
        settings = good;
        settings.key = good.certificate;
        CHECK(contains(problem(settings), "cert.pem: no key"));
        const Scratch other;
        settings = good;
        settings.key = withCertificate(other).key;
        CHECK(contains(problem(settings), "no key of this certificate"));
        const auto locked = shell("openssl ec -aes128 -passout pass:x -in " + good.key.string() + " -out " +
                                  (scratch / "locked.pem"));
        REQUIRE(locked.status == 0);
        settings.key = scratch / "locked.pem";
        CHECK(contains(problem(settings), "locked.pem: no key"));
    }
}
