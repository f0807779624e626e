// Voices that are programs, over the routes: a lab's own, and those of other languages.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>

#include "app/program.hpp"
#include "speech/sound/wav.hpp"
#include "speech/voice/helper_voices.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

speech::VoiceProgram voice(const std::string& name, const std::string& script, const std::string& language) {
    speech::VoiceProgram out;
    out.name = name;
    out.command = {"sh", "-c", script};
    out.timeout = std::chrono::milliseconds(3000);
    out.language = language;
    return out;
}

server::StudioParts partsWith(std::vector<speech::VoiceProgram> programs) {
    auto parts = studioParts();
    auto voices = speech::Voices::with(std::move(programs));
    REQUIRE_MESSAGE(voices.has_value(), (voices ? "" : voices.error().text()));
    parts.voices = std::move(*voices);
    return parts;
}

/// What flite says of it, as a file.
std::string spokenFile(const Scratch& scratch, const std::string& text) {
    const auto spoken = speech::speakByFlite(text, "slt");
    REQUIRE(spoken);
    REQUIRE(speech::writeWav(scratch / "spoken.wav", spoken->sound));
    return scratch / "spoken.wav";
}

}  // namespace

TEST_SUITE("server/voices") {
    TEST_CASE("A lab's own English voice: its words are found in its sound") {
        const Scratch scratch;
        const std::string text = "The big house stands by the river.";
        const std::string wav = spokenFile(scratch, text);
        const StudioServer server{
            partsWith({voice("anna", "cat > " + (scratch / "heard") + "; cat " + wav, "en")})};
        CHECK(server.get("/v1/health")["voices"].back() == json{{"name", "anna"}, {"language", "en"}});
        const auto spoken = server.post("/v1/speech", {{"text", text}, {"voice", "anna"}});
        REQUIRE_MESSAGE(spoken.status == 200, spoken.body.dump());
        CHECK(slurp(scratch / "heard") == text);
        CHECK(spoken.body["language"] == "en");
        CHECK(spoken.body["words_understood"] == true);
        REQUIRE(spoken.body["words"].size() == 7);
        const auto by_flite = server.post("/v1/speech", {{"text", text}, {"voice", "slt"}}).body;
        for (std::size_t i = 0; i < 7; ++i)
            CHECK(std::abs(spoken.body["words"][i]["start_s"].get<double>() -
                           by_flite["words"][i]["start_s"].get<double>()) < 0.1);
    }

    TEST_CASE("Another language: no words without their times, gestures by the sound alone") {
        const Scratch scratch;
        const std::string wav = spokenFile(scratch, "Nobody needs to understand this.");
        const StudioServer server{partsWith({voice("hans", "cat >/dev/null; cat " + wav, "de")})};
        CHECK(server.get("/v1/health")["other_languages"] == true);
        const auto made =
            server.post("/v1/generate", {{"text", "Das große Haus. Привет"}, {"voice", "hans"}});
        REQUIRE_MESSAGE(made.status == 200, made.body.dump());
        CHECK(made.body["language"] == "de");
        CHECK(made.body["words_understood"] == false);
        CHECK(made.body["words"].empty());
        CHECK(made.body["frames"].size() ==
              static_cast<std::size_t>(std::ceil(made.body["duration_s"].get<double>() * 15)));
    }

    TEST_CASE("A program that fails is told of, and the server goes on") {
        const StudioServer server{
            partsWith({voice("broken", "echo 'no such model' >&2; exit 3", "en"),
                       voice("silent", "cat >/dev/null", "en"), voice("noise", "echo this is no sound", "de"),
                       voice("slow", "sleep 60", "en"), voice("unheard", "exit 1", "de")})};
        const auto refused = [&](const std::string& name) {
            const auto answer = server.post("/v1/speech", {{"text", "Hello there."}, {"voice", name}});
            CHECK(answer.status == 502);
            CHECK(answer.field() == "voice");
            CHECK(contains(answer.message(), name));
            return answer.message();
        };
        CHECK(contains(refused("broken"), "ended with 3, expected 0; it says: no such model"));
        CHECK(contains(refused("silent"), "wrote nothing, expected a WAV file"));
        refused("noise");
        CHECK(contains(refused("slow"), "has not ended after 3.0 s"));
        refused("unheard");
        CHECK(server.post("/v1/generate", {{"text", "Hello."}, {"voice", "broken"}}).status == 502);
        CHECK(server.post("/v1/speech", {{"text", "Hello."}, {"voice", quick_voice}}).status == 200);
    }

    TEST_CASE("eSpeak's helper tells its languages, and when each word is said") {
        const std::string helper = (buildDir() / "deixis-espeak").string();
        if (!fs::exists(helper)) {
            tellSkipped("there is no deixis-espeak: build it with libespeak-ng-dev");
            return;
        }
        const auto voices = speech::voicesOfHelper(helper);
        REQUIRE_MESSAGE(voices.has_value(), (voices ? "" : voices.error().text()));
        CHECK(voices->size() > 50);
        const StudioServer server{partsWith(*voices)};
        const json health = server.get("/v1/health");
        const json german{{"name", "espeak-de"}, {"language", "de"}};
        CHECK(std::count(health["voices"].begin(), health["voices"].end(), german) == 1);
        CHECK(health["other_languages"] == true);
        const auto spoken = server.post(
            "/v1/speech", {{"text", "Das große Haus steht dort, 250 Meter weiter."}, {"voice", "espeak-de"}});
        REQUIRE_MESSAGE(spoken.status == 200, spoken.body.dump());
        std::vector<std::string> words;
        double last_s = 0.0;
        for (const json& word : spoken.body["words"]) {
            words.push_back(word["word"]);
            CHECK(word["start_s"].get<double>() >= last_s);
            last_s = word["end_s"];
            CHECK(last_s > word["start_s"].get<double>());
        }
        CHECK(words ==
              std::vector<std::string>{"Das", "große", "Haus", "steht", "dort", "250", "Meter", "weiter"});
        CHECK(last_s <= spoken.body["duration_s"].get<double>());
        CHECK(spoken.body["words_understood"] == false);
        // While nothing is said the sound is quiet, and in each word it is not.
        const auto wav = server.client().Get(spoken.body["sound"].get<std::string>());
        const auto sound = speech::readWavBytes(wav->body, "sound");
        REQUIRE(sound);
        for (const json& word : spoken.body["words"]) {
            float loudest = 0.0F;
            for (auto i = static_cast<std::size_t>(word["start_s"].get<double>() * sound->rate_hz);
                 i < static_cast<std::size_t>(word["end_s"].get<double>() * sound->rate_hz) &&
                 i < sound->samples.size();
                 ++i)
                loudest = std::max(loudest, std::abs(sound->samples[i]));
            CHECK(loudest > 0.05F);
        }
        CHECK(server.post("/v1/generate", {{"text", "Это большой дом."}, {"voice", "espeak-ru"}}).status ==
              200);
        CHECK(server.post("/v1/speech", {{"text", "..."}, {"voice", "espeak-de"}}).status == 502);
        CHECK(shell(helper + " --language xx </dev/null").status == 1);
        CHECK(shell(helper).status == 2);
    }
}
