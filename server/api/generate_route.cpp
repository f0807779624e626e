// Gestures to a speech.
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "assets/joints/bvh.hpp"
#include "assets/joints/joint_positions.hpp"
#include "gesture_making.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "motion_json.hpp"
#include "rule_controls.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

constexpr double largest_seed = 9007199254740991.0;  // of JavaScript

std::vector<ShapeField> generatedFields() {
    auto fields = speechFields();
    fields.push_back(mustField("system", textShape("Which made it", 1)));
    fields.push_back(mustField(
        "synthetic",
        booleanShape("The system works by rules, or was trained on gestures that were made by rules")));
    fields.push_back(mustField("fps", integerShape("Frames a second", 15, 15)));
    fields.push_back(mustField("frames", framesShape()));
    fields.push_back(mustField("tracks", tracksShape()));
    fields.push_back(mayField(
        "bvh", textShape("With format bvh: the avatar's motion as a BVH file, as long as the sound")));
    fields.push_back(mayField("csv", textShape("With format csv: positions of the avatar's joints")));
    const Shape number = integerShape("", 0, 1e6);
    fields.push_back(mayField(
        "rule_gestures",
        listShape("With rules: what they put on which words",
                  objectShape("", {mustField("word", integerShape("Index of it", 0, 1e6)),
                                   mustField("motion", textShape("Its id", 1)),
                                   mustField("start_frame", number), mustField("frame_count", number)}))));
    fields.push_back(
        mayField("words_without_room",
                 listShape("With rules: words that have one, and no room for its gesture", number)));
    return fields;
}

nlohmann::json ruleGesturesJson(const RuleControls& controls) {
    nlohmann::json out = nlohmann::json::array();
    for (const RuleGesture& one : controls.put)
        out.push_back({{"word", one.word},
                       {"motion", one.motion},
                       {"start_frame", one.start_frame},
                       {"frame_count", one.frame_count}});
    return out;
}

Answer generated(StudioWork& work, nlohmann::json asked) {
    const auto speech = asked.contains("speech_id") ? work.find(asked["speech_id"], "speech_id")
                                                    : work.speak(asked["text"], asked["voice"]);
    if (!speech) return tl::unexpected(speech.error());
    const Utterance& utterance = (*speech)->spoken.utterance;
    std::optional<RuleControls> by_rules;
    if (asked["rules"]) by_rules = addRuleControls(work, utterance, asked);
    auto made = gesturesTo(**speech, work.parts(), asked);
    if (!made) return tl::unexpected(made.error());
    const motion::Clip clip = work.onAvatar(motion::avatarClip(made->motion, asked["relaxed_fingers"]));
    nlohmann::json out = speechJson(**speech);
    if (by_rules) {
        out["rule_gestures"] = ruleGesturesJson(*by_rules);
        out["words_without_room"] = by_rules->no_room;
    }
    out["system"] = asked["system"];
    const auto systems = gestureSystems(work.parts());
    out["synthetic"] =
        std::ranges::find(systems, asked["system"].get<std::string>(), &GestureSystem::name)->synthetic;
    out["fps"] = static_cast<int>(motion::upper_body_fps);
    out["frames"] = std::move(made->frames);
    out["tracks"] = tracksJson(clip);
    const std::string format = asked["format"];
    if (format == "bvh") out["bvh"] = assets::writeBvh(motion::heldFor(clip, utterance.duration_s));
    if (format == "csv") out["csv"] = assets::writeJointCsv(motion::heldFor(clip, utterance.duration_s));
    return jsonReply(out);
}

}  // namespace

Route generateRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "POST";
    route.path = "/v1/generate";
    route.name = "generate";
    route.about =
        "Gestures to a text, which is spoken first, or to a speech that the server keeps. The same request "
        "gives the same "
        "motion.";
    std::vector<std::string> systems;
    for (const GestureSystem& one : gestureSystems(work->parts())) systems.push_back(one.name);
    Shape body = objectShape(
        "", {textField(false), mayField("speech_id", textShape("Of a speech that the server keeps", 1, 64)),
             voiceField(*work), mayField("seed", integerShape("Of random choices", 0, largest_seed), 1),
             mayField("format",
                      choiceShape("What comes beside frames; json: nothing", {"bvh", "json", "csv"}), "bvh"),
             mayField("system", choiceShape("Which makes the gestures", systems), systems.front())});
    body.fields.push_back(mayField(
        "rules", booleanShape("Puts gestures on words by the kept rules (/v1/rules), as pose_controls"),
        false));
    body.fields.push_back(relaxedFingersField());
    for (ShapeField& field : controlFields()) body.fields.push_back(std::move(field));
    body.exactly_one = {"text", "speech_id"};
    route.body = std::move(body);
    route.max_body_bytes = largest_motion_bytes;
    route.outcomes = {
        {200, "The speech and its gestures", "application/json", objectShape("", generatedFields())}};
    route.run = [work](const Call& call) { return generated(*work, call.body); };
    return route;
}

}  // namespace deixis::server
