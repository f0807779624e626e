// Where a session and its pages meet: revisions, requests and their answers, over threads.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

#include "server/session/session_desk.hpp"

using namespace deixis::server;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

SessionShown board(const std::string& state, double left_s = 0.0) {
    return {{{"state", state}, {"authoring", nullptr}}, nullptr, left_s};
}

SessionDesk::Time in(std::chrono::milliseconds time) {
    return std::chrono::steady_clock::now() + time;
}

}  // namespace

TEST_SUITE("server/session_desk") {
    TEST_CASE("A revision is of what is shown; what is left of the time makes none") {
        SessionDesk desk;
        CHECK(desk.lay(board("instructions")) == 1);
        CHECK(desk.lay(board("instructions")) == 1);
        CHECK(desk.lay(board("authoring", 60.0)) == 2);
        CHECK(desk.lay(board("authoring", 59.0)) == 2);
        CHECK_FALSE(desk.seen());
        CHECK(desk.wait(1, in(1s)).shown.left_s == 59.0);
        CHECK(desk.seen());
        CHECK(desk.lay(board("over")) == 3);
        CHECK_FALSE(desk.seen());
    }

    TEST_CASE("Who knows the page waits for another one, and no longer than told") {
        SessionDesk desk;
        desk.lay(board("a"));
        const auto begun = std::chrono::steady_clock::now();
        CHECK(desk.wait(1, in(50ms)).revision == 1);
        CHECK(std::chrono::steady_clock::now() - begun >= 50ms);
        auto waiting = std::async(std::launch::async, [&] { return desk.wait(1, in(20s)).revision; });
        std::this_thread::sleep_for(20ms);
        desk.lay(board("b"));
        CHECK(waiting.get() == 2);
    }

    TEST_CASE("Requests are taken one after the other, and answered by what is shown then") {
        SessionDesk desk;
        desk.lay(board("a"));
        auto asked = std::async(std::launch::async, [&] {
            SessionRequest request;
            request.kind = SessionRequest::Kind::press;
            request.id = 7;
            return desk.ask(request, in(20s));
        });
        const auto request = desk.next(in(20s));
        REQUIRE(request.has_value());
        CHECK(request->id == 7);
        desk.lay(board("b"));
        desk.done();
        const auto answer = asked.get();
        REQUIRE(answer.has_value());
        CHECK(answer->revision == 2);
        CHECK(desk.seen());
        CHECK_FALSE(desk.next(in(1ms)).has_value());
    }

    TEST_CASE("A refusal comes back, and so does a session that does not answer") {
        SessionDesk desk;
        desk.lay(board("a"));
        auto asked = std::async(std::launch::async, [&] { return desk.ask({}, in(20s)); });
        REQUIRE(desk.next(in(20s)).has_value());
        desk.refuse({409, "gone", "revision"});
        const auto answer = asked.get();
        REQUIRE_FALSE(answer.has_value());
        CHECK(answer.error().status == 409);
        CHECK(answer.error().field == "revision");

        const auto late = desk.ask({}, in(20ms));
        REQUIRE_FALSE(late.has_value());
        CHECK(late.error().status == 503);
        CHECK_FALSE(desk.next(in(1ms)).has_value());  // nobody waits for it any more
    }

    TEST_CASE("At the end those who wait are told, and nothing more is taken") {
        SessionDesk desk;
        desk.lay(board("a"));
        (void)desk.wait(0, in(1s));
        auto waiting = std::async(std::launch::async, [&] { return desk.wait(1, in(20s)); });
        auto asked = std::async(std::launch::async, [&] { return desk.ask({}, in(20s)); });
        std::this_thread::sleep_for(50ms);
        desk.lay(board("over"));
        desk.close(in(5s));
        CHECK(waiting.get().revision == 2);
        const auto answer = asked.get();
        REQUIRE_FALSE(answer.has_value());
        CHECK(answer.error().status == 409);
        CHECK(desk.ask({}, in(1s)).error().message == "the session is over");
    }

    TEST_CASE("Many pages at once: every request is answered once") {
        SessionDesk desk;
        desk.lay(board("0"));
        std::atomic<int> answered = 0;
        std::vector<std::thread> pages;
        for (int page = 0; page < 4; ++page)
            pages.emplace_back([&] {
                for (int i = 0; i < 50; ++i)
                    if (desk.ask({}, in(20s))) ++answered;
            });
        for (int taken = 0; taken < 200;) {
            if (!desk.next(in(20s))) continue;
            desk.lay(board(std::to_string(++taken)));
            desk.done();
        }
        for (std::thread& page : pages) page.join();
        CHECK(answered == 200);
    }

    TEST_CASE("The page's text has the project as it is, and the time that is left") {
        SessionDesk desk;
        SessionShown shown = board("authoring", 12.5);
        shown.board["authoring"] = {{"trial", 2}};
        shown.project = std::make_shared<const std::string>("{\"version\": 2}");
        desk.lay(std::move(shown));
        const json page = json::parse(sessionJson(desk.wait(0, in(1s))));
        CHECK(page["revision"] == 1);
        CHECK(page["authoring"]["trial"] == 2);
        CHECK(page["authoring"]["left_s"] == 12.5);
        CHECK(page["authoring"]["project"]["version"] == 2);
    }
}
