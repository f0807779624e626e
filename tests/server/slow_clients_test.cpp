// Slow and many clients, and stopping while a request runs.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "running_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

/// Few threads and little patience, so that a test need not wait.
server::ServerSettings hurried() {
    auto settings = RunningTestServer::withToken();
    settings.limits.threads = 2;
    settings.limits.connections = 40;
    settings.limits.head_time = 700ms;
    settings.limits.idle_time = 700ms;
    settings.limits.transfer_time = 700ms;
    settings.limits.stopping_time = 700ms;
    return settings;
}

double secondsOf(const std::function<void()>& work) {
    const auto since = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - since).count();
}

}  // namespace

TEST_SUITE("server/slow_clients") {
    TEST_CASE("Heads that come slowly, or not at all, take no thread from others") {
        auto settings = hurried();
        settings.limits.head_time = 60s;
        const RunningTestServer server{settings};
        std::vector<std::unique_ptr<RawClient>> slow;
        for (int i = 0; i < 30; ++i) {
            slow.push_back(std::make_unique<RawClient>(server.http->port()));
            if (i % 2 == 0) slow.back()->send("GET /v1/plain HTTP/1.1\r\nHost: " + server.host() + "\r\nX: ");
        }
        for (int round = 0; round < 5; ++round) {
            for (std::size_t i = 0; i < slow.size(); i += 2) slow[i]->send("a");
            auto client = server.client();
            const double took_s = secondsOf([&] { CHECK(client.Get("/v1/plain")->status == 200); });
            CHECK(took_s < 1.0);
        }
        // More than may wait: the oldest give way.
        for (int i = 0; i < 100; ++i) slow.push_back(std::make_unique<RawClient>(server.http->port()));
        auto client = server.client();
        CHECK(client.Get("/v1/plain")->status == 200);
        CHECK(slow.front()->receiveAll(2000ms).empty());
        CHECK(slow.front()->closed());
        // A head that was only slow is answered in the end.
        const auto patient = std::make_unique<RawClient>(server.http->port());
        for (const char c : server.head("GET /v1/plain")) {
            patient->send(std::string(1, c));
            std::this_thread::sleep_for(1ms);
        }
        CHECK(statusOf(patient->receiveAll(500ms)) == 200);
    }

    TEST_CASE("A head that does not end, and a connection without a request, are closed in time") {
        const RunningTestServer server{hurried()};
        RawClient silent(server.http->port());
        RawClient dripping(server.http->port());
        const double took_s = secondsOf([&] {
            for (int i = 0; i < 40; ++i) {
                dripping.send("G");
                std::this_thread::sleep_for(25ms);
            }
            CHECK(dripping.receiveAll(2000ms).empty());
            CHECK(silent.receiveAll(2000ms).empty());
        });
        CHECK(dripping.closed());
        CHECK(silent.closed());
        CHECK(took_s < 2.5);
    }

    TEST_CASE("Bodies that do not come, and answers that nobody reads, end in time") {
        const RunningTestServer server{hurried()};
        std::vector<std::unique_ptr<RawClient>> slow;
        for (int i = 0; i < 4; ++i) {  // twice as many as there are threads
            slow.push_back(std::make_unique<RawClient>(server.http->port()));
            slow.back()->send(
                server.head("POST /v1/echo", "Content-Type: application/json\r\nContent-Length: 100\r\n") +
                "{");
        }
        auto client = server.client();
        const double took_s = secondsOf([&] { CHECK(client.Get("/v1/plain")->status == 200); });
        CHECK(took_s < 4.0);
        // Without the token a body is not waited for.
        RawClient stranger(server.http->port());
        stranger.send("POST /v1/echo HTTP/1.1\r\nHost: " + server.host() +
                      "\r\nContent-Type: application/json\r\nContent-Length: 100\r\n\r\n");
        CHECK(statusOf(stranger.receiveAll(300ms)) == 401);
    }

    TEST_CASE("Before a large body is sent the server may be asked") {
        const RunningTestServer server{hurried()};
        const std::string asks = "Content-Type: application/json\r\nExpect: 100-continue\r\nContent-Length: ";
        RawClient good(server.http->port());
        good.send(server.head("POST /v1/echo", asks + "2\r\n"));
        CHECK(good.receiveAll(300ms).starts_with("HTTP/1.1 100 Continue\r\n\r\n"));
        good.send("{}");
        CHECK(statusOf(good.receiveAll(300ms)) == 200);
        RawClient large(server.http->port());
        large.send(server.head("POST /v1/echo", asks + "100000\r\n"));
        CHECK(statusOf(large.receiveAll(300ms)) == 413);
    }

    TEST_CASE("Fifty clients at once, each several times") {
        const RunningTestServer server;
        std::atomic<int> right = 0;
        std::vector<std::thread> threads;
        for (int i = 0; i < 50; ++i)
            threads.emplace_back([&, i] {
                auto client = server.client();
                for (int k = 0; k < 4; ++k) {
                    const std::string text = std::to_string(i) + "." + std::to_string(k);
                    const auto answer =
                        client.Post("/v1/echo", nlohmann::json{{"text", text}}.dump(), "application/json");
                    if (answer && answer->status == 200 &&
                        nlohmann::json::parse(answer->body)["text"] == text)
                        ++right;
                }
            });
        for (std::thread& thread : threads) thread.join();
        CHECK(right == 200);
    }

    TEST_CASE("Stopping lets a running request end, and answers it") {
        RunningTestServer server{hurried()};
        auto waiting = std::async(std::launch::async, [&] { return server.client().Get("/v1/wait"); });
        server.routes.waitFor(1);
        RawClient idle(server.http->port());
        const int port = server.http->port();
        auto stopped = std::async(std::launch::async, [&] { server.http->stop(); });
        CHECK(idle.receiveAll(2000ms).empty());
        CHECK(idle.closed());
        CHECK(stopped.wait_for(1500ms) == std::future_status::timeout);
        server.routes.letGo();
        REQUIRE(stopped.wait_for(10s) == std::future_status::ready);
        const auto answer = waiting.get();
        REQUIRE(answer);
        CHECK(answer->body.size() >
              8'000'000);  // though stopping takes longer than it has patience for transfers
        CHECK(nlohmann::json::parse(answer->body)["waited"] == true);
        // The port is free again at once.
        auto settings = hurried();
        settings.port = port;
        const RunningTestServer again{settings};
        CHECK(again.http->port() == port);
        server.http->stop();
    }

    TEST_CASE("Stopping does not wait long for a body that does not come") {
        auto settings = hurried();
        settings.limits.transfer_time = 60s;
        RunningTestServer server{settings};
        RawClient slow(server.http->port());
        slow.send(server.head("POST /v1/echo", "Content-Type: application/json\r\nContent-Length: 100\r\n") +
                  "{");
        std::this_thread::sleep_for(200ms);
        CHECK(secondsOf([&] { server.http->stop(); }) < 3.0);
    }
}
