// That the server runs, and what it can do.
#include <memory>
#include <utility>

#include "gesture_making.hpp"
#include "studio_work.hpp"

namespace deixis::server {

Route healthRoute(const std::shared_ptr<StudioWork>& work) {
    Route route;
    route.method = "GET";
    route.path = "/v1/health";
    route.name = "health";
    route.about = "That the server runs, and what it can do.";
    const Shape names = listShape("The first is taken where none is named", textShape("", 1));
    route.outcomes = {
        {200, "It runs", "application/json",
         objectShape(
             "",
             {mustField("status", choiceShape("", {"ok"})),
              mustField("version", textShape("Of the program", 1)),
              mustField("commit", textShape("Of the program's sources", 1)), mustField("systems", names),
              mustField("gestures",
                        listShape("The systems, and which wishes each takes",
                                  objectShape("", {mustField("system", textShape("", 1)),
                                                   mustField("synthetic", booleanShape("")),
                                                   mustField("takes", listShape("", textShape("", 1)))}))),
              mustField("mean_pose", listShape("27 numbers: where motions begin and end by themselves",
                                               numberShape("", -1.0, 1.0), 27, 27)),
              mustField("voices",
                        listShape("The first is taken where none is named",
                                  objectShape("", {mustField("name", textShape("", 1)),
                                                   mustField("language", textShape("BCP 47", 1))}))),
              mustField("other_languages", booleanShape("There are voices of others than English")),
              mustField("folder", booleanShape("Motions, rules and projects are kept on the disk")),
              mustField("synthetic", booleanShape("Gestures are by rules, or by what was trained on them")),
              mayField("session", objectShape("Of a study, where the page takes part in one",
                                              {mustField("participant", textShape("", 1)),
                                               mustField("study", textShape("Its name", 1)),
                                               mustField("language", textShape("Of its texts", 1))}))})}};
    auto systems = nlohmann::json::array(), gestures = nlohmann::json::array();
    for (const GestureSystem& one : gestureSystems(work->parts())) {
        systems.push_back(one.name);
        gestures.push_back({{"system", one.name}, {"synthetic", one.synthetic}, {"takes", one.takes}});
    }
    auto voices = nlohmann::json::array();
    bool other_languages = false;
    for (const std::string& name : work->parts().voices.names()) {
        const std::string language = work->parts().voices.language(name);
        other_languages = other_languages || !speech::isEnglish(language);
        voices.push_back({{"name", name}, {"language", language}});
    }
    nlohmann::ordered_json health{{"status", "ok"},
                                  {"version", work->parts().version},
                                  {"commit", work->parts().commit},
                                  {"systems", systems},
                                  {"gestures", gestures},
                                  {"mean_pose", motion::numbersOf(restPose(work->parts()))},
                                  {"voices", voices},
                                  {"other_languages", other_languages},
                                  {"folder", work->folder() != nullptr},
                                  {"synthetic", gestureSystems(work->parts()).front().synthetic}};
    if (const auto& session = work->parts().session)
        health["session"] = {{"participant", session->participant},
                             {"study", session->study},
                             {"language", session->language}};
    const Reply reply = jsonReply(health);
    route.run = [reply](const Call&) -> Answer { return reply; };
    return route;
}

}  // namespace deixis::server
