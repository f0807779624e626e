// What POST /v1/generate makes gestures by: a trained model, rules, or keyframes alone; and how motions are
// finished.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "motion/gesture_weights.hpp"
#include "motion/speech_gestures/finishing.hpp"
#include "motion/speech_gestures/pose_control.hpp"
#include "speech/prosody/utterance.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

constexpr const char* model_said = "Yes, the shelf is over there, and it is very big, yes.";

server::StudioParts partsWithModel() {
    auto parts = studioParts();
    parts.model = motion::SpeechGestureModel::read(randomGestureWeights(smallGestureShape())).value();
    return parts;
}

json asking(const json& more = json::object()) {
    json request{{"text", model_said}, {"voice", quick_voice}, {"format", "json"}};
    request.update(more);
    return request;
}

json framesOf(const StudioServer& server, const json& more = json::object()) {
    const auto answer = server.post("/v1/generate", asking(more));
    REQUIRE_MESSAGE(answer.status == 200, answer.body.dump());
    return answer.body["frames"];
}

motion::UpperBodyPose poseOf(const json& numbers) {
    return motion::poseFromNumbers(numbers.get<std::vector<double>>()).value();
}

double farthest(const json& a, const json& b) {
    double out = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        out = std::max(out, std::abs(a[i].get<double>() - b[i].get<double>()));
    return out;
}

/// Arms straight out to the sides.
json stretched(json pose) {
    const std::vector<double> out{1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    for (std::size_t i = 0; i < 6; ++i) {
        pose[12 + i] = out[i];
        pose[21 + i] = -out[i];
    }
    return pose;
}

json posesAt(int frame, const json& pose) {
    return json::array({{{"start_frame", frame}, {"frames", json::array({pose})}}});
}

}  // namespace

TEST_SUITE("server/gesture_systems") {
    TEST_CASE("Health says which there are, what each takes, and where motions begin and end") {
        const json with = StudioServer(partsWithModel()).get("/v1/health");
        CHECK(with["systems"] == json::array({"model", "rules", "keyframes"}));
        CHECK(with["gestures"][0]["takes"] == json::array({"pose_controls", "style_controls", "keep", "exact",
                                                           "variety", "fade", "still", "relaxed_fingers"}));
        CHECK(with["gestures"][2]["takes"] ==
              json::array({"pose_controls", "fade", "still", "relaxed_fingers"}));
        CHECK(with["mean_pose"].size() == 27);
        const json without = StudioServer().get("/v1/health");
        CHECK(without["systems"] == json::array({"rules", "keyframes"}));
        CHECK(StudioServer().post("/v1/generate", asking({{"system", "model"}})).field() == "system");
    }

    TEST_CASE("The model is what makes gestures where there is one, of the sound at 16 kHz and its words") {
        const StudioServer server(partsWithModel());
        const auto answer = server.post("/v1/generate", asking());
        REQUIRE(answer.status == 200);
        CHECK(answer.body["system"] == "model");
        CHECK(answer.body["synthetic"] == true);
        const auto spoken = speech::spokenText(speech::Voices{}, nullptr, model_said, quick_voice);
        REQUIRE(spoken);
        motion::SpeechGestureRequest request;
        const speech::Sound sound = speech::resampled(spoken->sound, 16000);
        request.samples = sound.samples;
        request.utterance = spoken->utterance;
        request.duration_s = spoken->utterance.duration_s;
        const auto made = partsWithModel().model->generate(request).value();
        REQUIRE(answer.body["frames"].size() == made.frames.size());
        for (std::size_t f = 0; f < made.frames.size(); ++f) {
            const auto numbers = motion::numbersOf(made.frames[f]);
            for (std::size_t k = 0; k < numbers.size(); ++k)
                CHECK(std::abs(answer.body["frames"][f][k].get<double>() - numbers[k]) < 1e-6);
        }
        CHECK(framesOf(server, {{"seed", 2}}) == answer.body["frames"]);
        CHECK(framesOf(server, {{"variety", 1.0}, {"seed", 2}}) != framesOf(server, {{"variety", 1.0}}));
        CHECK(framesOf(server, {{"system", "rules"}}) != answer.body["frames"]);
    }

    TEST_CASE(
        "The model comes near to poses, and meets them to the bit where it is told to; style moves it") {
        const StudioServer server(partsWithModel());
        const json plain = framesOf(server), pose = stretched(plain[20]);
        const json near = framesOf(server, {{"pose_controls", posesAt(20, pose)}});
        CHECK(near[20] != pose);
        CHECK(near[20] != plain[20]);
        const json met = framesOf(server, {{"pose_controls", posesAt(20, pose)}, {"exact", true}});
        CHECK(met[20] == pose);
        CHECK(met[5] == near[5]);
        const json styled = framesOf(
            server,
            {{"style_controls", json::array({{{"start_frame", 0}, {"frame_count", 30}, {"speed", 0.0}}})}});
        CHECK(styled != plain);  // 0 is a value
    }

    TEST_CASE("Of a motion that is kept the model makes the range alone, whatever is asked beside it") {
        const StudioServer server(partsWithModel());
        const json plain = framesOf(server);
        const json keep{{"frames", plain}, {"from_frame", 15}, {"to_frame", 35}};
        const json pose = stretched(plain[25]);
        for (const json& more : {json::object(), json{{"still", true}}, json{{"fade", true}}}) {
            json wanted{{"keep", keep}, {"pose_controls", posesAt(25, pose)}};
            wanted.update(more);
            const json again = framesOf(server, wanted);
            REQUIRE(again.size() == plain.size());
            for (std::size_t f = 0; f < plain.size(); ++f)
                if (f < 15 || f >= 35) CHECK(again[f] == plain[f]);
            CHECK(again[25] != plain[25]);
        }
    }

    TEST_CASE("Keyframes alone: splines through the poses, the mean pose at both ends, and nothing else") {
        const StudioServer server(partsWithModel());
        const json mean = server.get("/v1/health")["mean_pose"];
        const json pose = stretched(mean);
        const json made = framesOf(server, {{"system", "keyframes"}, {"pose_controls", posesAt(20, pose)}});
        CHECK(made[20] == pose);
        CHECK(farthest(made.front(), mean) < 1e-5);
        CHECK(farthest(made.back(), mean) < 1e-5);
        const auto by_hand = motion::motionThroughKeyframes({{20, poseOf(pose)}}, made.size(), poseOf(mean));
        for (std::size_t f = 0; f < made.size(); ++f)
            CHECK(farthest(made[f], json(motion::numbersOf(by_hand.frames[f]))) < 1e-5);
        const json style = json::array({{{"start_frame", 0}, {"frame_count", 5}, {"speed", 1.0}}});
        const json keep{{"frames", made}, {"from_frame", 1}, {"to_frame", 9}};
        for (const auto& [field, value] :
             {std::pair<std::string, json>("style_controls", style), {"keep", keep}, {"variety", 0.5}}) {
            const auto refused =
                server.post("/v1/generate", asking({{"system", "keyframes"}, {field, value}}));
            CHECK(refused.status == 400);
            CHECK(refused.field() == field);
        }
        CHECK(server.post("/v1/generate", asking({{"system", "rules"}, {"variety", 0.5}})).field() ==
              "variety");
    }

    TEST_CASE("Fading ends at the mean pose after the last word; without gestures the body stands still") {
        const StudioServer server(partsWithModel());
        const auto answer = server.post("/v1/generate", asking({{"fade", true}}));
        const json &faded = answer.body["frames"], mean = server.get("/v1/health")["mean_pose"];
        const json plain = framesOf(server);
        CHECK(farthest(faded.back(), mean) < 1e-5);
        const double last_word_s = answer.body["words"].back()["end_s"];
        const auto first = std::min(static_cast<std::size_t>(last_word_s * 15.0), plain.size() - 8);
        for (std::size_t f = 0; f <= first; ++f) CHECK(faded[f] == plain[f]);
        CHECK(faded[first + 3] != plain[first + 3]);

        motion::UpperBodyMotion wanted;
        for (const json& frame : plain) wanted.frames.push_back(poseOf(frame));
        motion::holdStill(wanted);
        const json still = framesOf(server, {{"still", true}});
        for (std::size_t f = 0; f < plain.size(); ++f)
            CHECK(farthest(still[f], json(motion::numbersOf(wanted.frames[f]))) < 1e-5);
    }

    TEST_CASE("Fingers are relaxed unless they shall not be") {
        const StudioServer server;
        const auto tracks = [&server](bool relaxed) {
            return server.post("/v1/generate", asking({{"relaxed_fingers", relaxed}})).body["tracks"];
        };
        const json relaxed = tracks(true), stretched_out = tracks(false);
        CHECK(relaxed != stretched_out);
        CHECK(relaxed == server.post("/v1/generate", asking()).body["tracks"]);
    }
}
