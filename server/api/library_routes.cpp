// The library of unit gestures: those that ship, and those that people add.
#include <memory>
#include <utility>

#include "kept_json.hpp"
#include "motion_json.hpp"
#include "own_motions.hpp"
#include "studio_work.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr const char* motions_path = "/v1/motions";

Shape motionShape() {
    Shape gesture_class = choiceShape("After McNeill (1992)", {});
    for (std::size_t i = 0; i < motion::gesture_class_count; ++i)
        gesture_class.choices.emplace_back(motion::gestureClassName(static_cast<motion::GestureClass>(i)));
    return objectShape("",
                       {mustField("id", textShape("", 1)), mustField("name", textShape("", 1)),
                        mustField("meaning", textShape("One line; may be empty")),
                        mustField("class", std::move(gesture_class)),
                        mustField("own", booleanShape("Added by a user, and can be deleted")),
                        mustField("fps", integerShape("Frames a second", 15, 15)),
                        mustField("duration_s", numberShape("", 0.0)), mustField("frames", framesShape())});
}

/// Of a gesture that ships or was added.
template <typename Gesture>
json motionItem(const Gesture& one, bool own, double duration_s, const motion::UpperBodyMotion& motion) {
    return {{"id", one.id},
            {"name", one.name},
            {"meaning", one.meaning},
            {"class", motion::gestureClassName(one.gesture_class)},
            {"own", own},
            {"fps", static_cast<int>(motion::upper_body_fps)},
            {"duration_s", duration_s},
            {"frames", framesJson(motion)}};
}

json motionItem(const motion::UnitGesture& one) {
    return motionItem(one, false, one.duration_s(), motion::motionOf(one));
}

json motionItem(const OwnMotion& one) {
    const auto frames = static_cast<double>(one.motion.frames.size());
    return motionItem(one, true, frames * motion::upper_body_frame_time_s, one.motion);
}

Route listMotions(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "GET";
    route.path = motions_path;
    route.name = "motions";
    route.about = "The library of unit gestures: those that ship, then those that were added.";
    route.outcomes = {
        {200, "All of them", "application/json",
         objectShape("", {mustField("motions", listShape("", motionShape())), damagedField()})}};
    // What ships is a megabyte that stays the same.
    std::string shipped;
    for (const motion::UnitGesture& one : work->parts().library)
        shipped += (shipped.empty() ? "" : ",") + motionItem(one).dump();
    route.run = [work, shipped](const Call&) -> Answer {
        const OwnMotions own = work->ownMotions();
        std::string text = "{\"motions\":[" + shipped;
        for (const OwnMotion& one : own.motions)
            text += (text.back() == '[' ? "" : ",") + motionItem(one).dump();
        return jsonTextReply(text + "],\"damaged\":" + damagedJson(own.damaged).dump() + "}");
    };
    return route;
}

Route addMotion(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "POST";
    route.path = motions_path;
    route.name = "add_motion";
    route.about = "Adds a motion to the library. A name that is taken is 409.";
    route.body = objectShape("", ownMotionFields());
    route.outcomes = {{201, "It is on the disk", "application/json", motionShape()}};
    route.run = [work](const Call& call) -> Answer {
        if (!work->folder()) return noFolder();
        const auto added = addOwnMotion(*work->folder(), call.body, work->parts().library);
        if (!added) return tl::unexpected(added.error());
        Reply reply = jsonReply(motionItem(*added));
        reply.status = 201;
        return reply;
    };
    return route;
}

Route deleteMotion(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "DELETE";
    route.path = "/v1/motions/{id}";
    route.name = "delete_motion";
    route.about = "Deletes a motion that was added, and takes it out of the rules. One that ships is 403.";
    route.path_parts = {{"id", "Of a motion that was added"}};
    route.outcomes = {{204, "It is deleted", ""}};
    route.run = [work](const Call& call) -> Answer {
        const std::string& id = call.path.at("id");
        if (motion::findGesture(work->parts().library, id) != nullptr)
            return tl::unexpected(Refusal{403, "this motion ships with the program and stays"});
        if (!work->folder()) return noFolder();
        const auto removed = removeOwnMotion(*work->folder(), id);
        if (!removed) return tl::unexpected(removed.error());
        return emptyReply();
    };
    return route;
}

}  // namespace

std::vector<Route> libraryRoutes(const std::shared_ptr<StudioWork>& work) {
    return {listMotions(work), addMotion(work), deleteMotion(work)};
}

}  // namespace deixis::server
