// gt-nn of weights: the demonstrations come back as they went in.
#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/learned/gt_nn.hpp"

using namespace deixis;
using namespace deixis::motion;

namespace {

const std::vector<Demonstration>& few() {
    static const auto made = [] {
        DemonstrationParameters parameters;
        parameters.left_count = 1;
        parameters.right_count = 2;
        return makeDemonstrations(referenceHumanoid(), parameters).value();
    }();
    return made;
}

NetworkWeights throughFile() {
    return decodeWeights(encodeWeights(gtNnWeights(few()), WeightsPrecision::float32), "w").value();
}

std::string problem(const NetworkWeights& weights) {
    const auto made = makeGtNn(weights, referenceHumanoid());
    return made ? "none" : made.error().text();
}

}  // namespace

TEST_SUITE("motion/gt_nn") {
    TEST_CASE("the nearest demonstration is played, unchanged to a float's digits") {
        const auto system = makeGtNn(throughFile(), referenceHumanoid());
        REQUIRE(system.has_value());
        for (const Demonstration& one : few()) {
            const auto made = (*system)->generate({"", one.target + Vec3(0.02), 1, {}});
            CHECK(made.hand == one.gesture.hand);
            CHECK(made.onset_frame == one.gesture.onset_frame);
            CHECK(made.peak_frame == one.gesture.peak_frame);
            CHECK(made.hold_frame == one.gesture.hold_frame);
            CHECK(made.end_frame == one.gesture.end_frame);
            CHECK(made.clip.frame_time_s == doctest::Approx(one.gesture.clip.frame_time_s));
            REQUIRE(made.clip.frameCount() == one.gesture.clip.frameCount());
            for (std::size_t f = 0; f < made.clip.frames.size(); ++f)
                for (std::size_t j = 0; j < made.clip.frames[f].joints.size(); ++j) {
                    const Pose &a = made.clip.frames[f].joints[j], &b = one.gesture.clip.frames[f].joints[j];
                    REQUIRE(glm::distance(a.position, b.position) < 1e-6);
                    REQUIRE(std::abs(glm::dot(a.orientation, b.orientation)) > 1.0 - 1e-12);
                }
        }
    }

    TEST_CASE("a hold that is requested lasts as long, and the rest stays") {
        const auto system = makeGtNn(throughFile(), referenceHumanoid()).value();
        const auto& one = few().front();
        const auto own = system->generate({"", one.target, 1, {}});
        for (const double hold_s : {0.2, 3.0}) {
            const auto held = system->generate({"", one.target, 1, {hold_s, {}}});
            CHECK(held.hold_frame - held.peak_frame == std::lround(hold_s * 30.0));
            CHECK(held.end_frame - held.hold_frame == own.end_frame - own.hold_frame);
            CHECK(held.clip.frameCount() - held.end_frame == own.clip.frameCount() - own.end_frame);
            const auto& a = held.clip.frames.back().joints[3];
            const auto& b = own.clip.frames.back().joints[3];
            CHECK(std::abs(glm::dot(a.orientation, b.orientation)) > 1.0 - 1e-9);
        }
    }

    TEST_CASE("what is missing or of another avatar is named") {
        CHECK(problem(throughFile()) == "none");
        auto other = throughFile();
        other.architecture = "amp";
        CHECK(problem(other).find("these are weights of 'amp'") != std::string::npos);
        other = throughFile();
        other.settings["joints"] = std::string("hips");
        CHECK(problem(other).find("other joints than this avatar") != std::string::npos);
        for (const auto& array : throughFile().arrays) {
            other = throughFile();
            std::erase_if(other.arrays, [&](const NamedArray& one) { return one.name == array.name; });
            CHECK(problem(other).find(array.name) != std::string::npos);
        }
        other = throughFile();
        for (auto& array : other.arrays)
            if (array.name == "gestures") array.values[2] = 9000.0F;
        CHECK(problem(other).find("clip0") != std::string::npos);
    }
}
