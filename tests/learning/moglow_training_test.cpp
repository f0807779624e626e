// Trainings of a minute model on a few synthetic demonstrations: that they run, stop, go on and repeat. What
// a whole training gives is not tested here.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/files.hpp"
#include "learning/moglow/training.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using namespace deixis::learning;

namespace {

const MoglowData& fewDemonstrations() {
    static const MoglowData data = [] {
        motion::DemonstrationParameters parameters;
        parameters.left_count = 2;
        parameters.right_count = 3;
        const auto made = motion::makeDemonstrations(motion::referenceHumanoid(), parameters).value();
        MoglowData out;
        out.training = {made[0], made[1], made[2], made[3]};
        out.validation = {made[4]};
        out.sha256 = "few";
        return out;
    }();
    return data;
}

MoglowSettings small(int updates) {
    MoglowSettings settings;
    settings.shape = {2, 8, 4, 0, 0.05};
    settings.updates = updates;
    settings.batch = 2;
    settings.warm_up = 20;
    settings.validate_every = 20;
    return settings;
}

/// A folder that is removed at the end.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("deixis-moglow-" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

bool goOn(const MoglowProgress&) {
    return true;
}

}  // namespace

TEST_SUITE("learning/moglow_training") {
    TEST_CASE("the likelihood grows, and what is written is a system that plays") {
        const Folder folder;
        const auto file = folder.path / "moglow.weights";
        std::vector<double> bits;
        const auto outcome = trainMoglow(fewDemonstrations(), small(60), {"9.9", "abc"}, file,
                                         [&bits](const MoglowProgress& progress) {
                                             bits.push_back(progress.bits);
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
        const Folder folder;
        const auto whole = folder.path / "whole", parts = folder.path / "parts";
        REQUIRE(trainMoglow(fewDemonstrations(), small(40), {}, whole, goOn).has_value());
        const auto first = trainMoglow(fewDemonstrations(), small(40), {}, parts,
                                       [](const MoglowProgress& progress) { return progress.update < 30; });
        REQUIRE(first.has_value());
        CHECK(first->stopped);
        CHECK(first->updates == 30);
        CHECK(motion::loadMoglow(parts, motion::referenceHumanoid()).has_value());
        const auto second = trainMoglow(fewDemonstrations(), small(40), {}, parts, goOn);
        REQUIRE(second.has_value());
        CHECK(second->updates == 40);
        CHECK(readFile(parts).value() == readFile(whole).value());
    }

    TEST_CASE("a training that is stopped before its first trial leaves a file to use, and a state") {
        const Folder folder;
        const auto file = folder.path / "w";
        const auto outcome = trainMoglow(fewDemonstrations(), small(40), {}, file,
                                         [](const MoglowProgress&) { return false; });
        REQUIRE(outcome.has_value());
        CHECK(outcome->updates == 10);
        CHECK(motion::loadMoglow(file, motion::referenceHumanoid()).has_value());
        // The state is of these settings alone.
        MoglowSettings others = small(40);
        others.dropout = 0.6;
        const auto refused = trainMoglow(fewDemonstrations(), others, {}, file, goOn);
        REQUIRE_FALSE(refused.has_value());
        CHECK(refused.error().text().find("other settings") != std::string::npos);
        REQUIRE(writeFile(file.string() + ".training", "nonsense").has_value());
        const auto damaged = trainMoglow(fewDemonstrations(), small(40), {}, file, goOn);
        REQUIRE_FALSE(damaged.has_value());
        CHECK(damaged.error().text().find("damaged") != std::string::npos);
    }

    TEST_CASE("a training that diverges is stopped by name, and the last good weights are kept") {
        const Folder folder;
        const auto file = folder.path / "w";
        MoglowSettings settings = small(200);
        settings.learning_rate = 1e6;
        settings.max_gradient = settings.max_gradient_norm = 1e30;
        settings.warm_up = 100000000;  // a rate of 0.01 at first, and 0.01 more with each update
        settings.validate_every = 1;
        const auto outcome = trainMoglow(fewDemonstrations(), settings, {}, file, goOn);
        REQUIRE_FALSE(outcome.has_value());
        CHECK(outcome.error().message.find("diverged at update") != std::string::npos);
        CHECK(outcome.error().hint.find("are kept") != std::string::npos);
        CHECK(motion::loadMoglow(file, motion::referenceHumanoid()).has_value());
    }

    TEST_CASE("without demonstrations to learn from, or held out, it says so") {
        MoglowData none = fewDemonstrations();
        none.validation.clear();
        const auto outcome = trainMoglow(none, small(10), {}, "/tmp/never", goOn);
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
        CHECK(MoglowMeasures{0.5, 0.9, 2.5}.score() == doctest::Approx(0.5 - 0.01 - 0.02));
    }
}
