#include "motion/learned/moglow.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "flow_fixture.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;
using doctest::Approx;

namespace {

const PoseFeatures& features() {
    static const PoseFeatures made = PoseFeatures::of(referenceHumanoid()).value();
    return made;
}

/// A model of random numbers: it moves, but nobody would call it pointing.
NetworkWeights randomModel(int look_ahead = 0) {
    const MoglowShape shape{2, 8, 3, look_ahead, 0.05};
    const int size = static_cast<int>(features().size());
    NetworkWeights out;
    out.file = "w.bin";
    out.architecture = "moglow";
    out.settings = {{"steps", 2.0},
                    {"hidden", 8.0},
                    {"past_frames", 3.0},
                    {"look_ahead", static_cast<double>(look_ahead)},
                    {"frame_time_s", 0.05},
                    {"raise_s", 0.8},
                    {"hold_s", 1.0},
                    {"temperature", 1.0},
                    {"features", features().names()}};
    out.arrays = randomFlowArrays({size, shape.hidden, shape.steps, shape.hidden}, 7);
    Random random(8);
    const auto n = static_cast<std::size_t>(size);
    const auto condition = static_cast<std::size_t>(shape.conditionSize(size));
    out.arrays.push_back(randomArray("encoder.weight", {8, condition}, 0.1, random));
    out.arrays.push_back(randomArray("encoder.bias", {8}, 0.1, random));
    out.arrays.push_back({"feature_mean", {n}, std::vector<float>(n, 0.1F)});
    out.arrays.push_back({"feature_sd", {n}, std::vector<float>(n, 0.05F)});
    return out;
}

std::string rejected(const NetworkWeights& weights) {
    const auto made = Moglow::of(weights, features());
    REQUIRE_FALSE(made.has_value());
    return made.error().text();
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("motion/moglow") {
    TEST_CASE("a frame is conditioned on the poses before it, the target and the pointing bits around it") {
        const MoglowShape shape{1, 1, 2, 1, 0.05};
        const ControlledFrames frames{
            Vec3(0.5, 1.5, 2.0), {false, true, true, false}, {{1.0, 10.0}, {2.0, 20.0}, {3.0, 30.0}}};
        const std::vector<double> at_ease{-1.0, -2.0};
        // Two poses of two numbers; the target; bits of the two frames before, the frame, and one after.
        CHECK(moglowCondition(frames, 0, at_ease, shape) ==
              std::vector<float>{-1, -2, -1, -2, 0.5, 1.5, 2, 0, 0, 0, 1});
        CHECK(moglowCondition(frames, 1, at_ease, shape) ==
              std::vector<float>{-1, -2, 1, 10, 0.5, 1.5, 2, 0, 0, 1, 1});
        CHECK(moglowCondition(frames, 3, at_ease, shape) ==
              std::vector<float>{2, 20, 3, 30, 0.5, 1.5, 2, 1, 1, 0, 0});
        CHECK(shape.conditionSize(2) == 11);
    }

    TEST_CASE("what a model draws has the likelihood of the latents that it was drawn from") {
        const auto model = Moglow::of(randomModel(), features());
        REQUIRE(model.has_value());
        Random random(3, "moglow");
        const std::vector<bool> pointing{false, true, true, true, false, false};
        ControlledFrames drawn{Vec3(0.4, 1.2, 2.0), pointing, {}};
        for (const auto& frame : model->draw(drawn.target, pointing, random))
            drawn.features.push_back(model->standardised(frame));
        REQUIRE(drawn.features.size() == pointing.size());
        // log p = log N(z) + log-determinant: the same latents, drawn again, and the flow's own determinant.
        const auto likelihoods = model->logLikelihoods(drawn);
        const NetworkWeights weights = randomModel();
        const int size = static_cast<int>(features().size());
        const auto flow = ConditionalFlow::read(weights, {size, 8, 2, 8});
        const auto encoder = Linear::read(weights, "encoder", 3 * size + 7, 8);
        REQUIRE(flow.has_value());
        REQUIRE(encoder.has_value());
        Random again(3, "moglow");
        auto state = flow->zeroState();
        for (std::size_t at = 0; at < pointing.size(); ++at) {
            double expected = 0.0;
            for (int d = 0; d < size; ++d) {
                const double z = again.normal();
                expected -= 0.5 * (z * z + std::log(2.0 * pi));
            }
            const auto numbers =
                moglowCondition(drawn, at, model->standardised(std::vector<double>(features().size(), 0.0)),
                                {2, 8, 3, 0, 0.05});
            const VectorXf condition = encoder->forward(
                Eigen::Map<const VectorXf>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
            VectorXf x(size);
            for (int d = 0; d < size; ++d)
                x[d] = static_cast<float>(drawn.features[at][static_cast<std::size_t>(d)]);
            float log_determinant = 0.0F;
            (void)flow->forward(x, condition, state, log_determinant);
            CHECK(likelihoods[at] == Approx(expected + static_cast<double>(log_determinant)).epsilon(1e-4));
        }
    }

    TEST_CASE("the system's clips begin at ease, last as long as asked, and repeat with the seed alone") {
        const auto system = makeMoglow(randomModel(), referenceHumanoid());
        REQUIRE(system.has_value());
        CHECK((*system)->name() == "moglow");
        const GenerationRequest request{"T", Vec3(0.9, 1.2, 1.8), 5, {}};
        const GeneratedClip made = (*system)->generate(request);
        const GeneratedClip again = (*system)->generate(request);
        const GeneratedClip other = (*system)->generate({"T", Vec3(0.9, 1.2, 1.8), 6, {}});
        const GeneratedClip longer = (*system)->generate({"T", Vec3(0.9, 1.2, 1.8), 5, {2.0, {}}});
        // 0.5 s of rest, 0.8 of raise, 1 of hold and 2 after it, at 30 frames a second.
        CHECK(made.clip.frameCount() == 1 + 129);
        CHECK(longer.clip.frameCount() == made.clip.frameCount() + 30);
        CHECK(checkPhases(made, made.clip.frameCount()).has_value());
        const LocalPose at_ease = relaxedPose(referenceHumanoid());
        bool differs = false;
        for (std::size_t f = 0; f < made.clip.frames.size(); ++f)
            for (std::size_t j = 0; j < at_ease.joints.size(); ++j) {
                const Quat& q = made.clip.frames[f].joints[j].orientation;
                if (f == 0) CHECK(std::abs(glm::dot(q, at_ease.joints[j].orientation)) > 1.0 - 1e-12);
                CHECK(q == again.clip.frames[f].joints[j].orientation);
                CHECK(std::abs(glm::length(q) - 1.0) < 1e-9);
                differs = differs || q != other.clip.frames[f].joints[j].orientation;
            }
        CHECK(differs);
    }

    TEST_CASE("weights that do not fit are rejected with what was found and expected") {
        NetworkWeights weights = randomModel();
        CHECK(Moglow::of(weights, features()).has_value());
        weights.architecture = "amp-base";
        CHECK(contains(rejected(weights), "'amp-base'"));
        weights = randomModel();
        weights.settings["features"] = std::string("spine tail");
        CHECK(contains(rejected(weights), "spine tail"));
        weights = randomModel();
        weights.settings.erase("hidden");
        CHECK(contains(rejected(weights), "settings.hidden"));
        weights = randomModel();
        weights.settings["frame_time_s"] = 0.0;
        CHECK(contains(rejected(weights), "settings.frame_time_s"));
        weights = randomModel();
        weights.settings["hold_s"] = -1.0;
        CHECK(contains(rejected(weights), "settings.hold_s"));
        weights = randomModel();
        weights.arrays.back().values[3] = 0.0F;
        CHECK(contains(rejected(weights), "feature_sd"));
        weights = randomModel(2);
        weights.settings["look_ahead"] = 1.0;
        CHECK(Moglow::of(weights, features()).has_value() == false);
        CHECK(loadMoglow("/no/such/file", referenceHumanoid()).error().where == "/no/such/file");
    }
}
