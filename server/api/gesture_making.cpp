#include "gesture_making.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "motion/speech_gestures/finishing.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"
#include "motion/unit_gestures/restyle.hpp"
#include "motion/unit_gestures/rule_set_a.hpp"
#include "motion_json.hpp"
#include "speech/sound/sound.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr double last_frame = max_motion_frames - 1;
constexpr std::size_t max_controls = 1000;
constexpr const char* model_system = "model";
constexpr const char* rules_system = "rules";
constexpr const char* keyframes_system = "keyframes";

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
    std::size_t count = 0;  ///< frames
    AskedPoses poses;       ///< where nothing is kept
    std::vector<motion::StyleControl> styles;
    std::optional<AskedKeep> keep;
    bool exact = false;
    double variety = 0.0;
    std::uint64_t seed = 0;
};

tl::expected<Wanted, Refusal> wantedOf(const json& asked, std::size_t count) {
    Wanted out;
    out.count = count;
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

motion::UpperBodyMotion byRules(const KeptSpeech& speech, const motion::GestureLibrary& library,
                                const Wanted& wanted) {
    motion::UpperBodyMotion out =
        motion::gesturesByRuleSetA(speech.spoken.utterance, library, wanted.seed).motion;
    if (wanted.styles.empty()) return out;
    std::vector<motion::WantedStyle> styles;
    for (const motion::StyleControl& one : wanted.styles)
        styles.push_back({one.speed, one.space, one.handedness});
    return motion::restyled(out, styles);
}

tl::expected<motion::UpperBodyMotion, Refusal> byModel(const KeptSpeech& speech,
                                                       const motion::SpeechGestureModel& model,
                                                       const Wanted& wanted) {
    const speech::Sound sound = speech::resampled(speech.spoken.sound, motion::speech_rate_hz);
    motion::SpeechGestureRequest request;
    request.samples = sound.samples;
    request.utterance = speech.spoken.utterance;
    request.duration_s = speech.spoken.utterance.duration_s;
    request.poses = controlsOf(wanted.poses);
    request.styles = wanted.styles;
    request.variety = wanted.variety;
    request.seed = wanted.seed;
    if (wanted.keep) {
        motion::KeptMotion keep;
        keep.motion.frames.resize(wanted.count, model.meanPose());
        for (const auto& [frame, pose] : wanted.keep->poses)
            keep.motion.frames[static_cast<std::size_t>(frame)] = pose.pose;
        keep.changed = {wanted.keep->changed};
        request.keep = std::move(keep);
    }
    auto made = model.generate(request);
    if (!made) return tl::unexpected(refusalOf(made.error()));
    return std::move(*made);
}

/// Keyframes alone (Yoon et al. 2021, section 7, MANUAL).
tl::expected<motion::UpperBodyMotion, Refusal> byKeyframes(const Wanted& wanted,
                                                           const motion::UpperBodyPose& ends) {
    for (const auto& [there, field] :
         {std::pair(!wanted.styles.empty(), "style_controls"), std::pair(wanted.keep.has_value(), "keep"),
          std::pair(wanted.variety > 0.0, "variety")})
        if (there)
            return refuse("found it with the system keyframes, which takes pose_controls alone", field);
    return motion::motionThroughKeyframes(controlsOf(wanted.poses), wanted.count, ends);
}

/// From where the last word or the last pose ends; of a range that is made anew only where it reaches the
/// end.
std::optional<std::size_t> fadeStart(const Utterance& utterance, const Wanted& wanted) {
    double from_s = 0.0;
    for (const SpokenWord& word : utterance.words) from_s = std::max(from_s, word.end_s);
    auto first = static_cast<std::size_t>(from_s * motion::upper_body_fps);
    // At least half a second, in which hands can come down.
    constexpr std::size_t least_frames = 8;
    if (wanted.count > least_frames) first = std::min(first, wanted.count - least_frames);
    if (!wanted.poses.empty())
        first = std::max(first, static_cast<std::size_t>(wanted.poses.rbegin()->first));
    if (!wanted.keep) return first;
    if (static_cast<std::size_t>(wanted.keep->changed.end) < wanted.count) return std::nullopt;
    return std::max(first, static_cast<std::size_t>(wanted.keep->changed.begin));
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
    auto wanted = wantedOf(asked, motion::frameCountOf(utterance.duration_s));
    if (!wanted) return tl::unexpected(wanted.error());
    const std::string system = asked["system"];
    const motion::UpperBodyPose rest = restPose(parts);
    MadeGestures out;
    if (system == rules_system) {
        if (wanted->variety > 0.0)
            return refuse("found it with the system rules, which varies by its seed", "variety");
        out.motion = byRules(speech, parts.library, *wanted);
    } else {
        auto made =
            system == keyframes_system ? byKeyframes(*wanted, rest) : byModel(speech, *parts.model, *wanted);
        if (!made) return tl::unexpected(made.error());
        out.motion = std::move(*made);
    }
    const bool still = asked["still"], fade = asked["fade"];
    if (still) motion::holdStill(out.motion);
    if (fade)
        if (const auto first = fadeStart(utterance, *wanted)) motion::fadeTo(out.motion, *first, rest);
    // What comes back to the bit: what is kept, and poses but where the model alone is to meet them.
    AskedPoses met = wanted->keep ? std::move(wanted->keep->poses) : AskedPoses();
    if (wanted->exact || system != model_system) met.merge(wanted->poses);
    if (!met.empty()) motion::meetPoses(out.motion, controlsOf(met));
    out.frames = framesJson(out.motion);
    for (auto& [frame, pose] : met) out.frames[static_cast<std::size_t>(frame)] = std::move(pose.numbers);
    return out;
}

motion::UpperBodyPose restPose(const StudioParts& parts) {
    return parts.model ? parts.model->meanPose() : motion::relaxedUpperBody();
}

std::vector<GestureSystem> gestureSystems(const StudioParts& parts) {
    std::vector<GestureSystem> out;
    if (parts.model)
        out.push_back({model_system,
                       parts.model->synthetic(),
                       {"pose_controls", "style_controls", "keep", "exact", "variety"}});
    out.push_back({rules_system, true, {"pose_controls", "style_controls", "keep"}});
    out.push_back({keyframes_system, false, {"pose_controls"}});
    for (GestureSystem& one : out) one.takes.insert(one.takes.end(), {"fade", "still", "relaxed_fingers"});
    return out;
}

}  // namespace deixis::server
