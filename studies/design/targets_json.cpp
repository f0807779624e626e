// A study's targets as they are stored with it.
#include <nlohmann/json.hpp>

#include "studies/design/targets.hpp"

namespace deixis::studies {

namespace {

using Json = nlohmann::ordered_json;

Json keptPosition(const Vec3& position) {
    return Json::array({position.x, position.y, position.z});
}

Vec3 readPosition(const Json& json) {
    if (json.size() != 3) throw std::invalid_argument("expected three numbers");
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace

std::string targetsJson(const std::vector<TargetItem>& targets) {
    Json out = Json::array();
    for (const TargetItem& item : targets) {
        Json bands = Json::array();
        for (const auto& band : item.distractors) {
            Json positions = Json::array();
            for (const Vec3& distractor : band) positions.push_back(keptPosition(distractor));
            bands.push_back(std::move(positions));
        }
        Json& kept =
            out.emplace_back(Json{{"id", item.id},
                                  {"target", item.placed ? keptPosition(item.target) : Json(nullptr)},
                                  {"distractors", std::move(bands)}});
        if (!item.clips.empty()) kept["clips"] = item.clips;
    }
    // One item a line.
    std::string text = "[";
    for (std::size_t i = 0; i < out.size(); ++i) text += (i > 0 ? ",\n " : "\n ") + out[i].dump();
    return text + "\n]\n";
}

Result<std::vector<TargetItem>> targetsFromJson(std::string_view json) {
    try {
        std::vector<TargetItem> targets;
        for (const Json& kept : Json::parse(json)) {
            TargetItem item;
            item.id = kept.at("id").get<std::string>();
            item.placed = !kept.at("target").is_null();
            if (item.placed) item.target = readPosition(kept.at("target"));
            for (const Json& band : kept.at("distractors")) {
                auto& positions = item.distractors.emplace_back();
                for (const Json& position : band) positions.push_back(readPosition(position));
            }
            if (kept.contains("clips")) item.clips = kept.at("clips").get<std::map<std::string, int>>();
            targets.push_back(std::move(item));
        }
        return targets;
    } catch (const std::exception& error) {  // of the JSON library, too
        return fail("targets", error.what());
    }
}

}  // namespace deixis::studies
