// Motion of the upper body on the avatar: for drawing, and as a file.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "assets/gltf/gltf_clip.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/joints/joint_positions.hpp"
#include "gesture_making.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "motion_json.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

constexpr const char* bvh_type = "text/plain";
constexpr const char* glb_type = "model/gltf-binary";
constexpr const char* csv_type = "text/csv";

constexpr const char* wav_type = "audio/wav";

tl::expected<motion::UpperBodyMotion, Refusal> motionOfBody(const nlohmann::json& body) {
    auto motion = motionFromJson(body["frames"], "frames");
    if (!motion) return tl::unexpected(refusalOf(motion.error()));
    return std::move(*motion);
}

Route tracksRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "POST";
    route.path = "/v1/tracks";
    route.name = "tracks";
    route.about = "How the avatar's bones turn in a motion.";
    route.body = objectShape("", {mustField("frames", framesShape()), relaxedFingersField()});
    route.max_body_bytes = largest_motion_bytes;
    route.outcomes = {
        {200, "For each frame", "application/json", objectShape("", {mustField("tracks", tracksShape())})}};
    route.run = [work](const Call& call) -> Answer {
        const auto motion = motionOfBody(call.body);
        if (!motion) return tl::unexpected(motion.error());
        auto clip = motion::avatarClip(*motion, call.body["relaxed_fingers"].get<bool>());
        return jsonReply(nlohmann::json{{"tracks", tracksJson(work->onAvatar(std::move(clip)))}});
    };
    return route;
}

Reply fileReply(std::string bytes, const char* type, const std::string& name) {
    Reply reply;
    reply.content_type = type;
    reply.bytes = std::make_shared<const std::string>(std::move(bytes));
    reply.headers.emplace_back("Content-Disposition", fmt::format("attachment; filename=\"{}\"", name));
    return reply;
}

Answer exportedMotion(const StudioWork& work, const nlohmann::json& asked) {
    const auto motion = motionOfBody(asked);
    if (!motion) return tl::unexpected(motion.error());
    const std::size_t count = motion->frames.size();
    const double duration_s = asked.contains("duration_s")
                                  ? asked["duration_s"].get<double>()
                                  : static_cast<double>(count) * motion::upper_body_frame_time_s;
    const std::size_t frames = motion::frameCountOf(duration_s);
    if (asked.contains("duration_s") && count != frames)
        return tl::unexpected(Refusal{
            400, fmt::format("found {} frames, expected {}: 15 a second for duration_s", count, frames),
            "frames"});
    const motion::Clip clip = motion::heldFor(
        work.onAvatar(motion::avatarClip(*motion, asked["relaxed_fingers"].get<bool>())), duration_s);
    const std::string format = asked["format"];
    if (format == "glb") return fileReply(assets::writeGlb(clip), glb_type, "gestures.glb");
    if (format == "csv") return fileReply(assets::writeJointCsv(clip), csv_type, "gestures.csv");
    return fileReply(assets::writeBvh(clip), bvh_type, "gestures.bvh");
}

Answer exported(StudioWork& work, const nlohmann::json& asked) {
    const bool of_speech = asked.contains("speech_id");
    if (of_speech != (asked["format"] == "wav"))
        return tl::unexpected(Refusal{
            400, "found frames and speech_id in the wrong place: wav is of a speech_id, the others of frames",
            "format"});
    if (!of_speech) return exportedMotion(work, asked);
    const auto speech = work.find(asked["speech_id"], "speech_id");
    if (!speech) return tl::unexpected(speech.error());
    return fileReply((*speech)->wav, wav_type, "speech.wav");
}

Route exportRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "POST";
    route.path = "/v1/export";
    route.name = "export";
    route.about =
        "A motion on the avatar as a file: BVH, GLB, or the joints' positions as CSV, as long as duration_s. "
        "Or the "
        "sound of a speech as WAV.";
    Shape body = objectShape(
        "",
        {mayField("frames", framesShape()),
         mayField("duration_s", numberShape("Of the sound; left out, as long as the frames", 0.001, 1800.0)),
         mayField("speech_id", textShape("Of a speech that the server keeps, for wav", 1, 64)),
         mayField("format",
                  choiceShape("wav: of speech_id, the others of frames", {"bvh", "glb", "csv", "wav"}),
                  "bvh"),
         relaxedFingersField()});
    body.exactly_one = {"frames", "speech_id"};
    route.body = std::move(body);
    route.max_body_bytes = largest_motion_bytes;
    for (const char* type : {bvh_type, glb_type, csv_type, wav_type})
        route.outcomes.push_back({200, "The file", type});
    route.run = [work](const Call& call) { return exported(*work, call.body); };
    return route;
}

}  // namespace

std::vector<Route> clipRoutes(const std::shared_ptr<StudioWork>& work) {
    return {tracksRoute(work), exportRoute(work)};
}

}  // namespace deixis::server
