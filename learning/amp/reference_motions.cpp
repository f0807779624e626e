#include "reference_motions.hpp"

#include <fmt/format.h>

#include "core/random.hpp"
#include "physics/figure/figure_pose.hpp"
#include "physics/figure/mjcf.hpp"
#include "physics/projection/projection.hpp"

namespace deixis::learning {

namespace {

using physics::steps_per_control;

/// At the begin of each control and at the end of the last.
std::vector<physics::BodyState> atControls(const physics::Followed& followed) {
    std::vector<physics::BodyState> out;
    for (std::size_t i = 0; i < followed.states.size(); i += steps_per_control)
        out.push_back(followed.states[i]);
    return out;
}

}  // namespace

bool ReferenceMotion::restIsOver(std::size_t control) const {
    return static_cast<double>(control) * physics::control_s > durations_s[0];
}

bool ReferenceMotion::holdIsOver(std::size_t control) const {
    return static_cast<double>(control) * physics::control_s >
           durations_s[0] + durations_s[1] + durations_s[2];
}

Result<std::vector<ReferenceMotion>> makeReferences(const physics::Body& body,
                                                    const physics::BaseMotion& base,
                                                    const std::vector<motion::Demonstration>& demonstrations,
                                                    const AmpSettings& settings) {
    const physics::Figure& figure = body.figure();
    const physics::BodyObserver observer(figure);
    std::vector<ReferenceMotion> out;
    for (const motion::Demonstration& one : demonstrations) {
        physics::Body follower = body;
        const motion::Clip& clip = one.gesture.clip;
        const auto clean = physics::follow(follower, clip, {});
        if (!clean) return tl::unexpected(clean.error());
        ReferenceMotion reference;
        reference.target_m = one.target;
        reference.hand = one.gesture.hand;
        reference.durations_s = motion::durationsOf(one.gesture, clip.frameCount(), clip.frame_time_s);
        reference.states = atControls(*clean);
        reference.targets_rad = clean->targets_rad;
        reference.targets_rad.resize(reference.states.size() - 1);
        for (std::size_t i = 0; i < reference.states.size(); ++i) {
            const double time_s = static_cast<double>(i) * physics::control_s;
            reference.base.push_back(base.pose(one.gesture.hand, time_s, reference.durations_s));
            // A pinned pelvis stays where that of the generated clips does.
            if (figure.stance == physics::Stance::pinned)
                reference.states[i].root.pose = physics::rootOf(figure, reference.base[i]);
        }
        for (int repeat = 0; repeat < settings.demonstration_repeats; ++repeat) {
            const auto noisy = physics::follow(
                follower, clip,
                {true, settings.demonstration_noise_rad,
                 deriveSeed(settings.seed, fmt::format("demonstration {} {}", out.size(), repeat))});
            if (!noisy) return tl::unexpected(noisy.error());
            auto& seen = reference.seen.emplace_back();
            const auto states = atControls(*noisy);
            for (std::size_t i = 0; i < states.size(); ++i) {
                physics::BodyState state = states[i];
                if (figure.stance == physics::Stance::pinned) state.root.pose = reference.states[i].root.pose;
                follower.setState(state);
                observer.writeState(follower, seen.emplace_back(observer.stateSize()));
            }
        }
        out.push_back(std::move(reference));
    }
    return out;
}

}  // namespace deixis::learning
