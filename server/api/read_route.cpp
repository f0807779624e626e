// A clip of another program, as motion of the upper body.
#include <fmt/format.h>

#include <memory>

#include "assets/joints/clip_import.hpp"
#include "core/text.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "motion_json.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr std::size_t largest_clip = std::size_t{64} << 20U;
constexpr std::size_t longest_file_name = 255;
constexpr double longest_clip_s = 1800.0;

tl::unexpected<Refusal> refusedClip(const Error& error) {
    Refusal refusal{400, storable(error.text())};
    refusal.field = "clip";
    return tl::unexpected(std::move(refusal));
}

Answer read(const std::string& name, const std::string& bytes) {
    const auto imported = assets::importClipBytes(bytes, name);
    if (!imported) return refusedClip(imported.error());
    const motion::Clip& clip = imported->clip;
    if (clip.duration_s() > longest_clip_s)
        return refusedClip({name, fmt::format("found a clip of {:.0f} s, expected at most {:.0f} s",
                                              clip.duration_s(), longest_clip_s)});
    const auto mapping =
        motion::mapHumanoid(clip.skeleton, imported->humanoid ? &*imported->humanoid : nullptr);
    const auto motion = motion::upperBodyOf(clip, mapping.map);
    if (!motion) {
        Error error = motion.error();
        if (error.where.empty()) error.where = name;
        return refusedClip(error);
    }
    json remarks = json::array();
    for (const std::string& one : imported->remarks) remarks.push_back(storable(one));
    return jsonReply(json{{"format", imported->format},
                          {"fps", static_cast<int>(motion::upper_body_fps)},
                          {"frames", framesJson(*motion)},
                          {"remarks", std::move(remarks)}});
}

}  // namespace

Route readRoute() {
    Route route;
    route.method = "POST";
    route.path = "/v1/motions/read";
    route.name = "read_motion";
    route.about =
        "The motion in a clip of another program: BVH, glTF, GLB, VRM animation, CSV of joints, Kinect, rows "
        "of "
        "exponential maps, SGToolkit's JSON; packed with gzip or not. Nothing of it is kept.";
    route.form = {{"name", textShape("The file's name, whose ending tells what the content does not", 1,
                                     longest_file_name)},
                  {"clip", textShape("The file, without buffers in other files"), true, true,
                   "application/octet-stream"}};
    route.max_form_bytes = largest_clip;
    route.outcomes = {{200, "Its upper body", "application/json",
                       objectShape("", {mustField("format", textShape("Which was found", 1)),
                                        mustField("fps", integerShape("Frames a second", 15, 15)),
                                        mustField("frames", framesShape()),
                                        mustField("remarks", listShape("What was unusual about the file",
                                                                       textShape("")))})}};
    route.run = [](const Call& call) { return read(call.form->at("name"), call.form->at("clip")); };
    return route;
}

}  // namespace deixis::server
