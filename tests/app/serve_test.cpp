// deixis serve as somebody starts it: the whole program, asked over real sockets.
#include <chrono>
#include <filesystem>
#include <string>

#include "serving.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

constexpr const char* own_token = "my-own-token-0123456789";

}  // namespace

TEST_SUITE("app/serve") {
    TEST_CASE("It tells its address with a new token, answers who has it, and ends with 0") {
        Serving serving("");
        const std::string line = serving.out();
        const auto at = line.find("/?token=");
        REQUIRE(at != std::string::npos);
        CHECK(line.starts_with("http://127.0.0.1:"));
        CHECK(line.find('\n') == line.size() - 1);
        const std::string token = line.substr(at + 8, line.size() - at - 9);
        CHECK(token.size() == 32);
        CHECK(statusOf(serving.answerTo(serving.head("GET /v1/health", ""))) == 401);
        const std::string healthy = serving.answerTo(serving.head("GET /v1/health", token));
        REQUIRE(statusOf(healthy) == 200);
        const json health = json::parse(bodyOf(healthy));
        CHECK(health["status"] == "ok");
        CHECK(contains(program("--version").out,
                       "deixis " + health["version"].get<std::string>() + " (commit"));
        CHECK(contains(program("--version").out, "commit: " + health["commit"].get<std::string>()));
        const std::string entered = serving.answerTo(serving.head("GET /?token=" + token, ""));
        CHECK(statusOf(entered) == 303);
        CHECK(contains(entered,
                       "Set-Cookie: deixis_token=" + token + "; Path=/; HttpOnly; SameSite=Strict\r\n"));
        const std::string avatar = serving.answerTo(serving.head("GET /avatar.glb", token));
        CHECK(contains(avatar, "Content-Type: model/gltf-binary"));
        CHECK(bodyOf(avatar).starts_with("glTF"));
        serving.running().kill(SIGINT);
        CHECK(serving.running().wait() == 0);
        CHECK(serving.err() == "");
        CHECK(serving.out() == line);
    }

    TEST_CASE("Gestures to a text, by a token of one's own; nothing of it is logged") {
        Serving serving(std::string("--token ") + own_token);
        CHECK(contains(serving.out(), std::string("/?token=") + own_token + "\n"));
        const std::string answer = serving.post(
            "/v1/generate", {{"text", "It was a very big xylophone."}, {"seed", 3}, {"format", "bvh"}},
            own_token);
        REQUIRE_MESSAGE(statusOf(answer) == 200, answer);
        const json made = json::parse(bodyOf(answer));
        CHECK(made["words"][4]["word"] == "big");
        CHECK(made["fps"] == 15);
        CHECK(made["bvh"].get<std::string>().starts_with("HIERARCHY\n"));
        const std::string refused =
            serving.post("/v1/generate", {{"text", "Hello."}, {"colour", 1}}, own_token);
        CHECK(statusOf(refused) == 400);
        CHECK(json::parse(bodyOf(refused))["error"]["field"] == "colour");
        serving.running().kill(SIGTERM);
        CHECK(serving.running().wait() == 0);
        CHECK(!contains(serving.out() + serving.err(), "xylophone"));
    }

    TEST_CASE("deixis studio opens its page in the browser, with a new token") {
        const Scratch desktop;
        spill(desktop / "xdg-open", "#!/bin/sh\nprintf '%s\\n' \"$1\" > '" + (desktop / "opened") + "'\n");
        std::filesystem::permissions(desktop / "xdg-open", std::filesystem::perms::owner_all);
        Serving studio("", "studio", "PATH=" + (desktop / "") + ":/usr/bin:/bin");
        CHECK(eventually(20, [&] { return slurp(desktop / "opened") == studio.out(); }));
        const std::string line = studio.out();
        const std::string token = line.substr(line.find("?token=") + 7, 32);
        CHECK(statusOf(studio.answerTo(studio.head("GET /", ""))) == 401);
        const std::string page = studio.answerTo(studio.head("GET /", token));
        CHECK(statusOf(page) == 200);
        CHECK(contains(page, "Content-Security-Policy: default-src 'self'"));
        CHECK(contains(bodyOf(page), "studio.js"));
        studio.running().kill(SIGINT);
        CHECK(studio.running().wait() == 0);
        Serving closed("--no-browser", "studio", "PATH=" + (desktop / "") + ":/usr/bin:/bin");
        CHECK(contains(closed.out(), "/?token="));
        CHECK(slurp(desktop / "opened") == line);
    }

    TEST_CASE("Without a token on the loopback") {
        Serving serving("--no-token");
        CHECK(serving.out() == "http://127.0.0.1:" + std::to_string(serving.port()) + "/\n");
        CHECK(statusOf(serving.answerTo(serving.head("GET /v1/health", ""))) == 200);
    }

    TEST_CASE("What runs is finished before it ends") {
        Serving serving(std::string("--token ") + own_token);
        std::string text;
        for (int i = 0; i < 40; ++i) text += "This sentence is one of many that are spoken. ";
        RawClient client(serving.port());
        const std::string body = json{{"text", text}, {"format", "json"}}.dump();
        client.send(serving.head("POST /v1/generate", own_token,
                                 "Content-Type: application/json\r\nContent-Length: " +
                                     std::to_string(body.size()) + "\r\n") +
                    body);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        serving.running().kill(SIGTERM);
        CHECK(serving.running().wait() == 0);
        const std::string answer = client.receiveAll(std::chrono::seconds(10));
        CHECK(statusOf(answer) == 200);
        CHECK(json::parse(bodyOf(answer))["words"].size() == 360);
    }

    TEST_CASE("A port in use is one message, and wrong usage another") {
        const Serving serving("--no-token");
        CHECK_FAILS_SAYING(program("serve --port " + std::to_string(serving.port())),
                           "127.0.0.1:" + std::to_string(serving.port()),
                           "another program listens on this port");
        const auto wrong = [](const std::string& arguments, const std::string& what) {
            const auto done = program("serve --port 0 " + arguments);
            CAPTURE(arguments);
            CHECK(done.status == 2);
            CHECK(done.out.empty());
            CHECK_MESSAGE(contains(done.err, what), done.err);
        };
        wrong("--address 0.0.0.0", "needs TLS");
        wrong("--address 0.0.0.0 --no-token", "needs TLS");
        wrong("--address 0.0.0.0 --behind-proxy --no-token", "--token");
        wrong("--address 0.0.0.0 --behind-proxy --token short", "--token");
        wrong("--behind-proxy --no-token", "--token");
        wrong("--address localhost", "--address");
        wrong("--token 'a b'", "--token");
        wrong("--token a --no-token", "--no-token");
        wrong("--cert c.pem", "--key");
        wrong("--key k.pem", "--cert");
        wrong("--port 65536", "65535");
        wrong("--host http://x", "--host");
        CHECK_FAILS_SAYING(program("serve --port 0 --cert absent.pem --key absent.pem"), "absent.pem");
    }
}
