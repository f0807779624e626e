// An arm that points at something.
#include <memory>

#include "gesture_making.hpp"
#include "motion/pointing/stretched_arm.hpp"
#include "motion_json.hpp"
#include "pointing_pose.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr double farthest_m = 100.0;

Answer pointed(const StudioWork& work, const json& asked) {
    motion::UpperBodyPose body = restPose(work.parts());
    if (asked.contains("pose")) {
        const auto given = motion::poseFromNumbers(asked["pose"].get<std::vector<double>>());
        if (!given) return tl::unexpected(Refusal{400, given.error().message, "pose"});
        body = *given;
    }
    const Vec3 target(asked["target_m"][0], asked["target_m"][1], asked["target_m"][2]);
    const std::string wanted = asked["side"];
    const motion::Side side = wanted == "auto"   ? motion::handFor(target)
                              : wanted == "left" ? motion::Side::left
                                                 : motion::Side::right;
    const auto out = pointingPose(body, side, target);
    if (!out) return tl::unexpected(refusalOf(out.error()));
    return jsonReply(json{{"frame", framesJson(motion::UpperBodyMotion{{out->pose}})[0]},
                          {"side", side == motion::Side::left ? "left" : "right"},
                          {"off_deg", rounded(out->off_deg, 1000.0)}});
}

}  // namespace

Route pointRoute(const std::shared_ptr<StudioWork>& work) {
    const Shape pose = framesShape().item.front();
    Route route;
    route.method = "POST";
    route.path = "/v1/point";
    route.name = "point";
    route.about =
        "The pose in which an arm points at a target, by the line from the eyes over the fingertip.";
    route.body = objectShape(
        "",
        {mustField("target_m", listShape("x y z in the avatar's axes: metres, y up, the figure at the origin "
                                         "faces +z, its left +x. At least 0.3 m from the shoulder",
                                         numberShape("", -farthest_m, farthest_m), 3, 3)),
         mayField("side",
                  choiceShape("Which arm; auto: the one on the target's side", {"left", "right", "auto"}),
                  "auto"),
         mayField("pose", pose)});
    route.outcomes = {
        {200, "The pose", "application/json",
         objectShape("",
                     {mustField("frame", pose), mustField("side", choiceShape("", {"left", "right"})),
                      mustField("off_deg", numberShape("By which the line misses the target, where an arm "
                                                       "cannot come there",
                                                       0.0, 180.0))})}};
    route.run = [work](const Call& call) { return pointed(*work, call.body); };
    return route;
}

}  // namespace deixis::server
