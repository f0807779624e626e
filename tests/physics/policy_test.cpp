// What policies see, and the system that they make: observations at hand-worked places, and policies that
// hold still.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "bodies.hpp"
#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "physics/policy/amp_system.hpp"
#include "physics/policy/base_motion.hpp"
#include "physics/policy/observation.hpp"

using namespace deixis;
using namespace deixis::physics;

namespace {

const std::vector<motion::Demonstration>& fewDemonstrations() {
    static const auto made = [] {
        motion::DemonstrationParameters parameters;
        parameters.left_count = 2;
        parameters.right_count = 3;
        return motion::makeDemonstrations(motion::referenceHumanoid(), parameters).value();
    }();
    return made;
}

/// A policy of one layer of two units that always asks for the same angles, a tenth of a radian each.
motion::NetworkWeights stillPolicy() {
    const auto features = motion::PoseFeatures::of(motion::referenceHumanoid()).value();
    const auto base = BaseMotion::meanOf(features, fewDemonstrations());
    AmpModel model{
        .system = "amp-base", .hidden = {2}, .base = base.coefficients(), .features = features.names()};
    for (const auto& one : fewDemonstrations())
        model.targets.push_back(
            {one.target, one.gesture.hand,
             motion::durationsOf(one.gesture, one.gesture.clip.frameCount(), one.gesture.clip.frame_time_s),
             0});
    motion::NetworkWeights out;
    writeModel(model, out);
    const auto figure = tests::figureOf(Stance::pinned);
    const std::size_t inputs = BodyObserver(figure).stateSize() + BodyObserver::goalSize(true),
                      outputs = figure.hinges.size();
    const auto add = [&out](const char* name, std::vector<std::size_t> shape, float value) {
        std::size_t size = 1;
        for (const std::size_t one : shape) size *= one;
        out.arrays.push_back(
            {std::string("policy0.") + name, std::move(shape), std::vector<float>(size, value)});
    };
    add("input_mean", {inputs}, 0.0F);
    add("input_sd", {inputs}, 1.0F);
    add("layer0.weight", {2, inputs}, 0.0F);
    add("layer0.bias", {2}, 0.0F);
    add("layer1.weight", {outputs, 2}, 0.0F);
    add("layer1.bias", {outputs}, 0.0F);
    add("output_mean", {outputs}, 0.1F);
    add("output_sd", {outputs}, 1.0F);
    return out;
}

}  // namespace

TEST_SUITE("physics/policy") {
    TEST_CASE("a goal is two directions, the hand and the time") {
        const auto figure = tests::figureOf(Stance::pinned);
        Body body = Body::make(figure).value();
        const BodyObserver observer(figure);
        std::vector<float> state(observer.stateSize());
        observer.writeState(body, state);
        const auto joints = body.jointPositions_m();
        const Vec3 shoulder = joints[figure.segment("left upper arm")],
                   elbow = joints[figure.segment("left forearm")];
        const Vec3 target = shoulder + Vec3(0.0, 0.0, 3.0);  // straight ahead of the shoulder

        std::vector<float> goal(BodyObserver::goalSize(true));
        observer.writeGoal(body.root(), state, {target, motion::Side::left, 0.25}, goal);
        CHECK(goal[0] == doctest::Approx(0.0));
        CHECK(goal[1] == doctest::Approx(0.0));
        CHECK(goal[2] == doctest::Approx(1.0));
        const Vec3 from_elbow = glm::normalize(target - elbow);
        for (int axis = 0; axis < 3; ++axis)
            CHECK(goal[static_cast<std::size_t>(3 + axis)] ==
                  doctest::Approx(from_elbow[axis]).epsilon(1e-5));
        CHECK(goal[6] == 1.0F);
        CHECK(goal[7] == doctest::Approx(std::sqrt(0.5)));
        CHECK(goal[8] == doctest::Approx(-0.5));

        std::vector<float> timeless(BodyObserver::goalSize(false));
        observer.writeGoal(body.root(), state, {target, motion::Side::right, {}}, timeless);
        CHECK(timeless[6] == -1.0F);
    }

    TEST_CASE("what is seen does not hang on where the body stands and faces") {
        const auto figure = tests::figureOf(Stance::pinned);
        Body body = Body::make(figure).value();
        const BodyObserver observer(figure);
        const Vec3 target(0.5, 1.2, 2.0);
        const auto seen = [&](const Pose& placed) {
            BodyState state = body.state();
            state.root.pose = {placed.position + placed.orientation * state.root.pose.position,
                               placed.orientation * state.root.pose.orientation};
            for (std::size_t i = 0; i < state.angles_rad.size(); ++i)
                state.angles_rad[i] = 0.05 * double(i % 3);
            Body moved = body;
            moved.setState(state);
            std::vector<float> out(observer.stateSize() + BodyObserver::goalSize(true));
            observer.writeState(moved, std::span(out).first(observer.stateSize()));
            observer.writeGoal(moved.root(), out, {transformPoint(placed, target), motion::Side::right, 0.5},
                               std::span(out).subspan(observer.stateSize()));
            return out;
        };
        const auto here = seen({}),
                   there = seen({Vec3(3.0, 0.0, -2.0), glm::angleAxis(1.1, Vec3(0.0, 1.0, 0.0))});
        for (std::size_t i = 0; i < here.size(); ++i)
            CHECK(here[i] == doctest::Approx(there[i]).epsilon(1e-4).scale(1.0));
    }

    TEST_CASE("the base motion is the demonstrations' mean, mirrored for the other hand") {
        const auto features = motion::PoseFeatures::of(motion::referenceHumanoid()).value();
        const auto& one = fewDemonstrations().front();
        const auto durations =
            motion::durationsOf(one.gesture, one.gesture.clip.frameCount(), one.gesture.clip.frame_time_s);
        const auto base = BaseMotion::meanOf(features, {one});
        // Of one demonstration alone it is that one, but for what its trajectory leaves out.
        const int middle = (one.gesture.peak_frame + one.gesture.hold_frame) / 2;
        const auto pose = base.pose(one.gesture.hand, middle * one.gesture.clip.frame_time_s, durations);
        const auto& shown = one.gesture.clip.frames[static_cast<std::size_t>(middle)];
        const auto map = motion::mapByVrmNames(features.skeleton());
        const auto joint = static_cast<std::size_t>(map[motion::armBones(one.gesture.hand).index_proximal]);
        CHECK(std::abs(glm::dot(pose.joints[joint].orientation, shown.joints[joint].orientation)) > 0.995);
        const auto other = one.gesture.hand == motion::Side::left ? motion::Side::right : motion::Side::left;
        const auto there = base.pose(other, middle * one.gesture.clip.frame_time_s, durations);
        const auto far = static_cast<std::size_t>(map[motion::armBones(other).index_proximal]);
        CHECK(std::abs(there.joints[far].orientation.w) ==
              doctest::Approx(std::abs(pose.joints[joint].orientation.w)).epsilon(1e-6));
    }

    TEST_CASE("a policy's system plays the same clip for the same request, at the gesture's own length") {
        const auto system = makeAmp(stillPolicy(), motion::referenceHumanoid());
        REQUIRE(system.has_value());
        CHECK((*system)->name() == "amp-base");
        const auto& near = fewDemonstrations().back();
        const auto a = (*system)->generate({"", near.target, 1, {}}),
                   b = (*system)->generate({"", near.target, 2, {}});
        CHECK(a.hand == near.gesture.hand);
        CHECK(std::abs(a.clip.frameCount() - near.gesture.clip.frameCount()) <= 1);
        REQUIRE(a.clip.frameCount() == b.clip.frameCount());
        for (std::size_t f = 0; f < a.clip.frames.size(); ++f)
            for (std::size_t j = 0; j < a.clip.frames[f].joints.size(); ++j)
                REQUIRE(a.clip.frames[f].joints[j].orientation == b.clip.frames[f].joints[j].orientation);
        const auto held = (*system)->generate({"", near.target, 1, {2.0, {}}});
        const double own_hold_s =
            (near.gesture.hold_frame - near.gesture.peak_frame) * near.gesture.clip.frame_time_s;
        CHECK(std::abs(held.clip.frameCount() - a.clip.frameCount() - 30.0 * (2.0 - own_hold_s)) <= 1.0);
    }

    TEST_CASE("weights of another architecture, body or shape are rejected by what is wrong") {
        const auto problem = [](const motion::NetworkWeights& weights) {
            const auto made = makeAmp(weights, motion::referenceHumanoid());
            return made ? std::string("none") : made.error().text();
        };
        auto weights = stillPolicy();
        weights.file = "w";
        CHECK(problem(weights) == "none");
        auto other = weights;
        other.architecture = "moglow";
        CHECK(problem(other).find("these are weights of 'moglow', expected 'amp'") != std::string::npos);
        other = weights;
        other.settings["only_cluster"] = 0.0;
        CHECK(problem(other).find("deixis learn join") != std::string::npos);
        for (const char* key : {"system", "stance", "with_phase", "clusters", "hidden", "features"}) {
            other = weights;
            other.settings.erase(key);
            CHECK(problem(other).find(key) != std::string::npos);
        }
        for (std::size_t i = 0; i < weights.arrays.size(); ++i) {
            other = weights;
            const std::string name = weights.arrays[i].name;
            other.arrays.erase(other.arrays.begin() + static_cast<std::ptrdiff_t>(i));
            CHECK(problem(other).find(name.substr(0, 6)) != std::string::npos);
        }
        other = weights;
        for (auto& array : other.arrays)
            if (array.name == "clusters") array.values[1] = 1.0F;
        CHECK(problem(other).find("found cluster 1, expected 0 to 0") != std::string::npos);
        other = weights;
        other.settings["hidden"] = std::string("2 x");
        CHECK(problem(other).find("found '2 x'") != std::string::npos);
    }
}
