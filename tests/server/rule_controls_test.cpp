// Gestures that kept rules put on the words of a request; and a motion that is read from a clip.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

constexpr const char* said = "This is a very big house, and it stands over there, behind the long river.";
constexpr int big = 4;  ///< that word's index

json asked(const json& more) {
    json request{{"text", said}, {"voice", quick_voice}, {"system", "keyframes"}, {"format", "json"}};
    request.update(more);
    return request;
}

StudioServer::Answered readClip(const StudioServer& server, const std::string& name,
                                const std::string& bytes) {
    const auto answer = server.client().Post(
        "/v1/motions/read", httplib::MultipartFormDataItems{
                                {"name", name, "", ""}, {"clip", bytes, name, "application/octet-stream"}});
    REQUIRE(answer);
    return {answer->status, json::parse(answer->body, nullptr, false)};
}

}  // namespace

TEST_SUITE("server/rule_controls") {
    TEST_CASE("A word's gesture stands in its middle, and the seed says which") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const json motions = server.get("/v1/motions")["motions"];
        std::vector<std::string> ids;
        for (const json& one : motions)
            if (one["frames"].size() < 30) ids.push_back(one["id"]);
        REQUIRE(ids.size() >= 3);
        ids.resize(3);
        REQUIRE(
            server.put("/v1/rules", {{"rules", json::array({{{"word", "BIG"}, {"motions", ids}}})}}).status ==
            200);
        CHECK_FALSE(server.post("/v1/generate", asked(json::object())).body.contains("rule_gestures"));
        // Of drawn(seed, 4) in web/src/model/rules.ts, run by node: which of three.
        for (const auto& [seed, which] :
             {std::pair<std::int64_t, std::size_t>{5, 1}, {6, 0}, {8, 2}, {4294967301, 1}}) {
            const auto made = server.post("/v1/generate", asked({{"rules", true}, {"seed", seed}}));
            REQUIRE_MESSAGE(made.status == 200, made.body.dump());
            REQUIRE(made.body["rule_gestures"].size() == 1);
            const json put = made.body["rule_gestures"][0];
            CHECK(put["word"] == big);
            CHECK(put["motion"] == ids[which]);
            const json& word = made.body["words"][big];
            const double middle_s = (word["start_s"].get<double>() + word["end_s"].get<double>()) / 2.0;
            const int start = put["start_frame"];
            const int count = put["frame_count"];
            CHECK(std::abs((start + count / 2.0) / 15.0 - middle_s) < 0.05);
            for (const json& one : motions)
                if (one["id"] == ids[which])
                    for (int k = 0; k < count; ++k)
                        CHECK(made.body["frames"][static_cast<std::size_t>(start + k)] ==
                              one["frames"][static_cast<std::size_t>(k)]);
        }
    }

    TEST_CASE("What the request itself asks for has the right of way") {
        const Scratch scratch;
        const StudioServer server{studioPartsIn(scratch / "kept")};
        const json motions = server.get("/v1/motions")["motions"];
        REQUIRE(server
                    .put("/v1/rules",
                         {{"rules", json::array({{{"word", "big"}, {"motions", {motions[0]["id"]}}}})}})
                    .status == 200);
        const json all = server.post("/v1/generate", asked(json::object())).body["frames"];
        const auto made = server.post(
            "/v1/generate", asked({{"rules", true},
                                   {"pose_controls", json::array({{{"start_frame", 0}, {"frames", all}}})}}));
        REQUIRE_MESSAGE(made.status == 200, made.body.dump());
        CHECK(made.body["rule_gestures"].empty());
        CHECK(made.body["words_without_room"] == json::array({big}));
        CHECK(made.body["frames"] == all);
    }
}

TEST_SUITE("server/read_route") {
    TEST_CASE("The avatar's own BVH and GLB files give the motion that they were made of") {
        const StudioServer server;
        const json frames = server.get("/v1/motions")["motions"][2]["frames"];
        for (const std::string format : {"bvh", "glb"}) {
            const auto file = server.client().Post(
                "/v1/export", json{{"frames", frames}, {"format", format}}.dump(), "application/json");
            REQUIRE(file);
            REQUIRE(file->status == 200);
            const auto read = readClip(server, "any." + format, file->body);
            REQUIRE_MESSAGE(read.status == 200, read.body.dump());
            CHECK(read.body["fps"] == 15);
            REQUIRE(read.body["frames"].size() >= frames.size());
            for (std::size_t i = 0; i < frames.size(); ++i)
                for (std::size_t k = 0; k < 27; ++k)
                    CHECK(std::abs(read.body["frames"][i][k].get<double>() - frames[i][k].get<double>()) <
                          0.02);
        }
    }

    TEST_CASE("What is no clip is refused with what was found") {
        const StudioServer server;
        for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"none.bvh", "HIERARCHY\nROOT"},
                                          {"none.glb", std::string("glTF\2\0\0\0", 8)},
                                          {"empty.csv", ""},
                                          {"../../etc/passwd", "root:x:0"}}) {
            const auto refused = readClip(server, name, bytes);
            CHECK(refused.status == 400);
            CHECK(refused.field() == "clip");
            CHECK(refused.message().size() > 10);
        }
        CHECK(server.post("/v1/motions/read", json::object()).status == 415);
    }
}
