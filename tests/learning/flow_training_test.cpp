// The whole training of the system flow, which takes seconds, on thirteen synthetic demonstrations.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/files.hpp"
#include "learning/flow/training.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/skeleton/kinematics.hpp"
#include "small_trainings.hpp"

using namespace deixis;
using namespace deixis::learning;
using tests::goOn;
using tests::TrainingFolder;

namespace {

const DemonstrationSets& thirteen() {
    static const DemonstrationSets data = [] {
        motion::DemonstrationParameters parameters;
        parameters.left_count = 0;
        parameters.right_count = 13;
        auto out = splitDemonstrations(
            motion::makeDemonstrations(motion::referenceHumanoid(), parameters).value(), false);
        out.sha256 = "thirteen";
        return out;
    }();
    return data;
}

FlowSettings quickFlow() {
    FlowSettings settings;
    settings.updates = 2000;
    settings.validate_every = 1000;
    return settings;
}

/// Of the line from the eyes through the fingertip in the middle of the hold.
double error_rad(const motion::GeneratedClip& made, const Vec3& target_m) {
    const motion::Skeleton& skeleton = made.clip.skeleton;
    const auto world = motion::worldPose(
        skeleton, made.clip.frames[static_cast<std::size_t>((made.peak_frame + made.hold_frame) / 2)]);
    const auto ray = motion::pointingRay(skeleton, motion::mapByVrmNames(skeleton), world, made.hand,
                                         motion::PointingRay::eye_fingertip);
    return motion::angularError(ray, target_m);
}

bool alike(const motion::Clip& a, const motion::Clip& b) {
    return std::ranges::equal(a.frames, b.frames, [](const auto& one, const auto& other) {
        return std::ranges::equal(one.joints, other.joints, [](const Pose& p, const Pose& q) {
            return p.position == q.position && p.orientation == q.orientation;
        });
    });
}

}  // namespace

TEST_SUITE("learning/flow_training") {
    TEST_CASE("what is trained points at targets it has not seen within a degree, each time differently") {
        const TrainingFolder folder;
        const auto file = folder.path / "flow.weights";
        const auto outcome = trainFlow(thirteen(), quickFlow(), {"9.9", "abc"}, file, goOn);
        REQUIRE(outcome.has_value());
        CHECK(outcome->updates == 2000);
        const auto weights = motion::readWeights(file, "flow");
        REQUIRE(weights.has_value());
        CHECK(weights->commit == "abc");
        CHECK(weights->number("demonstrations").value() == 12.0);
        const auto system = motion::makeFlow(*weights, motion::referenceHumanoid());
        REQUIRE(system.has_value());
        for (const Vec3 target_m : {Vec3(0.6, 1.3, 1.8), Vec3(-0.8, 0.9, 1.7), Vec3(-0.2, 1.6, 2.0)}) {
            const auto once = (*system)->generate({"", target_m, 1, {}});
            const auto again = (*system)->generate({"", target_m, 1, {}});
            const auto other = (*system)->generate({"", target_m, 2, {}});
            CHECK(once.hand == (target_m.x > 0.0 ? motion::Side::left : motion::Side::right));
            CHECK(error_rad(once, target_m) < radiansFromDegrees(1.0));
            CHECK(error_rad(other, target_m) < radiansFromDegrees(1.0));
            CHECK(alike(once.clip, again.clip));
            CHECK_FALSE(alike(once.clip, other.clip));
        }
        // As near as an arm's length, where nobody has pointed: a clip that somebody can watch.
        const auto near = (*system)->generate({"", Vec3(0.1, 1.2, 0.4), 1, {}});
        CHECK(near.clip.duration_s() < 15.0);
    }

    TEST_CASE("draws spread as the demonstrations do") {
        const TrainingFolder folder;
        const auto file = folder.path / "flow.weights";
        REQUIRE(trainFlow(thirteen(), quickFlow(), {}, file, goOn).has_value());
        const auto weights = motion::readWeights(file, "flow");
        REQUIRE(weights.has_value());
        const double drawn = weights->metrics.at("spread_drawn_m");
        const double demonstrated = weights->metrics.at("spread_demonstrated_m");
        CHECK(std::abs(drawn / demonstrated - 1.0) < 0.3);
        const double eye_limit_rad = weights->number("eye_limit_rad").value();
        const auto model = motion::FlowMatching::of(
            *weights, motion::GestureTrajectories::of(motion::referenceHumanoid(), eye_limit_rad).value());
        REQUIRE(model.has_value());
        const Spread other_draws = flowSpread(*model, thirteen().training, 99);
        CHECK(std::abs(other_draws.drawn_m / demonstrated - 1.0) < 0.3);
        CHECK(std::abs(other_draws.demonstrated_m - demonstrated) < 1e-6);
    }

    TEST_CASE("the same seed gives the same bytes, another seed others") {
        const TrainingFolder folder;
        FlowSettings settings = quickFlow();
        settings.updates = 200;
        const auto trained = [&](const char* name) {
            REQUIRE(trainFlow(thirteen(), settings, {}, folder.path / name, goOn).has_value());
            return readFile(folder.path / name).value();
        };
        const std::string first = trained("first");
        CHECK(first == trained("second"));
        settings.seed = 2;
        CHECK(first != trained("third"));
    }

    TEST_CASE("stopped it leaves a file to use; too few demonstrations are rejected with their number") {
        const TrainingFolder folder;
        const auto file = folder.path / "flow.weights";
        const auto stopped =
            trainFlow(thirteen(), quickFlow(), {}, file,
                      [](const TrainingProgress& progress) { return progress.update < 1000; });
        REQUIRE(stopped.has_value());
        CHECK(stopped->stopped);
        CHECK(stopped->updates == 1000);
        CHECK(motion::makeFlow(motion::readWeights(file, "flow").value(), motion::referenceHumanoid())
                  .has_value());
        const auto few = trainFlow(tests::fewDemonstrations(), quickFlow(), {}, folder.path / "few", goOn);
        REQUIRE_FALSE(few.has_value());
        CHECK(few.error().message.find("found 4 demonstrations to train on and 1 held out") !=
              std::string::npos);
        CHECK_FALSE(std::filesystem::exists(folder.path / "few"));
    }

    TEST_CASE("weights of another system, or without a part, are rejected by name") {
        motion::NetworkWeights weights;
        weights.file = "some.weights";
        weights.architecture = "moglow";
        const auto foreign = motion::FlowMatching::of(
            weights, motion::GestureTrajectories::of(motion::referenceHumanoid(), 0.4).value());
        REQUIRE_FALSE(foreign.has_value());
        CHECK(foreign.error().message.find("'moglow', expected 'flow'") != std::string::npos);
        weights.architecture = "flow";
        const auto partial = motion::makeFlow(weights, motion::referenceHumanoid());
        REQUIRE_FALSE(partial.has_value());
        CHECK(partial.error().where.find("some.weights") != std::string::npos);
    }
}
