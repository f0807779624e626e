// Speech and the avatar by the routes, checked against the rooms that do them.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/upper_body/upper_body.hpp"
#include "speech/sound/wav.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

json framesOf(const json& motion) {
    return motion["frames"];
}

}  // namespace

TEST_SUITE("server/speech_routes") {
    TEST_CASE("A spoken text: its sound is there, as long as it says, and the same for the same text") {
        const StudioServer server;
        const json request{{"text", "The big house stands by the river."}, {"voice", quick_voice}};
        const auto spoken = server.post("/v1/speech", request);
        REQUIRE(spoken.status == 200);
        CHECK(spoken.body["words"].size() == 7);
        CHECK(spoken.body["words"][1]["word"] == "big");
        const std::string path = spoken.body["sound"];
        CHECK(path == "/v1/speech/" + spoken.body["speech_id"].get<std::string>() + ".wav");
        const auto wav = server.client().Get(path);
        REQUIRE(wav);
        CHECK(wav->get_header_value("Content-Type") == "audio/wav");
        const auto sound = speech::readWavBytes(wav->body, "sound");
        REQUIRE(sound);
        const double duration_s = spoken.body["duration_s"];
        CHECK(std::abs(speech::durationOf(*sound) - duration_s) < 1e-6);
        CHECK(spoken.body["pitch"].size() == static_cast<std::size_t>(std::ceil(duration_s * 100.0)));
        CHECK(server.post("/v1/speech", request).body == spoken.body);
        const StudioServer other;
        CHECK(other.post("/v1/speech", request).body == spoken.body);
    }

    TEST_CASE("A recording is aligned to its text") {
        const StudioServer server;
        const std::string text = "The big house stands by the river.";
        const auto spoken = server.post("/v1/speech", {{"text", text}}).body;
        const auto wav = server.client().Get(spoken["sound"].get<std::string>());
        const auto upload = [&](const std::string& bytes, const std::string& said) {
            const auto answer = server.client().Post(
                "/v1/speech", httplib::MultipartFormDataItems{{"sound", bytes, "a.wav", "audio/wav"},
                                                              {"text", said, "", ""}});
            REQUIRE(answer);
            return StudioServer::Answered{answer->status, json::parse(answer->body)};
        };
        const auto recorded = upload(wav->body, text);
        REQUIRE_MESSAGE(recorded.status == 200, recorded.body.dump());
        REQUIRE(recorded.body["words"].size() == 7);
        for (std::size_t i = 0; i < 7; ++i)
            CHECK(std::abs(recorded.body["words"][i]["start_s"].get<double>() -
                           spoken["words"][i]["start_s"].get<double>()) < 0.1);
        const auto broken = upload("RIFF", text);
        CHECK(broken.status == 400);
        CHECK(broken.field() == "sound");
        const auto other =
            upload(wav->body, "Nobody has ever said anything of this kind about seventeen elephants.");
        CHECK(other.status == 400);
        CHECK(other.field() == "text");
    }

    TEST_CASE("Texts that cannot be spoken say why") {
        const StudioServer server;
        const auto refused = [&](const std::string& text) {
            const auto answer = server.post("/v1/speech", {{"text", text}, {"voice", quick_voice}});
            CHECK(answer.status == 400);
            CHECK(answer.field() == "text");
            return answer.message();
        };
        CHECK(contains(refused("Привет"), "Cyrillic"));
        refused("...");
        std::string long_text;
        for (int i = 0; i < 10'000; ++i) long_text += "word ";
        CHECK(contains(refused(long_text), "4000"));
    }

    TEST_CASE("Speeches that were not used for long are forgotten, and that is said") {
        auto parts = studioParts();
        parts.kept_speech_bytes = 400'000;
        const StudioServer server{std::move(parts)};
        const auto speak = [&](const std::string& text) {
            return server.post("/v1/speech", {{"text", text}, {"voice", quick_voice}})
                .body["sound"]
                .get<std::string>();
        };
        const std::string first = speak("The first sentence is spoken.");
        const std::string second = speak("The second sentence is spoken.");
        auto client = server.client();
        CHECK(client.Get(first)->status == 200);  // used again: the second one is older now
        for (const char* text : {"Three more are spoken.", "And another one of them."}) speak(text);
        int kept = 0;
        for (const std::string& path : {first, second}) kept += client.Get(path)->status == 200 ? 1 : 0;
        CHECK(kept <= 1);
        const auto gone = client.Get(second);
        CHECK(gone->status == 404);
        checkError(gone->body, nullptr);
        CHECK(contains(gone->body, "Send the text or the sound again"));
        CHECK(speak("The second sentence is spoken.") == second);
        CHECK(client.Get(second)->status == 200);
        const auto part = client.Get(second, httplib::Headers{{"Range", "bytes=0-3"}});
        CHECK(part->status == 206);
        CHECK(part->body == "RIFF");
    }

    TEST_CASE("The library, its motion on the avatar, and as files") {
        const StudioServer server;
        const json motions = server.get("/v1/motions")["motions"];
        CHECK(motions.size() == studioParts().library.size());
        const json& one = motions[0];
        const json frames = framesOf(one);
        const double duration_s = one["duration_s"];
        // A gesture's frames include its last moment.
        CHECK(std::abs(static_cast<double>(frames.size()) - duration_s * 15.0) <= 1.5);
        const json tracks = server.post("/v1/tracks", {{"frames", frames}}).body["tracks"];
        CHECK(tracks["rotations"].size() == frames.size());
        for (const json& row : tracks["rotations"]) {
            REQUIRE(row.size() == 4 * tracks["bones"].size());
            for (std::size_t i = 0; i < row.size(); i += 4)
                CHECK(std::abs(std::hypot(std::hypot(row[i].get<double>(), row[i + 1].get<double>()),
                                          std::hypot(row[i + 2].get<double>(), row[i + 3].get<double>())) -
                               1.0) < 1e-5);
        }
        for (const json& bone : tracks["bones"])
            CHECK(motion::referenceHumanoid().find(bone.get<std::string>()) >= 0);

        for (const double length_s : {1.0, 1.01, 0.02, 2.0 / 3.0}) {
            CAPTURE(length_s);
            json some = json::array();
            for (std::size_t i = 0; i < motion::frameCountOf(length_s); ++i)
                some.push_back(frames[i % frames.size()]);
            const json request{{"frames", some}, {"duration_s", length_s}};
            const auto file = server.client().Post("/v1/export", request.dump(), "application/json");
            REQUIRE(file->status == 200);
            const auto bvh = assets::parseBvh(file->body, "answer.bvh");
            REQUIRE_MESSAGE(bvh.has_value(), (bvh ? "" : bvh.error().text()));
            CHECK(bvh->clip.duration_s() >= length_s - 1e-6);
            CHECK(bvh->clip.duration_s() - bvh->clip.frame_time_s < length_s - 1e-6);
            json long_one = request;
            long_one["frames"].push_back(frames[0]);
            const auto refused = server.post("/v1/export", long_one);
            CHECK(refused.status == 400);
            CHECK(refused.field() == "frames");
        }
        json standing = json::array({frames[0]});
        for (std::size_t i = 0; i < 3; ++i) standing[0][i] = 0.0;
        const auto refused = server.post("/v1/tracks", {{"frames", standing}});
        CHECK(refused.status == 400);
        CHECK(refused.field() == "frames[0]");
    }
}
