#include "physics/policy/amp_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "motion/pointing/phases.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "motion/skeleton/kinematics.hpp"
#include "physics/body/body.hpp"
#include "physics/figure/figure_pose.hpp"
#include "physics/figure/mjcf.hpp"
#include "physics/policy/base_motion.hpp"
#include "physics/policy/observation.hpp"
#include "physics/policy/policy.hpp"

namespace deixis::physics {

namespace {

using motion::GeneratedClip;
using motion::GenerationRequest;
using motion::GesturePhases;
using motion::PhaseDurations;

constexpr double well_above_m = 0.1;  ///< a hand that is up, over where it began

double whole_s(const PhaseDurations& durations) {
    return std::accumulate(durations.begin(), durations.end(), 0.0);
}

class Amp : public motion::Generator {
  public:
    Amp(AmpModel model, Body body, motion::PoseFeatures features, std::vector<Policy> policies)
        : model_(std::move(model)),
          start_(std::move(body)),
          observer_(start_.figure()),
          base_(std::move(features), model_.base),
          policies_(std::move(policies)) {}

    std::string_view name() const override { return model_.system; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        const AmpTarget& nearest = nearestTarget(model_.targets, asked.target);
        const PhaseDurations& own = nearest.durations_s;
        PhaseDurations durations = own;
        durations[2] = asked.settings.hold_s.value_or(own[2]);

        const Figure& figure = start_.figure();
        Body body = start_;
        BodyState state;
        const motion::LocalPose at_ease = base_.pose(nearest.hand, 0.0, own);
        state.root.pose = rootOf(figure, at_ease);
        state.angles_rad = fitPose(figure, at_ease).angles_rad;
        state.speeds_rad_s.assign(figure.hinges.size(), 0.0);
        body.setState(state);

        GeneratedClip out;
        out.clip.skeleton = figure.skeleton;
        out.clip.frame_time_s = control_s;
        const auto frames = static_cast<int>(std::lround(whole_s(durations) / control_s)) + 1;
        std::vector<float> seen(observer_.stateSize() + BodyObserver::goalSize(model_.with_phase));
        std::vector<double> targets(figure.hinges.size());
        const double hold_end_s = own[0] + own[1] + own[2];
        const double begin_m = handHeight_m(at_ease, nearest.hand);
        double waited_s = 0.0;
        for (int f = 0; f < frames; ++f) {
            const double own_s = motion::withHold(f * control_s, durations, own[2]);
            // A policy that does not know the time may keep pointing: so long its fingers do, too.
            if (!model_.with_phase && own_s - waited_s > hold_end_s &&
                handHeight_m(out.clip.frames.back(), nearest.hand) > begin_m + well_above_m)
                waited_s += control_s;
            motion::LocalPose pose = base_.pose(nearest.hand, own_s - waited_s, own);
            const RootState root = body.root();
            applyRoot(figure, root.pose, pose);
            applyAngles(figure, body.angles_rad(), pose);
            out.clip.frames.push_back(std::move(pose));
            PolicyGoal goal{asked.target, nearest.hand, {}};
            if (model_.with_phase) goal.phase = std::min(1.0, own_s / whole_s(own));
            const std::span<float> numbers(seen);
            const auto seen_state = numbers.first(observer_.stateSize());
            observer_.writeState(body, seen_state);
            observer_.writeGoal(root, seen_state, goal, numbers.subspan(seen_state.size()));
            policies_[static_cast<std::size_t>(nearest.cluster)].act(seen, targets);
            body.step(targets, steps_per_control);
        }
        motion::makeContinuous(out.clip.frames);
        setPhases(out, nearest.hand, durations);
        return out;
    }

  private:
    [[nodiscard]] double handHeight_m(const motion::LocalPose& pose, motion::Side hand) const {
        std::vector<Pose> world;
        motion::worldPose(start_.figure().skeleton, pose, world);
        return world[static_cast<std::size_t>(start_.figure().map[motion::armBones(hand).hand])].position.y;
    }

    /// As the gesture's time has them, or where the hand goes and comes by itself as it does.
    void setPhases(GeneratedClip& made, motion::Side hand, const PhaseDurations& durations) const {
        double time_s = 0.0;
        const auto next = [&](std::size_t phase) {
            time_s += durations[phase];
            return std::min(made.clip.frameCount() - 1, static_cast<int>(std::lround(time_s / control_s)));
        };
        made.hand = hand;
        made.onset_frame = next(0);
        made.peak_frame = next(1);
        made.hold_frame = next(2);
        made.end_frame = next(3);
        const auto world = motion::worldPoses(made.clip);
        const motion::HumanoidMap& map = start_.figure().map;
        const auto found = motion::detectPhases(
            motion::jointTrajectory(world, map[motion::armBones(hand).hand]), hand, control_s);
        if (found && motion::checkPhases(found->phases, made.clip.frameCount()))
            static_cast<GesturePhases&>(made) = found->phases;
    }

    AmpModel model_;
    Body start_;
    BodyObserver observer_;
    BaseMotion base_;
    std::vector<Policy> policies_;
};

}  // namespace

const AmpTarget& nearestTarget(const std::vector<AmpTarget>& targets, const Vec3& place_m) {
    return *std::ranges::min_element(
        targets, {}, [&](const AmpTarget& one) { return glm::distance(one.target_m, place_m); });
}

Result<std::unique_ptr<motion::Generator>> makeAmp(const motion::NetworkWeights& weights,
                                                   const motion::Skeleton& avatar) {
    auto model = readModel(weights);
    if (!model) return tl::unexpected(model.error());
    auto features = motion::PoseFeatures::of(avatar);
    if (!features) return tl::unexpected(features.error());
    if (const auto same = weights.checkFeatures(features->names()); !same)
        return tl::unexpected(same.error());
    if (model->base.size() != features->size() * motion::PhaseTrajectory::coefficient_count)
        return fail(weights.file + ": base",
                    fmt::format("found {} numbers, expected {}", model->base.size(),
                                features->size() * motion::PhaseTrajectory::coefficient_count));
    const auto figure = makeFigure(avatar, model->stance);
    if (!figure) return tl::unexpected(figure.error());
    auto body = Body::make(*figure);
    if (!body) return tl::unexpected(body.error());
    const auto inputs = BodyObserver(*figure).stateSize() + BodyObserver::goalSize(model->with_phase);
    std::vector<Policy> policies;
    for (int i = 0; i < model->clusters; ++i) {
        auto policy = Policy::read(weights, fmt::format("policy{}", i), static_cast<int>(inputs),
                                   model->hidden, static_cast<int>(figure->hinges.size()));
        if (!policy) return tl::unexpected(policy.error());
        policies.push_back(std::move(*policy));
    }
    return std::make_unique<Amp>(std::move(*model), std::move(*body), std::move(*features),
                                 std::move(policies));
}

}  // namespace deixis::physics
