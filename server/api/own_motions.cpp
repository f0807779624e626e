#include "own_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "kept_json.hpp"
#include "motion_json.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr const char* motions_kind = "motions";
constexpr const char* motion_format = "deixis studio motion";
constexpr std::size_t largest_motion_file = std::size_t{1} << 20U;
constexpr std::size_t longest_name = 80;
constexpr std::size_t longest_meaning = 200;

std::string fileOf(const std::string& id) {
    return fmt::format("{}/{}.json", motions_kind, id);
}

std::vector<std::string> classNames() {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < motion::gesture_class_count; ++i)
        out.emplace_back(motion::gestureClassName(static_cast<motion::GestureClass>(i)));
    return out;
}

Result<OwnMotion> motionOf(const json& content) {
    OwnMotion out;
    out.name = content["name"];
    out.meaning = content["meaning"];
    out.gesture_class = *motion::gestureClassFromName(content["class"].get_ref<const std::string&>());
    auto frames = motionFromJson(content["frames"], "frames");
    if (!frames) return tl::unexpected(frames.error());
    out.motion = std::move(*frames);
    return out;
}

Result<OwnMotion> readMotion(const KeptFolder& folder, const std::string& id) {
    const auto content =
        readKeptJson(folder, fileOf(id), largest_motion_file, motion_format, ownMotionFields());
    if (!content) return tl::unexpected(content.error());
    auto out = motionOf(*content);
    if (out) out->id = id;
    return out;
}

}  // namespace

std::vector<std::string> ownMotionIds(const KeptFolder& folder) {
    return folder.ids(motions_kind);
}

OwnMotions ownMotions(const KeptFolder& folder) {
    OwnMotions out;
    for (const std::string& id : ownMotionIds(folder)) {
        auto one = readMotion(folder, id);
        if (one)
            out.motions.push_back(std::move(*one));
        else if (folder.has(fileOf(id)))  // and not deleted meanwhile
            out.damaged.push_back({fileOf(id), Error{one.error().where, one.error().message}.text()});
    }
    std::stable_sort(out.motions.begin(), out.motions.end(), [](const OwnMotion& a, const OwnMotion& b) {
        return lowerCase(a.name) < lowerCase(b.name);
    });
    return out;
}

std::vector<ShapeField> ownMotionFields() {
    Shape frames = framesShape();
    frames.max_count = max_own_frames;
    return {mustField("name", textShape("By which people find it", 1, longest_name)),
            mayField("meaning", textShape("One line", 0, longest_meaning), ""),
            mayField("class", choiceShape("After McNeill (1992)", classNames()), "iconic"),
            mustField("frames", std::move(frames))};
}

tl::expected<OwnMotion, Refusal> addOwnMotion(const KeptFolder& folder, const json& asked,
                                              const motion::GestureLibrary& library) {
    auto made = motionOf(asked);
    if (!made) return tl::unexpected(refusalOf(made.error()));
    made->name = trimmed(made->name);
    if (made->name.empty()) return tl::unexpected(Refusal{400, "found blanks only, expected a name", "name"});
    const auto turn = folder.turn();
    if (!turn) return notWritten(turn.error());
    const auto others = ownMotions(folder);
    const auto has_name = [&](const auto& one) { return sameLetters(one.name, made->name); };
    if (std::any_of(library.begin(), library.end(), has_name) ||
        std::any_of(others.motions.begin(), others.motions.end(), has_name))
        return tl::unexpected(
            Refusal{409, fmt::format("a motion of the name '{}' is there already", made->name), "name"});
    if (others.motions.size() + others.damaged.size() >= max_own_motions)
        return tl::unexpected(Refusal{
            409, fmt::format("{} motions were added, the most that are kept: delete one", max_own_motions)});
    made->id = newKeptId();
    const auto written = writeKeptJson(folder, fileOf(made->id), motion_format,
                                       {{"name", made->name},
                                        {"meaning", made->meaning},
                                        {"class", motion::gestureClassName(made->gesture_class)},
                                        {"frames", framesJson(made->motion)}});
    if (!written) return notWritten(written.error());
    return std::move(*made);
}

tl::expected<void, Refusal> removeOwnMotion(const KeptFolder& folder, const std::string& id) {
    const auto absent = [] { return tl::unexpected(Refusal{404, "no motion of this id was added"}); };
    if (!isKeptId(id) || !folder.has(fileOf(id))) return absent();
    const auto turn = folder.turn();
    if (!turn) return notWritten(turn.error());
    if (!folder.has(fileOf(id))) return absent();
    if (const auto removed = folder.remove(fileOf(id)); !removed) return notWritten(removed.error());
    return {};
}

}  // namespace deixis::server
