#include "gesture_making.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>

#include "motion/speech_gestures/pose_control.hpp"
#include "motion/unit_gestures/restyle.hpp"
#include "motion/unit_gestures/rule_set_a.hpp"
#include "motion_json.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr double last_frame = max_motion_frames - 1;
constexpr std::size_t max_controls = 1000;

/// By frame: the pose, and the 27 numbers as they were asked for.
struct AskedPose {
    motion::UpperBodyPose pose;
    json numbers;
};
using AskedPoses = std::map<int, AskedPose>;

tl::unexpected<Refusal> refuse(std::string message, std::string field) {
    return tl::unexpected(Refusal{400, std::move(message), std::move(field)});
}

tl::expected<void, Refusal> addFrames(const json& frames, int first, std::size_t count,
                                      const std::string& field, AskedPoses& to) {
    const auto motion = motionFromJson(frames, field);
    if (!motion) return tl::unexpected(refusalOf(motion.error()));
    for (std::size_t i = 0; i < motion->frames.size(); ++i) {
        const int frame = first + static_cast<int>(i);
        if (static_cast<std::size_t>(frame) >= count)
            return refuse(fmt::format("found a pose at frame {}, expected at most {}, the speech's last",
                                      frame, count - 1),
                          field);
        if (!to.emplace(frame, AskedPose{motion->frames[i], frames[i]}).second)
            return refuse(fmt::format("found two poses at frame {}, expected one", frame), field);
    }
    return {};
}

tl::expected<AskedPoses, Refusal> controlledPoses(const json& asked, std::size_t count) {
    AskedPoses out;
    if (!asked.contains("pose_controls")) return out;
    const json& controls = asked["pose_controls"];
    for (std::size_t i = 0; i < controls.size(); ++i)
        if (auto added = addFrames(controls[i]["frames"], controls[i]["start_frame"].get<int>(), count,
                                   fmt::format("pose_controls[{}].frames", i), out);
            !added)
            return tl::unexpected(added.error());
    return out;
}

/// One a frame; none where none is asked for.
tl::expected<std::vector<motion::WantedStyle>, Refusal> wantedStyles(const json& asked, std::size_t count) {
    std::vector<motion::WantedStyle> out;
    if (!asked.contains("style_controls") || asked["style_controls"].empty()) return out;
    out.resize(count);
    const auto value = [](const json& control, const char* name) {
        return control.contains(name) ? std::optional(control[name].get<double>()) : std::nullopt;
    };
    for (std::size_t i = 0; i < asked["style_controls"].size(); ++i) {
        const json& control = asked["style_controls"][i];
        const auto from = control["start_frame"].get<std::size_t>();
        const auto until = from + control["frame_count"].get<std::size_t>();
        if (until > count)
            return refuse(
                fmt::format("ends at frame {}, expected at most {}, the speech's end", until, count),
                fmt::format("style_controls[{}].frame_count", i));
        for (std::size_t frame = from; frame < until; ++frame)
            out[frame] = {value(control, "speed"), value(control, "space"), value(control, "handedness")};
    }
    return out;
}

/// What is kept stands before what is controlled.
tl::expected<void, Refusal> keepFrames(const json& asked, std::size_t count, AskedPoses& to) {
    if (!asked.contains("keep")) return {};
    const json& keep = asked["keep"];
    if (keep["frames"].size() != count)
        return refuse(
            fmt::format("found {} frames, expected {}, all of the speech's", keep["frames"].size(), count),
            "keep.frames");
    const int from = keep["from_frame"].get<int>();
    const int until = keep["to_frame"].get<int>();
    if (until <= from || static_cast<std::size_t>(until) > count)
        return refuse(fmt::format("found {}, expected from_frame + 1 = {} to {}", until, from + 1, count),
                      "keep.to_frame");
    AskedPoses all;
    if (auto added = addFrames(keep["frames"], 0, count, "keep.frames", all); !added) return added;
    all.erase(all.lower_bound(from), all.lower_bound(until));
    all.merge(to);
    to = std::move(all);
    return {};
}

}  // namespace

std::vector<ShapeField> controlFields() {
    const Shape frame = integerShape("", 0, last_frame);
    const Shape style = numberShape("0: as it is. Handedness above 0: the left hand moves more", -3.0, 3.0);
    return {
        mayField("pose_controls", listShape("Poses that the motion meets",
                                            objectShape("", {mustField("start_frame", frame),
                                                             mustField("frames", framesShape())}),
                                            0, max_controls)),
        mayField(
            "style_controls",
            listShape(
                "Style of some frames; what is left out is free, and of two for a frame the later one counts",
                objectShape(
                    "", {mustField("start_frame", frame),
                         mustField("frame_count", integerShape("", 1, max_motion_frames)),
                         mayField("speed", style), mayField("space", style), mayField("handedness", style)}),
                0, max_controls)),
        mayField("keep",
                 objectShape("A motion whose frames come back to the bit, but for those from from_frame to "
                             "before to_frame, which are made anew",
                             {mustField("frames", framesShape()), mustField("from_frame", frame),
                              mustField("to_frame", integerShape("", 1, max_motion_frames))})),
        mayField("exact", booleanShape("Poses are met to the bit. The system rules always does"), false)};
}

tl::expected<MadeGestures, Refusal> gesturesTo(const KeptSpeech& speech,
                                               const motion::GestureLibrary& library, const json& asked) {
    const Utterance& utterance = speech.spoken.utterance;
    const std::size_t count = motion::frameCountOf(utterance.duration_s);
    const auto styles = wantedStyles(asked, count);
    if (!styles) return tl::unexpected(styles.error());
    auto poses = controlledPoses(asked, count);
    if (!poses) return tl::unexpected(poses.error());
    if (auto kept = keepFrames(asked, count, *poses); !kept) return tl::unexpected(kept.error());
    MadeGestures out;
    out.motion = motion::gesturesByRuleSetA(utterance, library, asked["seed"].get<std::uint64_t>()).motion;
    if (!styles->empty()) out.motion = motion::restyled(out.motion, *styles);
    std::vector<motion::PoseControl> met;
    for (const auto& [frame, pose] : *poses) met.push_back({frame, pose.pose});
    if (!met.empty()) motion::meetPoses(out.motion, std::move(met));
    out.frames = framesJson(out.motion);
    for (auto& [frame, pose] : *poses) out.frames[static_cast<std::size_t>(frame)] = std::move(pose.numbers);
    return out;
}

}  // namespace deixis::server
