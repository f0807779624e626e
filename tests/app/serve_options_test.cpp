// What deixis serve keeps on the disk, and whose voice, avatar and weights it takes.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "serving.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

json jsonOf(const std::string& answer) {
    return json::parse(bodyOf(answer), nullptr, false);
}

std::string get(const Serving& serving, const std::string& path) {
    return serving.answerTo(serving.head("GET " + path, ""));
}

json project(int number) {
    return {{"name", "work"},
            {"project", {{"version", 1}, {"number", number}, {"much", std::string(300'000, 'x')}}}};
}

}  // namespace

TEST_SUITE("app/serve_options") {
    TEST_CASE("What is kept is there for the next server, and for one beside it") {
        const Scratch scratch;
        const std::string options = "--no-token --folder " + (scratch / "kept");
        std::string path;
        {
            Serving first(options);
            const Serving second(options);
            CHECK(jsonOf(get(first, "/v1/health"))["folder"] == true);
            const json made = jsonOf(first.post("/v1/projects", project(1), ""));
            path = "/v1/projects/" + made["id"].get<std::string>();
            CHECK(jsonOf(get(second, path))["project"] == project(1)["project"]);
            const std::string changed = second.send(
                "PUT", path, project(2), "", "If-Match: \"" + made["revision"].get<std::string>() + "\"\r\n");
            CHECK(statusOf(changed) == 200);
            const std::string late = first.send(
                "PUT", path, project(3), "", "If-Match: \"" + made["revision"].get<std::string>() + "\"\r\n");
            CHECK(statusOf(late) == 412);
        }
        const Serving third(options);
        CHECK(jsonOf(get(third, path))["project"]["number"] == 2);
    }

    TEST_CASE("A server that is killed while it saves leaves a whole project") {
        const Scratch scratch;
        const std::string options = "--no-token --folder " + (scratch / "kept");
        std::string path;
        int in_the_midst = 0;
        for (int round = 0; round < 8; ++round) {
            Serving serving(options);
            if (path.empty())
                path = "/v1/projects/" +
                       jsonOf(serving.post("/v1/projects", project(0), ""))["id"].get<std::string>();
            const int before = 10 * round;
            CHECK(statusOf(serving.send("PUT", path, project(before), "", "If-Match: *\r\n")) == 200);
            RawClient client(serving.port());
            const std::string body = project(before + 1).dump();
            client.send(serving.head("PUT " + path, "",
                                     "If-Match: *\r\nContent-Type: application/json\r\nContent-Length: " +
                                         std::to_string(body.size()) + "\r\n") +
                        body);
            std::this_thread::sleep_for(std::chrono::milliseconds(2 * round));
            serving.running().kill(SIGKILL);
            const bool answered = statusOf(client.receiveAll()) == 200;
            const Serving next(options);
            const json list = jsonOf(get(next, "/v1/projects"));
            REQUIRE(list["projects"].size() == 1);
            CHECK(list["damaged"].empty());
            const int number = jsonOf(get(next, path))["project"]["number"];
            CHECK(number - before <= 1);
            CHECK(number - before >= (answered ? 1 : 0));
            in_the_midst += answered ? 0 : 1;
        }
        CHECK(in_the_midst > 0);
        int files = 0;
        for (const auto& entry : fs::directory_iterator(scratch / "kept/projects"))
            files += entry.exists() ? 1 : 0;
        CHECK(files == 1);  // nothing unfinished is left
    }

    TEST_CASE("The usual folder is the user's, and made when something is kept") {
        const Scratch scratch;
        const auto kept = [&](const std::string& environment, const std::string& where) {
            const Serving serving("--no-token", "serve", environment);
            CHECK(!fs::exists(scratch / where));
            CHECK(statusOf(serving.post("/v1/projects", project(1), "")) == 201);
            CHECK(fs::exists(scratch / (where + "/projects")));
        };
        kept("HOME=" + (scratch / "home") + " XDG_DATA_HOME=" + (scratch / "data"), "data/deixis/studio");
        kept("HOME=" + (scratch / "home") + " XDG_DATA_HOME=data", "home/.local/share/deixis/studio");
        const Serving homeless("--no-token", "serve", "env -u HOME -u XDG_DATA_HOME");
        CHECK(contains(homeless.err(), "nothing is kept on the disk: HOME is not set"));
        CHECK(jsonOf(get(homeless, "/v1/health"))["folder"] == false);
        CHECK(statusOf(homeless.post("/v1/projects", project(1), "")) == 409);
        spill(scratch / "file", "x");
        CHECK_FAILS_SAYING(program("serve --port 0 --folder " + (scratch / "file")),
                           "found a file, expected a folder");
    }

    TEST_CASE("A lab's own voice is run without a shell") {
        const Scratch scratch;
        const std::string script = scratch / "voice $(touch " + (scratch / "ran)");
        spill(scratch / "anna", "#!/bin/sh\necho 'no licence' >&2\nexit 7\n");
        fs::permissions(scratch / "anna", fs::perms::owner_all);
        const Serving serving("--no-token --voice anna=" + (scratch / "anna") + " --voice hans:de=true");
        const json voices = jsonOf(get(serving, "/v1/health"))["voices"];
        CHECK(std::count(voices.begin(), voices.end(), json{{"name", "anna"}, {"language", "en"}}) == 1);
        CHECK(std::count(voices.begin(), voices.end(), json{{"name", "hans"}, {"language", "de"}}) == 1);
        const std::string answer = serving.post("/v1/generate", {{"text", "Hello."}, {"voice", "anna"}}, "");
        CHECK(statusOf(answer) == 502);
        CHECK(contains(jsonOf(answer)["error"]["message"].get<std::string>(), "no licence"));
        for (const std::string& wrong :
             {std::string("anna"), std::string("=x"), std::string("a=/no/such/program"),
              "'a b=true'" + std::string(), "'x=" + script + "'", "anna=" + scratch.path().string(),
              std::string("slt=true")})
            CHECK_FAILS_SAYING(program("serve --port 0 --voice " + wrong), "--voice");
        CHECK(!fs::exists(scratch / "ran"));
    }

    TEST_CASE("An avatar that is none, and weights that are none, are named") {
        const Scratch scratch;
        spill(scratch / "broken.glb", "glTF");
        CHECK_FAILS_SAYING(program("serve --port 0 --avatar " + (scratch / "broken.glb")), "broken.glb");
        CHECK_FAILS_SAYING(program("serve --port 0 --avatar " + (scratch / "absent.glb")), "absent.glb");
        CHECK_FAILS_SAYING(program("serve --port 0 --gestures " + (scratch / "broken.glb")), "broken.glb");
        const Serving serving("--no-token --avatar " + (buildDir() / "share/deixis/avatar.glb").string());
        const std::string avatar = get(serving, "/avatar.glb");
        CHECK(bodyOf(avatar).starts_with("glTF"));
        CHECK(bodyOf(avatar) != slurp(buildDir() / "share/deixis/avatar.glb"));
    }
}
