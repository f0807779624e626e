// Projects of the studio, of the form that its page writes (web/src/model/project.ts, version 2).
#include "assets/projects/studio_project.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/base64.hpp"
#include "text.hpp"

using namespace deixis;
using nlohmann::json;

namespace {

json frame() {
    json out = json::array();
    for (const double number : motion::numbersOf(motion::relaxedUpperBody())) out.push_back(number);
    return out;
}

/// Of 0.2 s: three frames.
json project() {
    return json::parse(R"({"format": "deixis-studio", "version": 2, "fps": 15, "log": [], "document": {
        "name": "Mall", "text": "Hello there.", "seed": 1,
        "speech": {"text": "Hello there.", "voice": "slt", "recording": null, "duration_s": 0.2, "accents": [], "pitch": [],
                   "words": [{"word": "Hello", "start_s": 0.0, "end_s": 0.1}, {"word": "there", "start_s": 0.1, "end_s": 0.2}],
                   "pitch_fps": 100, "wav": "UklGRg=="},
        "motion": {"system": "model", "synthetic": true, "madeFrom": "x", "frames": [], "tracks": {}},
        "poseControls": [{}, {}], "styleControls": [{}], "bypass": {"pose": false, "style": true},
        "finish": {"fade": false, "still": false, "relaxedFingers": false}}})");
}

json whole() {
    json out = project();
    for (int f = 0; f < 3; ++f) out["document"]["motion"]["frames"].push_back(frame());
    return out;
}

std::string problemOf(const json& file) {
    const auto read = assets::parseStudioProject(file.dump(), "mall.json");
    return read ? "none" : read.error().text();
}

json changed(const char* pointer, const json& value) {
    json out = whole();
    out[json::json_pointer(pointer)] = value;
    return out;
}

}  // namespace

TEST_SUITE("assets/studio_project") {
    TEST_CASE("What was authored is read: speech, sound, motion, and which controls were in use") {
        const auto read = assets::parseStudioProject(whole().dump(), "mall.json");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        CHECK(read->name == "Mall");
        CHECK(read->text == "Hello there.");
        CHECK(read->wav == "RIFF");
        REQUIRE(read->utterance.words.size() == 2);
        CHECK(read->utterance.words[1].text == "there");
        CHECK(read->utterance.words[1].start_s == 0.1);
        CHECK(read->motion.frames.size() == 3);
        CHECK(read->system == "model");
        CHECK(read->synthetic);
        CHECK(read->pose_controls == 2);
        CHECK(read->style_controls == 0);  // they are bypassed
        CHECK_FALSE(read->relaxed_fingers);
        json first = whole();
        first["version"] = 1;
        first["document"].erase("finish");
        CHECK(assets::parseStudioProject(first.dump(), "old.json")->relaxed_fingers);
    }

    TEST_CASE("What is no project, or not whole, is told with its key") {
        CHECK(tests::contains(problemOf("hello"), "mall.json"));
        CHECK(assets::parseStudioProject("{", "x.json").error().text().find("no project of the studio") !=
              std::string::npos);
        CHECK(tests::contains(problemOf(changed("/version", 3)),
                              "mall.json.version: found 3, expected at most 2"));
        CHECK(tests::contains(problemOf(changed("/document/motion", nullptr)),
                              "document.motion: is not there yet"));
        CHECK(tests::contains(problemOf(changed("/document/speech", nullptr)),
                              "document.speech: is not there yet"));
        CHECK(tests::contains(problemOf(changed("/document/speech/wav", "?")), "speech.wav"));
        CHECK(tests::contains(problemOf(changed("/document/speech/words/1/start_s", "soon")),
                              "speech.words[1].start_s: found \"soon\""));
        CHECK(tests::contains(problemOf(changed("/document/motion/frames/2", {1.0, 2.0})),
                              "motion.frames[2]: found"));
        CHECK(tests::contains(problemOf(changed("/document/motion/frames", json::array({frame()}))),
                              "motion.frames: found 1, expected 3 frames"));
        CHECK(tests::contains(problemOf(changed("/document/speech/duration_s", 1e12)), "duration_s"));
        CHECK(tests::contains(problemOf(changed("/document/bypass", 5)), "document.bypass: found 5"));
        CHECK_FALSE(assets::readStudioProject("/nowhere/mall.json").has_value());
    }

    TEST_CASE("Base64 of RFC 4648, section 10") {
        CHECK(decodeBase64("") == "");
        CHECK(decodeBase64("Zg==") == "f");
        CHECK(decodeBase64("Zm8=") == "fo");
        CHECK(decodeBase64("Zm9v") == "foo");
        CHECK(decodeBase64("Zm9vYmFy") == "foobar");
        CHECK(decodeBase64("Zm9vYg") == "foob");
        CHECK_FALSE(decodeBase64("Zm9v!").has_value());
        CHECK_FALSE(decodeBase64("Zm 9v").has_value());
    }
}
