// Trainings of a minute model on a few synthetic demonstrations: that they run, stop, go on and repeat. What
// a whole training gives is not tested here.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/files.hpp"
#include "learning/moglow/training.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "small_trainings.hpp"

using namespace deixis;
using namespace deixis::learning;
using tests::fewDemonstrations;
using tests::goOn;
using tests::TrainingFolder;

namespace {

MoglowSettings smallMoglow(int updates) {
    MoglowSettings settings;
    settings.shape = {2, 8, 4, 0, 0.05};
    settings.updates = updates;
    settings.batch = 2;
    settings.warm_up = 20;
    settings.validate_every = 20;
    return settings;
}

}  // namespace

TEST_SUITE("learning/moglow_training") {
    TEST_CASE("the likelihood grows, and what is written is a system that plays") {
        const TrainingFolder folder;
        const auto file = folder.path / "moglow.weights";
        std::vector<double> bits;
        const auto outcome = trainMoglow(fewDemonstrations(), smallMoglow(60), {"9.9", "abc"}, file,
                                         [&bits](const TrainingProgress& progress) {
                                             bits.push_back(progress.numbers.front().second);
                                             return true;
                                         });
        REQUIRE(outcome.has_value());
        CHECK(outcome->updates == 60);
        CHECK_FALSE(outcome->stopped);
        REQUIRE(bits.size() == 6);
        CHECK(bits.back() < bits.front() - 10.0);
        CHECK_FALSE(std::filesystem::exists(file.string() + ".training"));
        const auto weights = motion::readWeights(file, "moglow");
        REQUIRE(weights.has_value());
        CHECK(weights->program_version == "9.9");
        CHECK(weights->commit == "abc");
        CHECK(weights->training_data_sha256 == "few");
        CHECK(weights->synthetic);
        CHECK(weights->metrics.at("validation_reward") == outcome->best.reward);
        const auto system = motion::loadMoglow(file, motion::referenceHumanoid());
        REQUIRE(system.has_value());
        const auto measures = measureGenerated(**system, fewDemonstrations().validation, 1);
        CHECK(measures.reward == outcome->best.reward);
    }

    TEST_CASE("stopped and gone on with it ends as if it had never been stopped") {
        const TrainingFolder folder;
        const auto whole = folder.path / "whole", parts = folder.path / "parts";
        REQUIRE(trainMoglow(fewDemonstrations(), smallMoglow(40), {}, whole, goOn).has_value());
        const auto first = trainMoglow(fewDemonstrations(), smallMoglow(40), {}, parts,
                                       [](const TrainingProgress& progress) { return progress.update < 30; });
        REQUIRE(first.has_value());
        CHECK(first->stopped);
        CHECK(first->updates == 30);
        CHECK(motion::loadMoglow(parts, motion::referenceHumanoid()).has_value());
        const auto second = trainMoglow(fewDemonstrations(), smallMoglow(40), {}, parts, goOn);
        REQUIRE(second.has_value());
        CHECK(second->updates == 40);
        CHECK(readFile(parts).value() == readFile(whole).value());
    }

    TEST_CASE("a training that is stopped before its first trial leaves a file to use, and a state") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        const auto outcome = trainMoglow(fewDemonstrations(), smallMoglow(40), {}, file,
                                         [](const TrainingProgress&) { return false; });
        REQUIRE(outcome.has_value());
        CHECK(outcome->updates == 10);
        CHECK(motion::loadMoglow(file, motion::referenceHumanoid()).has_value());
        // The state is of these settings alone.
        MoglowSettings others = smallMoglow(40);
        others.dropout = 0.6;
        const auto rejected = trainMoglow(fewDemonstrations(), others, {}, file, goOn);
        REQUIRE_FALSE(rejected.has_value());
        CHECK(rejected.error().text().find("other settings") != std::string::npos);
        REQUIRE(writeFile(file.string() + ".training", "nonsense").has_value());
        const auto damaged = trainMoglow(fewDemonstrations(), smallMoglow(40), {}, file, goOn);
        REQUIRE_FALSE(damaged.has_value());
        CHECK(damaged.error().text().find("damaged") != std::string::npos);
    }

    TEST_CASE("a training that diverges is stopped by name, and the last good weights are kept") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        REQUIRE(
            trainMoglow(fewDemonstrations(), smallMoglow(40), {}, file, [](const TrainingProgress& progress) {
                return progress.update < 20;
            }).has_value());
        // It goes on with targets that no float holds.
        DemonstrationSets broken = fewDemonstrations();
        for (auto& one : broken.training) one.target *= 1e40;
        const auto outcome = trainMoglow(broken, smallMoglow(40), {}, file, goOn);
        REQUIRE_FALSE(outcome.has_value());
        CHECK(outcome.error().message.find("diverged at update 21") != std::string::npos);
        CHECK(outcome.error().hint.find("weights of update 20 are kept") != std::string::npos);
        CHECK(motion::loadMoglow(file, motion::referenceHumanoid()).has_value());
    }

    TEST_CASE("without demonstrations to learn from, or held out, it says so") {
        DemonstrationSets none = fewDemonstrations();
        none.validation.clear();
        const auto outcome = trainMoglow(none, smallMoglow(10), {}, "/tmp/never", goOn);
        REQUIRE_FALSE(outcome.has_value());
        CHECK(outcome.error().message.find("0 held out") != std::string::npos);
    }

    TEST_CASE("demonstrations measured as what they are: at rest, with their own jerk") {
        // Plays the demonstration of the target asked for.
        class Playback : public motion::Generator {
          public:
            std::string_view name() const override { return "playback"; }
            motion::GeneratedClip generate(const motion::GenerationRequest& request) const override {
                for (const auto& one : fewDemonstrations().training)
                    if (one.target == request.target) return one.gesture;
                return {};
            }
        };
        const auto measures = measureGenerated(Playback(), fewDemonstrations().training, 1);
        CHECK(measures.at_rest == 1.0);
        CHECK(measures.jerk_ratio == doctest::Approx(1.0));
        CHECK(measures.reward > 0.5);  // docs/systems.md: a plateau of 0.54
        CHECK(measures.reward < 0.632);
        const ClipMeasures shaken{.reward = 0.5, .at_rest = 0.9, .jerk_ratio = 2.5};
        CHECK(shaken.score() == doctest::Approx(0.5 - 0.03 - 0.05));
        CHECK(shaken.score(false) == doctest::Approx(0.5 - 0.05));
    }
}
