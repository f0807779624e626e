// POST /v1/generate, checked against the rule set, the speech and the BVH reader by themselves.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "motion/unit_gestures/rule_set_a.hpp"
#include "speech/prosody/utterance.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

constexpr const char* said = "This is a very big house, and it stands over there, behind the long river.";

json requestFor(const json& more = json::object()) {
    json request{{"text", said}, {"voice", quick_voice}};
    request.update(more);
    return request;
}

}  // namespace

TEST_SUITE("server/generate_route") {
    TEST_CASE("A text becomes the speech's words and the rules' motion, as long as the sound") {
        const StudioServer server;
        const auto answer = server.post("/v1/generate", requestFor({{"seed", 5}}));
        REQUIRE_MESSAGE(answer.status == 200, answer.body.dump());
        const json& made = answer.body;
        const auto spoken = speech::spokenText(speech::Voices{}, nullptr, said, quick_voice);
        REQUIRE(spoken);
        REQUIRE(made["words"].size() == spoken->utterance.words.size());
        for (std::size_t i = 0; i < spoken->utterance.words.size(); ++i) {
            CHECK(made["words"][i]["word"] == spoken->utterance.words[i].text);
            CHECK(std::abs(made["words"][i]["start_s"].get<double>() - spoken->utterance.words[i].start_s) <
                  1e-6);
        }
        CHECK(made["accents"].size() == spoken->utterance.accents.size());
        const double duration_s = made["duration_s"];
        CHECK(std::abs(duration_s - spoken->utterance.duration_s) < 1e-6);
        CHECK(made["fps"] == 15);
        CHECK(made["system"] == "rules");
        CHECK(made["synthetic"] == true);
        CHECK(made["frames"].size() == static_cast<std::size_t>(std::ceil(duration_s * 15.0)));
        const auto motion = motion::gesturesByRuleSetA(spoken->utterance, studioParts().library, 5).motion;
        double moved = 0.0;
        for (std::size_t i = 0; i < motion.frames.size(); ++i) {
            const auto numbers = motion::numbersOf(motion.frames[i]);
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                CHECK(std::abs(made["frames"][i][k].get<double>() - numbers[k]) < 1e-6);
                moved += std::abs(numbers[k] - motion::numbersOf(motion.frames[0])[k]);
            }
        }
        CHECK(moved > 1.0);
        CHECK(made["tracks"]["rotations"].size() == made["frames"].size());
        const auto bvh = assets::parseBvh(made["bvh"].get<std::string>(), "answer.bvh");
        REQUIRE_MESSAGE(bvh.has_value(), (bvh ? "" : bvh.error().text()));
        CHECK(std::abs(bvh->clip.frame_time_s - 1.0 / 15.0) < 1e-6);
        CHECK(bvh->clip.duration_s() >= duration_s - 1e-5);
        CHECK(bvh->clip.duration_s() - bvh->clip.frame_time_s < duration_s);
        CHECK(server.client().Get(made["sound"].get<std::string>())->status == 200);
    }

    TEST_CASE(
        "The same request gives the same bytes, another seed another motion, the speech's id the same "
        "speech") {
        const StudioServer server;
        const auto first = server.post("/v1/generate", requestFor());
        CHECK(server.post("/v1/generate", requestFor({{"seed", 1}})).body == first.body);
        const auto other = server.post("/v1/generate", requestFor({{"seed", 2}}));
        CHECK(other.body["speech_id"] == first.body["speech_id"]);
        CHECK(other.body["frames"] != first.body["frames"]);
        CHECK(server.post("/v1/generate", {{"speech_id", first.body["speech_id"]}}).body == first.body);
        const StudioServer fresh;
        CHECK(fresh.post("/v1/generate", requestFor()).body == first.body);
    }

    TEST_CASE("Formats") {
        const StudioServer server;
        const auto alone = server.post("/v1/generate", requestFor({{"format", "json"}})).body;
        CHECK(!alone.contains("bvh"));
        CHECK(!alone.contains("csv"));
        const auto csv = server.post("/v1/generate", requestFor({{"format", "csv"}})).body;
        CHECK(!csv.contains("bvh"));
        CHECK(csv["frames"] == alone["frames"]);
        CHECK(csv["csv"].get<std::string>().starts_with("frame,time,"));
    }

    TEST_CASE("Poses that are asked for are met to the bit, and far from them nothing changes") {
        const StudioServer server;
        const json plain = server.post("/v1/generate", requestFor({{"format", "json"}})).body["frames"];
        // Both arms straight out to the sides at frames 20 and 21; see framesShape() for the order.
        json pose = plain[20];
        const std::vector<double> out{1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
        for (std::size_t i = 0; i < 6; ++i) {
            pose[12 + i] = out[i];
            pose[21 + i] = -out[i];
        }
        const json controls = json::array({{{"start_frame", 20}, {"frames", json::array({pose, pose})}}});
        const auto answer =
            server.post("/v1/generate", requestFor({{"format", "json"}, {"pose_controls", controls}}));
        REQUIRE_MESSAGE(answer.status == 200, answer.body.dump());
        const json& met = answer.body["frames"];
        REQUIRE(met.size() == plain.size());
        CHECK(met[20] == pose);
        CHECK(met[21] == pose);
        CHECK(met[18] != plain[18]);
        CHECK(met.back() == plain.back());
        // The avatar's own arm is there, too: tracks turn other than without the pose.
        CHECK(answer.body["tracks"]["rotations"][20] !=
              server.post("/v1/generate", requestFor({{"format", "json"}})).body["tracks"]["rotations"][20]);
    }

    TEST_CASE("Style changes the frames that it is asked for, and 0 nothing") {
        const StudioServer server;
        const json plain = server.post("/v1/generate", requestFor({{"format", "json"}})).body["frames"];
        const auto styled = [&](double speed) {
            const json controls =
                json::array({{{"start_frame", 30}, {"frame_count", 30}, {"speed", speed}, {"space", speed}}});
            return server.post("/v1/generate", requestFor({{"format", "json"}, {"style_controls", controls}}))
                .body["frames"];
        };
        CHECK(styled(0.0) == plain);
        const json fast = styled(3.0);
        REQUIRE(fast.size() == plain.size());
        CHECK(fast[45] != plain[45]);
        CHECK(fast[10] == plain[10]);
        CHECK(fast.back() == plain.back());
    }

    TEST_CASE("Of a motion that is kept only the range is made anew") {
        const StudioServer server;
        const json first =
            server.post("/v1/generate", requestFor({{"format", "json"}, {"seed", 1}})).body["frames"];
        const json keep{{"frames", first}, {"from_frame", 20}, {"to_frame", 50}};
        const json again =
            server.post("/v1/generate", requestFor({{"format", "json"}, {"seed", 2}, {"keep", keep}}))
                .body["frames"];
        REQUIRE(again.size() == first.size());
        int changed = 0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            if (i < 20 || i >= 50)
                CHECK(again[i] == first[i]);
            else
                changed += again[i] != first[i] ? 1 : 0;
        }
        CHECK(changed > 20);
    }

    TEST_CASE("Requests that cannot be done name their field") {
        const StudioServer server;
        const auto refused = [&](const json& request, int status, const json& field) {
            CAPTURE(request);
            const auto answer = server.post("/v1/generate", request);
            CHECK(answer.status == status);
            CHECK(answer.field() == field);
            return answer.message();
        };
        refused(requestFor({{"colour", "red"}}), 400, "colour");
        refused(json::object(), 400, "text");
        refused(requestFor({{"speech_id", "abc"}}), 400, "text");
        CHECK(contains(refused({{"speech_id", "abc"}}, 404, "speech_id"), "Send the text"));
        refused(requestFor({{"voice", "nobody"}}), 400, "voice");
        refused(requestFor({{"seed", -1}}), 400, "seed");
        refused(requestFor({{"format", "fbx"}}), 400, "format");
        refused(requestFor({{"system", "magic"}}), 400, "system");
        refused({{"text", "Привет"}}, 400, "text");
        refused({{"text", "   "}}, 400, "text");
        const json frames = server.post("/v1/generate", requestFor({{"format", "json"}})).body["frames"];
        const auto poses = [&](const json& start, const json& some) {
            return requestFor({{"pose_controls", json::array({{{"start_frame", start}, {"frames", some}}})}});
        };
        refused(poses(frames.size() - 1, json::array({frames[0], frames[0]})), 400,
                "pose_controls[0].frames");
        json crooked = frames[0];
        for (std::size_t i = 0; i < 3; ++i) crooked[i] = 0.0;
        refused(poses(0, json::array({crooked})), 400, "pose_controls[0].frames[0]");
        refused(requestFor(
                    {{"keep", {{"frames", json::array({frames[0]})}, {"from_frame", 0}, {"to_frame", 1}}}}),
                400, "keep.frames");
        refused(requestFor({{"keep", {{"frames", frames}, {"from_frame", 5}, {"to_frame", 5}}}}), 400,
                "keep.to_frame");
        const auto style = [&](const json& more) {
            json control{{"start_frame", 0}, {"frame_count", 5}};
            control.update(more);
            return requestFor({{"style_controls", json::array({control})}});
        };
        refused(style({{"speed", 3.1}}), 400, "style_controls[0].speed");
        refused(style({{"frame_count", frames.size() + 1}}), 400, "style_controls[0].frame_count");
        refused(style({{"acceleration", 1}}), 400, "style_controls[0].acceleration");
    }

    TEST_CASE("Fifty requests at the same time each get their own") {
        const StudioServer server;
        const json first = server.post("/v1/generate", requestFor({{"seed", 0}, {"format", "json"}})).body;
        std::atomic<int> right = 0;
        std::vector<std::thread> threads;
        for (int i = 0; i < 50; ++i)
            threads.emplace_back([&, i] {
                auto client = server.client();
                const auto answer =
                    client.Post("/v1/generate", requestFor({{"seed", i % 2}, {"format", "json"}}).dump(),
                                "application/json");
                if (!answer || answer->status != 200) return;
                const bool same = json::parse(answer->body)["frames"] == first["frames"];
                if (same == (i % 2 == 0)) ++right;
            });
        for (std::thread& thread : threads) thread.join();
        CHECK(right == 50);
    }
}
