#include "gesture_making.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "motion/authoring/authored_gestures.hpp"
#include "motion_json.hpp"
#include "speech/sound/sound.hpp"

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
tl::expected<std::vector<motion::StyleControl>, Refusal> wantedStyles(const json& asked, std::size_t count) {
    std::vector<motion::StyleControl> out;
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

/// Of a motion that is kept: the range that is made anew, and all poses outside of it.
struct AskedKeep {
    motion::FrameRange changed;
    AskedPoses poses;
};

tl::expected<std::optional<AskedKeep>, Refusal> keptFrames(const json& asked, std::size_t count) {
    if (!asked.contains("keep")) return std::nullopt;
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
    AskedKeep out{{from, until}, {}};
    if (auto added = addFrames(keep["frames"], 0, count, "keep.frames", out.poses); !added)
        return tl::unexpected(added.error());
    out.poses.erase(out.poses.lower_bound(from), out.poses.lower_bound(until));
    return out;
}

/// What a request wants.
struct Wanted {
    AskedPoses poses;  ///< where nothing is kept
    std::vector<motion::StyleControl> styles;
    std::optional<AskedKeep> keep;
    bool exact = false;
    double variety = 0.0;
    std::uint64_t seed = 0;
};

tl::expected<Wanted, Refusal> wantedOf(const json& asked, std::size_t count) {
    Wanted out;
    auto styles = wantedStyles(asked, count);
    if (!styles) return tl::unexpected(styles.error());
    out.styles = std::move(*styles);
    auto poses = controlledPoses(asked, count);
    if (!poses) return tl::unexpected(poses.error());
    out.poses = std::move(*poses);
    auto keep = keptFrames(asked, count);
    if (!keep) return tl::unexpected(keep.error());
    out.keep = std::move(*keep);
    if (out.keep)
        std::erase_if(out.poses, [&](const auto& one) { return out.keep->poses.contains(one.first); });
    out.exact = asked["exact"].get<bool>();
    out.variety = asked["variety"].get<double>();
    out.seed = asked["seed"].get<std::uint64_t>();
    return out;
}

std::vector<motion::PoseControl> controlsOf(const AskedPoses& poses) {
    std::vector<motion::PoseControl> out;
    for (const auto& [frame, pose] : poses) out.push_back({frame, pose.pose});
    return out;
}

/// `exactly`: by frame, the numbers of all poses that are met to the bit, as they were asked for.
tl::expected<motion::WantedGestures, Refusal> wantedGestures(const json& asked, std::size_t count,
                                                             const motion::UpperBodyPose& rest,
                                                             AskedPoses& exactly) {
    auto wanted = wantedOf(asked, count);
    if (!wanted) return tl::unexpected(wanted.error());
    motion::WantedGestures out;
    out.maker = *motion::gestureMakerFromName(asked["system"].get<std::string>());
    const bool by_model = out.maker == motion::GestureMaker::model;
    if (out.maker == motion::GestureMaker::rules && wanted->variety > 0.0)
        return refuse("found it with the system rules, which varies by its seed", "variety");
    if (out.maker == motion::GestureMaker::keyframes)
        for (const auto& [there, field] :
             {std::pair(!wanted->styles.empty(), "style_controls"),
              std::pair(wanted->keep.has_value(), "keep"), std::pair(wanted->variety > 0.0, "variety")})
            if (there)
                return refuse("found it with the system keyframes, which takes pose_controls alone", field);
    out.poses = controlsOf(wanted->poses);
    out.styles = std::move(wanted->styles);
    out.exact = wanted->exact;
    out.variety = wanted->variety;
    out.seed = wanted->seed;
    out.still = asked["still"];
    out.fade = asked["fade"];
    if (wanted->keep) {
        motion::KeptMotion keep;
        keep.motion.frames.resize(count, rest);
        for (const auto& [frame, pose] : wanted->keep->poses)
            keep.motion.frames[static_cast<std::size_t>(frame)] = pose.pose;
        keep.changed = {wanted->keep->changed};
        out.keep = std::move(keep);
        exactly = std::move(wanted->keep->poses);
    }
    if (out.exact || !by_model) exactly.merge(wanted->poses);
    return out;
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
        mayField("exact", booleanShape("Poses are met to the bit. Only the system model can do otherwise"),
                 false),
        mayField(
            "variety",
            numberShape("How much style that is not asked for varies by the seed, in standard deviations; of "
                        "the system model",
                        0.0, 2.0),
            0.0),
        mayField("fade", booleanShape("From the last word on the motion passes to the mean pose"), false),
        mayField("still", booleanShape("Where nothing is gestured the body stands quite still"), false)};
}

ShapeField relaxedFingersField() {
    return mayField("relaxed_fingers", booleanShape("Else fingers are stretched; in tracks and files"), true);
}

tl::expected<MadeGestures, Refusal> gesturesTo(const KeptSpeech& speech, const StudioParts& parts,
                                               const json& asked) {
    const Utterance& utterance = speech.spoken.utterance;
    const motion::GestureParts makers = gestureParts(parts);
    AskedPoses exactly;
    const auto wanted =
        wantedGestures(asked, motion::frameCountOf(utterance.duration_s), makers.restPose(), exactly);
    if (!wanted) return tl::unexpected(wanted.error());
    const speech::Sound sound = wanted->maker == motion::GestureMaker::model
                                    ? speech::resampled(speech.spoken.sound, motion::speech_rate_hz)
                                    : speech::Sound{};
    auto made = motion::gesturesTo({sound.samples, utterance}, makers, *wanted);
    if (!made) return tl::unexpected(refusalOf(made.error()));
    MadeGestures out{std::move(*made), {}};
    out.frames = framesJson(out.motion);
    for (auto& [frame, pose] : exactly) out.frames[static_cast<std::size_t>(frame)] = std::move(pose.numbers);
    return out;
}

motion::GestureParts gestureParts(const StudioParts& parts) {
    return {parts.library, parts.model ? &*parts.model : nullptr};
}

motion::UpperBodyPose restPose(const StudioParts& parts) {
    return gestureParts(parts).restPose();
}

std::vector<GestureSystem> gestureSystems(const StudioParts& parts) {
    std::vector<GestureSystem> out;
    if (parts.model)
        out.push_back({std::string(motion::gestureMakerName(motion::GestureMaker::model)),
                       parts.model->synthetic(),
                       {"pose_controls", "style_controls", "keep", "exact", "variety"}});
    out.push_back({std::string(motion::gestureMakerName(motion::GestureMaker::rules)),
                   true,
                   {"pose_controls", "style_controls", "keep"}});
    out.push_back(
        {std::string(motion::gestureMakerName(motion::GestureMaker::keyframes)), false, {"pose_controls"}});
    for (GestureSystem& one : out) one.takes.insert(one.takes.end(), {"fade", "still", "relaxed_fingers"});
    return out;
}

}  // namespace deixis::server
