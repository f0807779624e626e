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
        json silent = changed("/document/speech", nullptr);
        silent["document"]["text"] = " \n";
        CHECK(tests::contains(problemOf(silent), "document.speech: is not there yet"));
        json recorded = changed("/document/speech", nullptr);
        recorded["document"]["recording"] = {{"id", "1"}};
        CHECK(tests::contains(problemOf(recorded), "document.speech: is not there yet"));
        CHECK(tests::contains(problemOf(changed("/document/motion", nullptr)),
                              "document.poseControls[0].start: found null, expected a number"));
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

    TEST_CASE("Of a project without gestures what they are to be made of is read, as the page asks for it") {
        json file = changed("/document/motion", nullptr);
        json& document = file["document"];
        document["system"] = "model";
        document["seed"] = 7;
        document["bypass"]["style"] = false;
        document["poseControls"] =
            json::array({{{"start", 0}, {"length", 3}, {"base", {frame(), frame()}}, {"mirrored", true}}});
        document["styleControls"] =
            json::array({{{"start", 0},
                          {"length", 3},
                          {"speed", {{{"at", 0}, {"value", -1}}, {{"at", 1}, {"value", 2}}}},
                          {"space", 0.5},
                          {"handedness", nullptr}}});
        const auto read = assets::parseStudioProject(file.dump(), "x.json");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        CHECK(read->motion.frames.empty());
        const auto wanted = assets::wantedOf(*read, 3);
        REQUIRE_MESSAGE(wanted.has_value(), (wanted ? "" : wanted.error().text()));
        CHECK(wanted->maker == motion::GestureMaker::model);
        CHECK(wanted->seed == 7);
        REQUIRE(wanted->poses.size() == 3);
        CHECK(wanted->poses[1].frame == 1);
        REQUIRE(wanted->styles.size() == 3);
        CHECK(wanted->styles[0].speed == -1.0);
        CHECK(wanted->styles[1].speed == 0.5);
        CHECK(wanted->styles[2].speed == 2.0);
        CHECK(wanted->styles[1].space == 0.5);
        CHECK_FALSE(wanted->styles[1].handedness.has_value());
        CHECK(tests::contains(assets::wantedOf(*read, 2).error().text(),
                              "poseControls[0]: ends at frame 3, expected at most 2"));
        document["system"] = "magic";
        CHECK(tests::contains(problemOf(file), "document.system: found \"magic\""));
        document["system"] = "keyframes";
        const auto by_hand = assets::parseStudioProject(file.dump(), "x.json");
        CHECK(assets::wantedOf(*by_hand, 3)->styles.empty());

        // What authors begin with.
        const auto begun = assets::parseStudioProject(assets::withoutControls(whole().dump()), "x.json");
        REQUIRE_MESSAGE(begun.has_value(), (begun ? "" : begun.error().text()));
        CHECK(begun->motion.frames.empty());
        CHECK(begun->pose_controls == 0);
        CHECK(begun->style_controls == 0);
        CHECK(begun->wav == "RIFF");
        CHECK(begun->text == "Hello there.");
    }

    TEST_CASE("A project without a speech is read by its text and voice") {
        json file = changed("/document/speech", nullptr);
        file["document"]["motion"] = nullptr;
        file["document"]["poseControls"] = json::array();
        file["document"]["voice"] = "slt";
        file["author"] = "A1";
        const auto read = assets::parseStudioProject(file.dump(), "x.json");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        CHECK(read->text == "Hello there.");
        CHECK(read->voice == "slt");
        CHECK(read->author == "A1");
        CHECK(read->wav.empty());
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
