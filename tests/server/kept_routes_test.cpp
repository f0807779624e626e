// Motions, rules and projects that are kept: over the routes, and as files.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "app/program.hpp"
#include "core/hash.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

/// Arms out, some frames.
json someFrames(int count) {
    const json pose{0, 1, 0, 0, 0.6, 0.8, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0};
    return json(static_cast<std::size_t>(count), pose);
}

json motionNamed(const std::string& name) {
    return {{"name", name}, {"meaning", "Size"}, {"class", "iconic"}, {"frames", someFrames(3)}};
}

std::vector<std::string> ownNames(const StudioServer& server) {
    std::vector<std::string> out;
    const json all = server.get("/v1/motions")["motions"];
    for (const json& one : all)
        if (one["own"] == true) out.push_back(one["name"]);
    return out;
}

json projectOf(int number) {
    return {
        {"version", 3}, {"number", number}, {"text", "größer\n"}, {"deep", {{"list", {1, 2.5, nullptr}}}}};
}

}  // namespace

TEST_SUITE("server/kept_routes") {
    TEST_CASE("Motions of one's own stand in the library, on this server and the next one") {
        const Scratch scratch;
        std::string id;
        {
            const StudioServer server{studioPartsIn(scratch / "kept")};
            const auto shipped = server.get("/v1/motions")["motions"].size();
            const auto added = server.post("/v1/motions", motionNamed(" Wide "));
            REQUIRE_MESSAGE(added.status == 201, added.body.dump());
            id = added.body["id"];
            CHECK(added.body["name"] == "Wide");
            CHECK(added.body["own"] == true);
            CHECK(added.body["frames"] == json::parse(someFrames(3).dump()));
            CHECK(added.body["duration_s"].get<double>() == doctest::Approx(0.2));
            CHECK(server.post("/v1/motions", {{"name", "b"}, {"frames", someFrames(300)}}).status == 201);
            const json all = server.get("/v1/motions")["motions"];
            CHECK(all.size() == shipped + 2);
            CHECK(all[shipped + 1] == added.body);  // by name
            for (std::size_t i = 0; i < shipped; ++i) CHECK(all[i]["own"] == false);
        }
        const StudioServer server{studioPartsIn(scratch / "kept")};
        CHECK(ownNames(server) == std::vector<std::string>{"b", "Wide"});
        CHECK(server.remove("/v1/motions/" + id).status == 204);
        CHECK(server.remove("/v1/motions/" + id).status == 404);
        CHECK(ownNames(server) == std::vector<std::string>{"b"});
        CHECK(!fs::exists(scratch / ("kept/motions/" + id + ".json")));
    }

    TEST_CASE("Motions that cannot be added say why") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const json shipped = server.get("/v1/motions")["motions"][0];
        CHECK(server.post("/v1/motions", motionNamed("Wide")).status == 201);
        const auto refused = [&](const json& motion, int status, const json& field) {
            const auto answer = server.post("/v1/motions", motion);
            CHECK(answer.status == status);
            CHECK(answer.field() == field);
        };
        refused(motionNamed("wIDE"), 409, "name");
        refused(motionNamed(shipped["name"]), 409, "name");
        refused(motionNamed("  "), 400, "name");
        refused(motionNamed(std::string(81, 'x')), 400, "name");
        json motion = motionNamed("other");
        motion["frames"] = someFrames(301);
        refused(motion, 400, "frames");
        motion["frames"] = json::array();
        refused(motion, 400, "frames");
        motion["frames"] = someFrames(2);
        for (std::size_t i = 0; i < 3; ++i) motion["frames"][1][i] = 0;
        refused(motion, 400, "frames[1]");
        const auto kept = server.remove("/v1/motions/" + shipped["id"].get<std::string>());
        CHECK(kept.status == 403);
        CHECK(contains(kept.message(), "ships"));
        CHECK(server.remove("/v1/motions/0123456789abcdef").status == 404);
        CHECK(server.remove("/v1/motions/rules").status == 404);
    }

    TEST_CASE("A damaged file is named and hides no other") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const std::string good = server.post("/v1/motions", motionNamed("good")).body["id"];
        const std::string bytes = slurp(scratch / ("kept/motions/" + good + ".json"));
        const auto spoil = [&](const std::string& id, const std::string& content) {
            spill(scratch / ("kept/motions/" + id + ".json"), content);
        };
        spoil("00000000000000a1", bytes.substr(0, bytes.size() / 2));
        spoil("00000000000000a2", "");
        spoil("00000000000000a3", replaced(bytes, "\"version\":1", "\"version\":2"));
        spoil("00000000000000a4", replaced(bytes, "iconic", "ironic"));
        spoil("00000000000000a5", "\xff\xfe" + bytes);
        spoil("00000000000000a6", replaced(bytes, "studio motion", "studio rules"));
        const json list = server.get("/v1/motions");
        CHECK(ownNames(server) == std::vector<std::string>{"good"});
        REQUIRE(list["damaged"].size() == 6);
        for (std::size_t i = 0; i < 6; ++i) {
            CHECK(list["damaged"][i]["file"] == "motions/00000000000000a" + std::to_string(i + 1) + ".json");
            CHECK(!list["damaged"][i]["problem"].get<std::string>().empty());
        }
        CHECK(contains(list["damaged"][2]["problem"].get<std::string>(), "a newer Deixis wrote it"));
        CHECK(contains(list["damaged"][3]["problem"].get<std::string>(), "class"));
        CHECK(server.remove("/v1/motions/00000000000000a1").status == 204);
    }

    TEST_CASE("Rules: replaced as a whole, by revision") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const json motions = server.get("/v1/motions")["motions"];
        const std::string own = server.post("/v1/motions", motionNamed("mine")).body["id"];
        const json none = server.get("/v1/rules");
        CHECK(none["rules"] == json::array());
        const json rules = json::array({{{"word", "Big"}, {"motions", {motions[0]["id"], own}}},
                                        {{"word", "mine"}, {"motions", {own}}}});
        const auto put = server.put("/v1/rules", {{"rules", rules}}, none["revision"]);
        REQUIRE_MESSAGE(put.status == 200, put.body.dump());
        CHECK(put.body["rules"] == rules);
        CHECK(put.body["revision"] != none["revision"]);
        CHECK(server.get("/v1/rules") == put.body);
        CHECK(server.client().Get("/v1/rules")->get_header_value("ETag") ==
              "\"" + put.body["revision"].get<std::string>() + "\"");
        // An old revision changes nothing; none at all replaces.
        CHECK(server.put("/v1/rules", {{"rules", json::array()}}, none["revision"]).status == 412);
        CHECK(server.put("/v1/rules", {{"rules", json::array()}, {"revision", none["revision"]}}).status ==
              412);
        CHECK(server.get("/v1/rules") == put.body);
        CHECK(server.put("/v1/rules", {{"rules", rules}}).status == 200);
        // What one reads one may write.
        CHECK(server.put("/v1/rules", {{"rules", rules}, {"revision", put.body["revision"]}}).status == 200);
        // A deleted motion goes out of its rules.
        CHECK(server.remove("/v1/motions/" + own).status == 204);
        const json left = server.get("/v1/rules");
        CHECK(left["rules"] == json::array({{{"word", "Big"}, {"motions", {motions[0]["id"]}}}}));
        CHECK(server.put("/v1/rules", {{"rules", rules}}, put.body["revision"]).status == 400);
        CHECK(server.put("/v1/rules", {{"rules", left["rules"]}}, put.body["revision"]).status == 412);
    }

    TEST_CASE("Rules that are wrong name their place") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const json id = server.get("/v1/motions")["motions"][0]["id"];
        const auto refused = [&](const std::vector<json>& rules, const std::string& field) {
            const auto answer = server.put("/v1/rules", {{"rules", rules}});
            CHECK(answer.status == 400);
            CHECK(answer.field() == field);
        };
        const auto rule = [&](const std::string& word, const std::vector<json>& motions) {
            return json{{"word", word}, {"motions", motions}};
        };
        refused({rule("a", {id}), rule("b", {id}), rule("c", {"nothing"})}, "rules[2].motions[0]");
        refused({rule("a", {id}), rule("A", {id})}, "rules[1].word");
        refused({rule("two words", {id})}, "rules[0].word");
        refused({rule("", {id})}, "rules[0].word");
        refused({rule("a", {})}, "rules[0].motions");
        CHECK(server.get("/v1/rules")["rules"].empty());
        CHECK(!fs::exists(scratch / "kept/rules.json"));
    }

    TEST_CASE("Rules that cannot be read are put aside, not lost") {
        const Scratch scratch;
        spill(scratch / "kept/rules.json", "{\"rules\": [half");
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const json found = server.get("/v1/rules");
        CHECK(found["rules"].empty());
        REQUIRE(found["damaged"].size() == 1);
        CHECK(found["damaged"][0]["file"] == "rules.json");
        CHECK(server.put("/v1/rules", {{"rules", json::array()}}, found["revision"]).status == 200);
        CHECK(server.get("/v1/rules")["damaged"].empty());
        int aside = 0;
        for (const auto& entry : fs::directory_iterator(scratch / "kept"))
            if (contains(entry.path().filename().string(), "rules.json.damaged-")) {
                CHECK(slurp(entry.path()) == "{\"rules\": [half");
                ++aside;
            }
        CHECK(aside == 1);
    }

    TEST_CASE("Projects are kept as they are, newest first, and changed by revision") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        CHECK(server.get("/v1/projects")["projects"].empty());
        const auto first = server.post("/v1/projects", {{"name", "one"}, {"project", projectOf(1)}});
        REQUIRE(first.status == 201);
        const std::string path = "/v1/projects/" + first.body["id"].get<std::string>();
        const std::string revision = first.body["revision"];
        const auto second = server.post("/v1/projects", {{"name", "two"}, {"project", projectOf(2)}});
        json list = server.get("/v1/projects")["projects"];
        REQUIRE(list.size() == 2);
        CHECK(list[0]["id"] == second.body["id"]);
        CHECK(list[1]["revision"] == revision);
        CHECK(list[1]["bytes"] == projectOf(1).dump().size());
        const auto got = server.get(path);
        CHECK(got["project"] == projectOf(1));
        CHECK(got["name"] == "one");
        CHECK(got["revision"] == revision);
        const std::string saved = got["saved"];
        REQUIRE(saved.size() == 24);
        CHECK(saved.substr(0, 13) == replaced(shell("date -u +%Y-%m-%dT%H").out, "\n", ""));

        CHECK(server.put(path, {{"name", "one"}, {"project", projectOf(3)}}).status == 428);
        const auto put = server.put(path, {{"name", "uno"}, {"project", projectOf(3)}}, revision);
        REQUIRE(put.status == 200);
        CHECK(put.body["revision"] != revision);
        // Somebody who still has the old one.
        CHECK(server.put(path, {{"name", "one"}, {"project", projectOf(4)}}, revision).status == 412);
        CHECK(server.get(path)["project"] == projectOf(3));
        CHECK(server.get(path)["name"] == "uno");
        CHECK(server.get("/v1/projects")["projects"][0]["name"] == "uno");
        CHECK(server.client().Get(path)->get_header_value("ETag") ==
              "\"" + put.body["revision"].get<std::string>() + "\"");
        CHECK(server.remove(path, revision).status == 412);
        CHECK(server.remove(path).status == 204);
        CHECK(server.ask(path).status == 404);
        CHECK(server.put(path, {{"name", "x"}, {"project", projectOf(1)}}, put.body["revision"]).status ==
              404);
        CHECK(server.remove(path).status == 404);
    }

    TEST_CASE("Projects that are refused") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const auto refused = [&](const json& body, int status, const json& field) {
            const auto answer = server.post("/v1/projects", body);
            CHECK(answer.status == status);
            CHECK(answer.field() == field);
        };
        refused({{"name", "x"}, {"project", {{"number", 1}}}}, 400, "project.version");
        refused({{"name", "x"}, {"project", {{"version", "1"}}}}, 400, "project.version");
        refused({{"name", "x"}, {"project", {1, 2}}}, 400, "project");
        refused({{"name", ""}, {"project", projectOf(1)}}, 400, "name");
        refused({{"name", "x"}, {"project", projectOf(1)}, {"id", "../x"}}, 400, "id");
        json large = projectOf(1);
        large["text"] = std::string((16U << 20U) - 200, 'x');
        const auto fits = server.post("/v1/projects", {{"name", "large"}, {"project", large}});
        REQUIRE(fits.status == 201);
        CHECK(server.get("/v1/projects/" + fits.body["id"].get<std::string>())["project"] == large);
        large["text"] = std::string(16U << 20U, 'x');
        refused({{"name", "x"}, {"project", large}}, 413, "project");
        large["text"] = std::string(18U << 20U, 'x');
        refused({{"name", "x"}, {"project", large}}, 413, nullptr);
        CHECK(server.get("/v1/projects")["projects"].size() == 1);
        for (const char* id : {"rules", "0123456789abcdef", "x", "0123456789ABCDEF"})
            CHECK(server.ask(std::string("/v1/projects/") + id).status == 404);
    }

    TEST_CASE("A damaged project is named, hides no other, and is not written over") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const auto made = server.post("/v1/projects", {{"name", "one"}, {"project", projectOf(1)}}).body;
        const std::string id = made["id"];
        const std::string file = scratch / ("kept/projects/" + id + ".json");
        const std::string bytes = slurp(file);
        const auto good = server.post("/v1/projects", {{"name", "two"}, {"project", projectOf(2)}}).body;
        for (const std::string& spoilt :
             {bytes.substr(0, bytes.size() - 5), bytes + "x", std::string(), std::string("{}\n{}\n"),
              std::string(10'000, 'x'), replaced(bytes, "\"version\":1", "\"version\":9")}) {
            CAPTURE(spoilt.substr(0, 200));
            spill(file, spoilt);
            const json list = server.get("/v1/projects");
            REQUIRE(list["projects"].size() == 1);
            CHECK(list["projects"][0]["id"] == good["id"]);
            REQUIRE(list["damaged"].size() == 1);
            CHECK(list["damaged"][0]["file"] == "projects/" + id + ".json");
            const auto asked = server.ask("/v1/projects/" + id);
            CHECK(asked.status == 422);
            CHECK(contains(asked.message(), "projects/" + id + ".json"));
            CHECK(
                server.put("/v1/projects/" + id, {{"name", "x"}, {"project", projectOf(5)}}, made["revision"])
                    .status == 422);
            CHECK(slurp(file) == spoilt);
        }
        // A changed byte shows when it is read.
        spill(file, replaced(bytes, "\"number\":1", "\"number\":7"));
        CHECK(server.ask("/v1/projects/" + id).status == 422);
        CHECK(server.remove("/v1/projects/" + id).status == 204);
    }

    TEST_CASE("Two servers on one folder lose nothing of each other's") {
        const Scratch scratch;
        const StudioServer one{studioPartsIn(scratch / "kept")}, two{studioPartsIn(scratch / "kept")};
        const auto made = one.post("/v1/projects", {{"name", "count"}, {"project", projectOf(0)}}).body;
        const std::string path = "/v1/projects/" + made["id"].get<std::string>();
        std::atomic<int> saved = 0, beaten = 0;
        const auto count = [&](const StudioServer& server) {
            auto client = server.client();
            for (int i = 0; i < 25; ++i) {
                const auto got = client.Get(path);
                if (!got || got->status != 200) return;
                json next = json::parse(got->body);
                next["project"]["number"] = next["project"]["number"].get<int>() + 1;
                const auto put = client.Put(
                    path, httplib::Headers{{"If-Match", got->get_header_value("ETag")}},
                    json{{"name", "count"}, {"project", next["project"]}}.dump(), "application/json");
                if (put && put->status == 200) ++saved;
                if (put && put->status == 412) ++beaten;
                const auto motion =
                    client.Post("/v1/motions", motionNamed("same").dump(), "application/json");
                if (motion && motion->status == 201)
                    (void)client.Delete("/v1/motions/" + json::parse(motion->body)["id"].get<std::string>());
            }
        };
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i) threads.emplace_back([&, i] { count(i % 2 == 0 ? one : two); });
        for (std::thread& thread : threads) thread.join();
        CHECK(saved + beaten == 100);
        CHECK(saved >= 25);
        CHECK(one.get(path)["project"]["number"] == saved.load());
        CHECK(two.get(path) == one.get(path));
        CHECK(ownNames(one).size() <= 1);
    }

    TEST_CASE("Without a folder lists are empty, and nothing is kept") {
        const StudioServer server;
        CHECK(server.get("/v1/health")["folder"] == false);
        CHECK(server.get("/v1/projects")["projects"].empty());
        CHECK(server.get("/v1/rules")["rules"].empty());
        CHECK(ownNames(server).empty());
        for (const int status :
             {server.post("/v1/motions", motionNamed("x")).status,
              server.post("/v1/projects", {{"name", "x"}, {"project", projectOf(1)}}).status,
              server.put("/v1/rules", {{"rules", json::array()}}).status,
              server.remove("/v1/motions/0123456789abcdef").status,
              server.ask("/v1/projects/0123456789abcdef").status})
            CHECK(status == 409);
    }
}
