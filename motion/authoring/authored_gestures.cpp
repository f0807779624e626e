#include "motion/authoring/authored_gestures.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "motion/speech_gestures/finishing.hpp"
#include "motion/unit_gestures/restyle.hpp"
#include "motion/unit_gestures/rule_set_a.hpp"

namespace deixis::motion {

namespace {

constexpr std::array<std::string_view, 3> maker_names{"model", "rules", "keyframes"};

UpperBodyMotion byRules(const Utterance& utterance, const GestureLibrary& library,
                        const WantedGestures& wanted) {
    UpperBodyMotion out = gesturesByRuleSetA(utterance, library, wanted.seed).motion;
    if (wanted.styles.empty()) return out;
    std::vector<WantedStyle> styles;
    for (const StyleControl& one : wanted.styles) styles.push_back({one.speed, one.space, one.handedness});
    return restyled(out, styles);
}

Result<UpperBodyMotion> byModel(const GestureSpeech& speech, const SpeechGestureModel* model,
                                const WantedGestures& wanted) {
    if (model == nullptr)
        return fail("", "there is no model of speech gestures here",
                    "Train one with 'deixis learn gestures' (docs/speech-gestures.md)");
    SpeechGestureRequest request;
    request.samples = speech.samples;
    request.utterance = speech.utterance;
    request.duration_s = speech.utterance.duration_s;
    request.poses = wanted.poses;
    request.styles = wanted.styles;
    request.variety = wanted.variety;
    request.seed = wanted.seed;
    request.keep = wanted.keep;
    return model->generate(request);
}

std::size_t frameBehind(const std::vector<PoseControl>& poses) {
    int last = 0;
    for (const PoseControl& pose : poses) last = std::max(last, pose.frame);
    return static_cast<std::size_t>(last);
}

/// From where the last word or the last pose ends; of a range that is made anew only where it reaches the
/// end.
std::optional<std::size_t> fadeStart(const Utterance& utterance, const WantedGestures& wanted) {
    const std::size_t count = frameCountOf(utterance.duration_s);
    double from_s = 0.0;
    for (const SpokenWord& word : utterance.words) from_s = std::max(from_s, word.end_s);
    auto first = static_cast<std::size_t>(from_s * upper_body_fps);
    // At least half a second, in which hands can come down.
    constexpr std::size_t least_frames = 8;
    if (count > least_frames) first = std::min(first, count - least_frames);
    first = std::max(first, frameBehind(wanted.poses));
    if (!wanted.keep) return first;
    const FrameRange changed = wanted.keep->changed.front();
    if (static_cast<std::size_t>(changed.end) < count) return std::nullopt;
    return std::max(first, static_cast<std::size_t>(changed.begin));
}

}  // namespace

std::string_view gestureMakerName(GestureMaker maker) {
    return maker_names[static_cast<std::size_t>(maker)];
}

std::optional<GestureMaker> gestureMakerFromName(std::string_view name) {
    const auto* const found = std::ranges::find(maker_names, name);
    if (found == maker_names.end()) return std::nullopt;
    return static_cast<GestureMaker>(found - maker_names.begin());
}

const UpperBodyPose& GestureParts::restPose() const {
    return model != nullptr ? model->meanPose() : relaxedUpperBody();
}

std::vector<PoseControl> metPoses(const WantedGestures& wanted) {
    std::vector<PoseControl> out;
    if (wanted.keep) {
        const FrameRange changed = wanted.keep->changed.front();
        for (int frame = 0; frame < static_cast<int>(wanted.keep->motion.frames.size()); ++frame)
            if (frame < changed.begin || frame >= changed.end)
                out.push_back({frame, wanted.keep->motion.frames[static_cast<std::size_t>(frame)]});
    }
    if (wanted.exact || wanted.maker != GestureMaker::model)
        out.insert(out.end(), wanted.poses.begin(), wanted.poses.end());
    std::ranges::sort(out, {}, &PoseControl::frame);
    return out;
}

Result<UpperBodyMotion> gesturesTo(const GestureSpeech& speech, const GestureParts& parts,
                                   const WantedGestures& wanted) {
    Result<UpperBodyMotion> out;
    switch (wanted.maker) {
        case GestureMaker::model:
            out = byModel(speech, parts.model, wanted);
            break;
        case GestureMaker::rules:
            out = byRules(speech.utterance, parts.library, wanted);
            break;
        case GestureMaker::keyframes:
            out = motionThroughKeyframes(wanted.poses, frameCountOf(speech.utterance.duration_s),
                                         parts.restPose());
            break;
    }
    if (!out) return out;
    if (wanted.still) holdStill(*out);
    if (wanted.fade)
        if (const auto first = fadeStart(speech.utterance, wanted)) fadeTo(*out, *first, parts.restPose());
    if (auto met = metPoses(wanted); !met.empty()) meetPoses(*out, std::move(met));
    return out;
}

}  // namespace deixis::motion
