// The authoring session by the real program: somebody's browser over HTTP, a killed program, and what becomes
// of it.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <thread>

#include "serving.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

/// Two speeches of the shipped ones, quickly.
std::string study(const std::string& limits = "limit_s = 300\nmay_end_early = true\n") {
    return R"(
[study]
name = "author"
title = "Authoring"
seed = 4
[targets]
from_projects = "relaxed"
[[layouts]]
name = "page"
viewer_m = [0.0, 3.4]
heading_deg = 180
[[systems]]
name = "SGT"
projects = "relaxed"
controls = false
[[systems]]
name = "MANUAL"
projects = "relaxed"
controls = false
[[stages]]
name = "intro"
kind = "instructions"
text = "Hello."
[[stages]]
name = "authoring"
kind = "authoring"
items = 4
layouts = ["page"]
system_meets = "nested"
block_by = "system"
block_order = "williams"
keyframes_only = ["MANUAL"]
practice_per_block = 1
question = "Make gestures."
)" + limits +
           R"(
[[stages]]
name = "survey"
kind = "questionnaire"
scale = {low = 1, high = 7}
[[stages.questions]]
id = "sgt"
kind = "scale"
text = "As intended, by the model?"
rates = {measure = "intention", system = "SGT"}
[[stages.questions]]
id = "manual"
kind = "scale"
text = "As intended, by keyframes?"
rates = {measure = "intention", system = "MANUAL"}
[[stages.questions]]
id = "remark"
kind = "text"
text = "A remark?"
)";
}

/// A page of the session, as a browser asks.
class Page {
  public:
    explicit Page(const std::string& arguments) : serving_(arguments, "run") {
        const std::string line = serving_.out();
        token_ = line.substr(line.find("?token=") + 7, 32);
    }

    struct Answered {
        int status = 0;
        json body{};
    };
    Answered ask(const std::string& method, const std::string& path, const json& body = nullptr) {
        const std::string answer = body.is_null()
                                       ? serving_.answerTo(serving_.head(method + " " + path, token_))
                                       : serving_.send(method, path, body, token_);
        return {statusOf(answer), json::parse(bodyOf(answer), nullptr, false)};
    }
    json now() { return ask("GET", "/v1/session").body; }

    Answered press(const json& now, const json& button) {
        return ask("POST", "/v1/session/press", {{"revision", now["revision"]}, {"button", button["id"]}});
    }

    /// Answers boards until there is a trial, or the end.
    json toTrial() {
        for (int i = 0; i < 200; ++i) {
            json shown = now();
            if (shown["over"] == true) return shown;
            if (shown["panel"].is_null()) {
                if (!shown["authoring"].is_null()) return shown;
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                continue;
            }
            answerBoard(shown);
        }
        FAIL("no trial came");
        return {};
    }

    Serving& serving() { return serving_; }
    /// Whether the program ends by itself, with that status.
    bool endsWith(int status) {
        return eventually(20, [this] { return !serving_.running().running(); }) &&
               serving_.running().wait() == status;
    }

  private:
    Serving serving_;
    std::string token_;

    void answerBoard(const json& shown) {
        const json& panel = shown["panel"];
        for (const json& field : panel["fields"])
            if (field["text"] == "") {
                const auto typed =
                    ask("POST", "/v1/session/type",
                        {{"revision", shown["revision"]}, {"field", field["id"]}, {"text", "Göteborg"}});
                CHECK(typed.status == 200);
                return;
            }
        std::map<int, bool> chosen;  // by question
        for (const json& button : panel["buttons"])
            if (button["role"] == "option")
                chosen[button["id"].get<int>() / 100] |= button["chosen"].get<bool>();
        for (const json& button : panel["buttons"]) {
            const bool open = button["role"] == "option" && !chosen[button["id"].get<int>() / 100];
            if (open || (button["role"] == "go_on" && button["enabled"] == true)) {
                CHECK(press(shown, button).status == 200);
                return;
            }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
};

json work(const json& trial, const std::string& name, int edits) {
    json out{
        {"trial", trial["trial"]}, {"project", trial["project"]}, {"edits", json::array()}, {"generated", 1}};
    out["project"]["document"]["name"] = name;
    for (int i = 0; i < edits; ++i) out["edits"].push_back({{"at_s", 0.1 * i}, {"what", "edit " + name}});
    return out;
}

template <typename Value>
Value one(const std::string& database, const std::string& sql) {
    SQLite::Database opened(database);
    return opened.execAndGet(sql);
}

}  // namespace

TEST_SUITE("app/authoring_session") {
    TEST_CASE("A session over HTTP is killed in a trial, goes on with the work, and becomes clips") {
        const Scratch scratch;
        spill(scratch / "author.toml", study());
        const std::string database = scratch / "a.sqlite";
        const std::string arguments = (scratch / "author.toml") +
                                      " --station studio --no-browser --participant P01 --db " + database +
                                      " --stimuli " + sharedStimuli();
        double left_s = 0.0;
        {
            Page page(arguments);
            const json health = page.ask("GET", "/v1/health").body;
            CHECK(health["session"] == json{{"participant", "P01"}, {"study", "author"}, {"language", "en"}});
            CHECK(page.now()["state"] == "instructions");
            const json trial = page.toTrial()["authoring"];
            CHECK(trial["trial"] == 1);
            CHECK(trial["of"] == 4);
            CHECK(trial["practice"] == true);
            CHECK(trial["project"]["format"] == "deixis-studio");
            CHECK(trial["limit_s"] == 300.0);
            const auto wrong = page.ask("PUT", "/v1/session/work",
                                        work({{"trial", 2}, {"project", trial["project"]}}, "x", 1));
            CHECK(wrong.status == 409);
            CHECK(wrong.body["error"]["field"] == "trial");
            json bad = work(trial, "x", 1);
            bad.erase("project");
            const auto missing = page.ask("PUT", "/v1/session/work", bad);
            CHECK(missing.status == 400);
            CHECK(missing.body["error"]["field"] == "project");
            CHECK(page.ask("GET", "/v1/session?after=x").body["error"]["field"] == "after");
            CHECK(page.ask("GET", "/v1/session?before=1").status == 400);
            CHECK(page.ask("PUT", "/v1/session/work", work(trial, "half", 3)).status == 200);
            std::this_thread::sleep_for(std::chrono::milliseconds(2500));
            left_s = page.now()["authoring"]["left_s"];
            CHECK(left_s < 298.0);
            page.serving().running().kill(SIGKILL);
        }
        CHECK(fs::exists(database + ".P01.work"));
        std::this_thread::sleep_for(std::chrono::milliseconds(2000));
        {
            Page page(arguments);
            const json trial = page.toTrial()["authoring"];
            CHECK(trial["trial"] == 1);
            CHECK(trial["project"]["document"]["name"] == "half");
            CHECK(trial["left_s"].get<double>() == doctest::Approx(left_s).epsilon(0.01));
            // A pause: the time stands still.
            CHECK(page.ask("POST", "/v1/session/pause", json::object()).status == 200);
            json paused = page.now();
            CHECK(paused["state"] == "paused");
            CHECK(page.ask("POST", "/v1/session/finish", work(trial, "no", 0)).status == 409);
            const double stood_s = paused["authoring"]["left_s"];
            std::this_thread::sleep_for(std::chrono::milliseconds(700));
            paused = page.now();
            CHECK(paused["authoring"]["left_s"] == stood_s);
            CHECK(page.press({{"revision", 1}}, paused["panel"]["buttons"][0]).status == 409);
            CHECK(page.press(paused, paused["panel"]["buttons"][0]).status == 200);
            CHECK(page.ask("POST", "/v1/session/finish", work(page.now()["authoring"], "first", 2)).status ==
                  200);
            for (int trials = 2; trials <= 4; ++trials) {
                const json next = page.toTrial()["authoring"];
                CHECK(next["trial"] == trials);
                CHECK(next["keyframes_only"] == (next["system"] == "MANUAL"));
                CHECK(page.ask("POST", "/v1/session/finish", work(next, "trial " + std::to_string(trials), 1))
                          .status == 200);
            }
            CHECK(page.toTrial()["over"] == true);
            CHECK(page.endsWith(0));
        }
        CHECK_FALSE(fs::exists(database + ".P01.work"));
        CHECK(one<int>(database, "SELECT count(*) FROM authored") == 4);
        CHECK(one<int>(database, "SELECT edits FROM authored WHERE trial_index = 0") == 5);
        CHECK(one<int>(database, "SELECT begun_before FROM responses WHERE trial_index = 0") == 1);
        CHECK(one<int>(database, "SELECT count(*) FROM events WHERE kind = 'edit'") == 8);
        CHECK(one<std::string>(database, "SELECT station FROM sessions LIMIT 1") == "studio");
        CHECK(one<std::string>(database, "SELECT text FROM answers WHERE question = 'remark'") == "Göteborg");

        const auto made = program("clips author --db " + database + " -o " + (scratch / "clips"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
        CHECK(contains(made.out, "2 clips"));
        const std::string manifest = slurp(scratch / "clips/manifest.csv");
        CAPTURE(manifest);
        CHECK(contains(manifest, "SGT"));
        CHECK(contains(manifest, "MANUAL"));
        CHECK(contains(manifest, "P01"));
        CHECK(std::count(manifest.begin(), manifest.end(), '\n') == 3);  // no practice
        CHECK_FAILS_SAYING(program("participants withdraw " + database + " P02"), "P02");
        spill(database + ".P01.work", "{}");
        REQUIRE(program("participants withdraw " + database + " P01 --yes").status == 0);
        CHECK_FALSE(fs::exists(database + ".P01.work"));
        CHECK(one<int>(database, "SELECT count(*) FROM response_values") == 0);
        CHECK(one<int>(database, "SELECT count(*) FROM events") == 0);
        CHECK(slurp(database).find("trial 3") == std::string::npos);
    }

    TEST_CASE("The time limit ends a trial; Ctrl-C ends the session, which can go on") {
        const Scratch scratch;
        spill(scratch / "author.toml", study("limit_s = 3\n"));
        const std::string database = scratch / "a.sqlite";
        Page page((scratch / "author.toml") + " --station studio --no-browser --participant P02 --db " +
                  database + " --stimuli " + sharedStimuli());
        const json trial = page.toTrial()["authoring"];
        CHECK(page.ask("POST", "/v1/session/finish", work(trial, "early", 1)).status == 409);
        CHECK(page.ask("PUT", "/v1/session/work", work(trial, "late", 1)).status == 200);
        CHECK(eventually(10, [&] { return page.toTrial()["authoring"]["trial"] == 2; }));
        page.serving().running().kill(SIGINT);
        CHECK(page.endsWith(0));
        CHECK(contains(page.serving().out(), "continues there"));
        CHECK(one<double>(database, "SELECT value FROM answers WHERE question = 'time'") == 3.0);
        CHECK(one<std::string>(database, "SELECT outcome FROM sessions") == "quit");
    }

    TEST_CASE("Stages that a station cannot show are told before the session begins") {
        const Scratch scratch;
        spill(scratch / "author.toml", study());
        CHECK_FAILS_SAYING(program("run " + (scratch / "author.toml") + " --db " + (scratch / "a.sqlite")),
                           "--station", "\"authoring\"", "--station studio");
        spill(scratch / "clips.toml", shippedStudy());
        CHECK_FAILS_SAYING(
            program("run " + (scratch / "clips.toml") + " --station studio --db " + (scratch / "b.sqlite")),
            "--station", "naturalness", "shows clips");
    }

    TEST_CASE("Simulated participants author, and the report tells time and survey by system") {
        const Scratch scratch;
        spill(scratch / "author.toml", study());
        const std::string database = scratch / "s.sqlite";
        const auto simulated = program("simulate " + (scratch / "author.toml") + " --participants 12 -o " +
                                       database + " --stimuli " + sharedStimuli());
        REQUIRE_MESSAGE(simulated.status == 0, simulated.err);
        CHECK(one<int>(database, "SELECT count(*) FROM authored") == 48);
        const auto reported =
            program("report " + database + " -o " + (scratch / "r.html") + " --json " + (scratch / "r.json"));
        REQUIRE_MESSAGE(reported.status == 0, reported.err);
        const std::string page = slurp(scratch / "r.html");
        CHECK(contains(page, "uthoring time"));
        CHECK(contains(page, "ntention"));
        CHECK(contains(page, "Friedman"));
        CHECK(contains(page, "imulated"));
    }
}
