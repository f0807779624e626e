#include "gesture_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace deixis::motion {

namespace {

constexpr std::array style_elements{&StyleControl::speed, &StyleControl::space, &StyleControl::handedness};

Result<void> checkStyles(const std::vector<StyleControl>& styles, std::size_t frames) {
    if (!styles.empty() && styles.size() != frames)
        return fail("style controls",
                    fmt::format("found {} style controls, expected one for each of {} frames", styles.size(),
                                frames));
    for (std::size_t f = 0; f < styles.size(); ++f)
        for (const auto element : style_elements)
            if (const auto& value = styles[f].*element; value && !std::isfinite(*value))
                return fail("style controls",
                            fmt::format("found {} at frame {}, expected a number", *value, f));
    return {};
}

Result<void> checkKept(const KeptMotion& keep, std::size_t frames) {
    if (keep.motion.frames.size() != frames)
        return fail("keep", fmt::format("found a motion of {} frames, expected {} as the speech has",
                                        keep.motion.frames.size(), frames));
    for (const FrameRange& range : keep.changed)
        if (range.begin < 0 || range.end <= range.begin || static_cast<std::size_t>(range.end) > frames)
            return fail("keep", fmt::format("found a range from {} to {}, expected one within 0 to {}",
                                            range.begin, range.end, frames));
    std::vector<PoseControl> poses;
    for (std::size_t f = 0; f < frames; ++f) poses.push_back({static_cast<int>(f), keep.motion.frames[f]});
    return checkPoses(poses, frames);
}

}  // namespace

Result<void> checkRequest(const SpeechGestureRequest& request, std::size_t frames, bool takes_controls) {
    if (!takes_controls &&
        (!request.poses.empty() || !request.styles.empty() || request.keep || request.variety > 0.0))
        return fail("controls", "these weights were trained without controls, found some in the request",
                    "Use weights that take controls");
    if (const auto poses = checkPoses(request.poses, frames); !poses) return poses;
    if (const auto styles = checkStyles(request.styles, frames); !styles) return styles;
    if (!(request.variety >= 0.0 && request.variety <= 3.0))
        return fail("variety", fmt::format("found {}, expected 0 to 3", request.variety));
    if (!request.keep) return {};
    if (const auto kept = checkKept(*request.keep, frames); !kept) return kept;
    const std::vector<bool> changed = changedFrames(request, frames);
    for (const PoseControl& one : request.poses)
        if (!changed[static_cast<std::size_t>(one.frame)])
            return fail("pose control", fmt::format("found a pose at frame {}, which is kept", one.frame),
                        "Poses can only stand in the ranges that are made anew");
    return {};
}

std::vector<bool> changedFrames(const SpeechGestureRequest& request, std::size_t frames) {
    std::vector<bool> out(frames, !request.keep);
    if (request.keep)
        for (const FrameRange& range : request.keep->changed)
            std::fill(out.begin() + range.begin, out.begin() + range.end, true);
    return out;
}

std::vector<PoseControl> allPoses(const SpeechGestureRequest& request, std::size_t frames) {
    std::vector<PoseControl> out = request.poses;
    if (request.keep) {
        const std::vector<bool> changed = changedFrames(request, frames);
        for (std::size_t f = 0; f < frames; ++f)
            if (!changed[f]) out.push_back({static_cast<int>(f), request.keep->motion.frames[f]});
    }
    std::ranges::sort(out, {}, &PoseControl::frame);
    return out;
}

std::vector<StyleControl> allStyles(const SpeechGestureRequest& request, std::size_t frames) {
    std::vector<StyleControl> out = request.styles;
    out.resize(frames);
    if (request.variety > 0.0) {
        constexpr std::size_t apart = 30;  // frames
        Random random(request.seed, "speech gestures");
        std::vector<std::array<double, 3>> drawn;
        for (std::size_t f = 0; f < frames + apart; f += apart)
            drawn.push_back({random.normal(0.0, request.variety), random.normal(0.0, request.variety),
                             random.normal(0.0, request.variety)});
        for (std::size_t f = 0; f < frames; ++f) {
            const double t = static_cast<double>(f % apart) / apart;
            for (std::size_t e = 0; e < style_elements.size(); ++e)
                if (auto& value = out[f].*style_elements[e]; !value)
                    value = (1.0 - t) * drawn[f / apart][e] + t * drawn[f / apart + 1][e];
        }
    }
    for (StyleControl& one : out)
        for (const auto element : style_elements)
            if (auto& value = one.*element; value) value = std::clamp(*value, -3.0, 3.0);
    return out;
}

}  // namespace deixis::motion
