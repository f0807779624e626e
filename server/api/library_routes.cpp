// The library of unit gestures.
#include <memory>

#include "motion_json.hpp"
#include "studio_work.hpp"

namespace deixis::server {

std::vector<Route> libraryRoutes(const std::shared_ptr<StudioWork>& work) {
    using nlohmann::json;
    Route route;
    route.method = "GET";
    route.path = "/v1/motions";
    route.name = "motions";
    route.about = "The library of unit gestures.";
    std::vector<std::string> classes;
    for (std::size_t i = 0; i < motion::gesture_class_count; ++i)
        classes.emplace_back(motion::gestureClassName(static_cast<motion::GestureClass>(i)));
    const Shape gesture =
        objectShape("", {mustField("id", textShape("", 1)), mustField("name", textShape("", 1)),
                         mustField("meaning", textShape("One line")),
                         mustField("class", choiceShape("After McNeill (1992)", classes)),
                         mustField("own", booleanShape("Added by a user, and can be deleted")),
                         mustField("fps", integerShape("Frames a second", 15, 15)),
                         mustField("duration_s", numberShape("", 0.0)), mustField("frames", framesShape())});
    route.outcomes = {{200, "All of them", "application/json",
                       objectShape("", {mustField("motions", listShape("", gesture))})}};
    json all = json::array();
    for (const motion::UnitGesture& one : work->parts().library)
        all.push_back({{"id", one.id},
                       {"name", one.name},
                       {"meaning", one.meaning},
                       {"class", motion::gestureClassName(one.gesture_class)},
                       {"own", false},
                       {"fps", static_cast<int>(motion::upper_body_fps)},
                       {"duration_s", one.duration_s()},
                       {"frames", framesJson(motion::motionOf(one))}});
    const Reply reply = jsonReply(json{{"motions", std::move(all)}});
    route.run = [reply](const Call&) -> Answer { return reply; };
    return {route};
}

}  // namespace deixis::server
