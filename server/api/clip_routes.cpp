// Motion of the upper body on the avatar: for drawing, and as a file.
#include <fmt/format.h>

#include <functional>
#include <utility>

#include "assets/gltf/gltf_clip.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/joints/joint_positions.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "motion_json.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

constexpr const char* bvh_type = "text/plain";
constexpr const char* glb_type = "model/gltf-binary";
constexpr const char* csv_type = "text/csv";

/// Calls `use` with the motion of the field frames.
Answer withMotion(const Call& call, const std::function<Answer(const motion::UpperBodyMotion&)>& use) {
    const auto motion = motionFromJson(call.body["frames"], "frames");
    if (!motion) return tl::unexpected(refusalOf(motion.error()));
    return use(*motion);
}

Route tracksRoute() {
    Route route;
    route.method = "POST";
    route.path = "/v1/tracks";
    route.name = "tracks";
    route.about = "How the avatar's bones turn in a motion.";
    route.body = objectShape("", {mustField("frames", framesShape())});
    route.max_body_bytes = largest_motion_bytes;
    route.outcomes = {
        {200, "For each frame", "application/json", objectShape("", {mustField("tracks", tracksShape())})}};
    route.run = [](const Call& call) {
        return withMotion(call, [](const motion::UpperBodyMotion& motion) -> Answer {
            return jsonReply(nlohmann::json{{"tracks", tracksJson(motion::avatarClip(motion))}});
        });
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

Answer exported(const motion::UpperBodyMotion& motion, double duration_s, const std::string& format) {
    const std::size_t frames = motion::frameCountOf(duration_s);
    if (motion.frames.size() != frames)
        return tl::unexpected(Refusal{400,
                                      fmt::format("found {} frames, expected {}: 15 a second for duration_s",
                                                  motion.frames.size(), frames),
                                      "frames"});
    const motion::Clip clip = clipAsLongAs(motion::avatarClip(motion), duration_s);
    if (format == "glb") return fileReply(assets::writeGlb(clip), glb_type, "gestures.glb");
    if (format == "csv") return fileReply(assets::writeJointCsv(clip), csv_type, "gestures.csv");
    return fileReply(assets::writeBvh(clip), bvh_type, "gestures.bvh");
}

Route exportRoute() {
    Route route;
    route.method = "POST";
    route.path = "/v1/export";
    route.name = "export";
    route.about =
        "A motion on the avatar as a file: BVH, GLB, or the joints' positions as CSV. It is as long as "
        "duration_s.";
    route.body = objectShape("", {mustField("frames", framesShape()),
                                  mustField("duration_s", numberShape("Of the sound", 0.001, 1800.0)),
                                  mayField("format", choiceShape("", {"bvh", "glb", "csv"}), "bvh")});
    route.max_body_bytes = largest_motion_bytes;
    route.outcomes = {{200, "The file", bvh_type}, {200, "The file", glb_type}, {200, "The file", csv_type}};
    route.run = [](const Call& call) {
        return withMotion(call, [&call](const motion::UpperBodyMotion& motion) {
            return exported(motion, call.body["duration_s"], call.body["format"]);
        });
    };
    return route;
}

}  // namespace

std::vector<Route> clipRoutes() {
    return {tracksRoute(), exportRoute()};
}

}  // namespace deixis::server
