// Trainings of minute policies on a few synthetic demonstrations: that they run, stop, go on, repeat, and
// come together from parts and from several ranks. What a whole training gives is not tested here.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>
#include <tuple>
#include <variant>

#include "core/files.hpp"
#include "learning/amp/training.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/phases.hpp"
#include "physics/policy/amp_system.hpp"
#include "small_trainings.hpp"

using namespace deixis;
using namespace deixis::learning;
using tests::fewDemonstrations;
using tests::goOn;
using tests::TrainingFolder;

namespace {

AmpTraining smallAmp(int clusters = 1) {
    AmpTraining out{.system = clusters == 1 ? "amp-base" : "amp-pfnn-2"};
    AmpSettings& settings = out.settings;
    settings.variant.phase_functioned = clusters > 1;
    settings.hidden = {16, 8};
    settings.environments = 8;
    settings.horizon = 8;
    settings.epochs = 2;
    settings.minibatch = 16;
    settings.discriminator_batch = 16;
    settings.discriminator_updates = 2;
    settings.remembered = 200;
    settings.remembered_each = 20;
    settings.demonstration_repeats = 1;
    settings.cloning_updates = 60;
    settings.frozen_iterations = 2;
    settings.iterations = 8;
    settings.validate_every = 4;
    settings.validation_targets = 2;
    out.clusters = clustersOf(fewDemonstrations(), clusters, {}).value();
    return out;
}

Result<TrainingOutcome> trained(const AmpTraining& training, const std::filesystem::path& file,
                                const TrainingReport& report = goOn) {
    return trainAmp(fewDemonstrations(), training, {"9.9", "abc"}, file, report);
}

std::string bytes(const std::filesystem::path& file) {
    return readFile(file).value();
}

}  // namespace

TEST_SUITE("learning/amp_training") {
    TEST_CASE("what is written is a system that plays, and says where it comes from") {
        const TrainingFolder folder;
        const auto file = folder.path / "amp.weights";
        std::vector<TrainingProgress> reports;
        const auto outcome = trained(smallAmp(), file, [&](const TrainingProgress& progress) {
            reports.push_back(progress);
            return true;
        });
        REQUIRE(outcome.has_value());
        CHECK_FALSE(outcome->stopped);
        CHECK(outcome->updates == 8);
        CHECK_FALSE(std::filesystem::exists(file.string() + ".training"));
        REQUIRE(reports.size() == 3);  // cloned, and at 4 and 8
        CHECK(reports.front().update == 0);
        CHECK(reports.front().best);
        CHECK(reports.back().done == 1.0);
        CHECK(reports.back().validation.has_value());

        const auto weights = motion::readWeights(file, physics::amp_architecture);
        REQUIRE(weights.has_value());
        CHECK(weights->commit == "abc");
        CHECK(weights->synthetic);
        CHECK(weights->training_data_sha256 == "few");
        CHECK(weights->number("actor_rate").value() == smallAmp().settings.actor_rate);
        // Not the clone, which has tried out nothing.
        CHECK(weights->metrics.at("best_iteration") > smallAmp().settings.frozen_iterations);
        CHECK(weights->metrics.at("validation_reward") == doctest::Approx(outcome->best.reward));
        const auto system = physics::makeAmp(*weights, motion::referenceHumanoid());
        REQUIRE(system.has_value());
        CHECK((*system)->name() == "amp-base");
        CHECK((*system)->generate({"", Vec3(0.3, 1.2, 2.0), 1, {}}).clip.frameCount() > 30);
    }

    TEST_CASE("settings are changed by name, stand in the file, and are rejected where they are none") {
        AmpSettings settings;
        REQUIRE(changeSetting(settings, "task_after_hold", "0.25").has_value());
        REQUIRE(changeSetting(settings, "epochs", "7").has_value());
        CHECK(settings.task_after_hold == 0.25);
        CHECK(settings.epochs == 7);
        const auto named = namedSettings(settings);
        CHECK(std::get<double>(named.at("task_after_hold")) == 0.25);
        CHECK(std::get<double>(named.at("epochs")) == 7.0);
        for (const auto& [name, value, said] :
             {std::tuple{"epochs", "7.5", "found '7.5', expected a whole number from 1 to 100"},
              {"discount", "1", "found '1', expected a number from 0 to 0.9999"},
              {"discount", "", "found ''"},
              {"style", "1", "is no setting; they are style_weight, task_weight, "}}) {
            const auto changed = changeSetting(settings, name, value);
            REQUIRE_FALSE(changed.has_value());
            CHECK(changed.error().where == name);
            CHECK_MESSAGE(changed.error().message.find(said) != std::string::npos, changed.error().message);
        }
    }

    TEST_CASE("what is not of the paper makes another policy, alone and together, and goes on as any does") {
        const TrainingFolder folder;
        const auto plain = folder.path / "plain";
        REQUIRE(trained(smallAmp(), plain).has_value());
        const auto policy = [](const std::filesystem::path& file) {
            return motion::readWeights(file, "amp").value().arrays;
        };
        const auto differ = [](const auto& a, const auto& b) {
            REQUIRE(a.size() == b.size());
            for (std::size_t i = 0; i < a.size(); ++i)
                if (a[i].values != b[i].values) return true;
            return false;
        };
        AmpTraining all = smallAmp();
        for (const auto& [name, value] : {std::pair{"lipschitz_penalty", "0.002"},
                                          {"power_penalty", "0.0005"},
                                          {"discriminator_window", "5"},
                                          {"separate_critics", "1"},
                                          {"averaged_iterations", "1"}}) {
            CAPTURE(name);
            AmpTraining one = smallAmp();
            REQUIRE(changeSetting(one.settings, name, value).has_value());
            REQUIRE(changeSetting(all.settings, name, value).has_value());
            REQUIRE(trained(one, folder.path / name).has_value());
            CHECK(differ(policy(folder.path / name), policy(plain)));
        }
        const auto whole = folder.path / "whole", parts = folder.path / "parts";
        REQUIRE(trained(all, whole).has_value());
        REQUIRE(trained(all, parts, [](const TrainingProgress& progress) {
                    return progress.update < 4;
                }).has_value());
        REQUIRE(trained(all, parts).has_value());
        CHECK(bytes(parts) == bytes(whole));
    }

    TEST_CASE("a training that was stopped goes on to the very same weights") {
        const TrainingFolder folder;
        const auto whole = folder.path / "whole", parts = folder.path / "parts";
        REQUIRE(trained(smallAmp(), whole).has_value());
        const auto first =
            trained(smallAmp(), parts, [](const TrainingProgress& progress) { return progress.update < 4; });
        REQUIRE(first.has_value());
        CHECK(first->stopped);
        CHECK(first->updates == 4);
        CHECK(std::filesystem::exists(parts.string() + ".training"));
        CHECK(physics::makeAmp(motion::readWeights(parts, "amp").value(), motion::referenceHumanoid())
                  .has_value());
        const auto second = trained(smallAmp(), parts);
        REQUIRE(second.has_value());
        CHECK(second->updates == 8);
        CHECK(bytes(parts) == bytes(whole));
    }

    TEST_CASE("stopped before it has tried anything out, it leaves what the demonstrations taught") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        const auto outcome = trained(smallAmp(), file, [](const TrainingProgress&) { return false; });
        REQUIRE(outcome.has_value());
        CHECK(outcome->updates == 0);
        CHECK(physics::makeAmp(motion::readWeights(file, "amp").value(), motion::referenceHumanoid())
                  .has_value());
    }

    TEST_CASE("a policy that does not know the time learns from demonstrations to raise, and stays up") {
        const TrainingFolder folder;
        const auto file = folder.path / "raises.weights";
        AmpTraining training = smallAmp();
        training.system = "amp-no-runtime";
        training.settings.variant.policy_phase = false;
        training.settings.hidden = {64, 32};
        training.settings.cloning_updates = 2000;
        REQUIRE(trained(training, file, [](const TrainingProgress&) { return false; }));
        const auto system =
            physics::makeAmp(motion::readWeights(file, "amp").value(), motion::referenceHumanoid());
        REQUIRE(system.has_value());
        const auto& one = fewDemonstrations().training.front();
        const auto made = (*system)->generate({"", one.target, 1, {}});
        const auto hand = static_cast<std::size_t>(
            motion::mapByVrmNames(made.clip.skeleton)[motion::armBones(made.hand).hand]);
        const auto world = motion::worldPoses(made.clip);
        CHECK(world.back()[hand].position.y > world.front()[hand].position.y + 0.2);
    }

    TEST_CASE("clusters in threads, one after another, or each by itself and joined: the same policies") {
        const TrainingFolder folder;
        AmpTraining training = smallAmp(2);
        const auto one = folder.path / "one", two = folder.path / "two", joined = folder.path / "joined";
        REQUIRE(trained(training, one).has_value());
        training.threads = 2;
        REQUIRE(trained(training, two).has_value());
        CHECK(bytes(one) == bytes(two));

        std::vector<std::filesystem::path> parts;
        for (const int cluster : {1, 0}) {
            training.only_cluster = cluster;
            parts.push_back(folder.path / ("part" + std::to_string(cluster)));
            REQUIRE(trained(training, parts.back()).has_value());
        }
        const auto part =
            physics::makeAmp(motion::readWeights(parts[0], "amp").value(), motion::referenceHumanoid());
        REQUIRE_FALSE(part.has_value());
        CHECK(part.error().text().find("deixis learn join") != std::string::npos);
        REQUIRE(joinAmp(parts, joined).has_value());
        const auto a = motion::readWeights(one, "amp").value(),
                   b = motion::readWeights(joined, "amp").value();
        CHECK(a.settings == b.settings);
        for (const auto& array : a.arrays)
            CHECK(b.array(array.name, array.shape).value()->values == array.values);

        CHECK(joinAmp({parts[0]}, joined).error().text().find("cluster 0 of 2 is missing") !=
              std::string::npos);
        CHECK(joinAmp({parts[0], parts[0]}, joined).error().text().find("cluster 1 is also in") !=
              std::string::npos);
        CHECK(joinAmp({one}, joined).error().text().find("whole already") != std::string::npos);
        training.settings.seed = 2;
        training.only_cluster = 0;
        REQUIRE(trained(training, folder.path / "other").has_value());
        CHECK(joinAmp({parts[0], folder.path / "other"}, joined).error().text().find("seeds") !=
              std::string::npos);
    }

    TEST_CASE("a state of other settings, or a damaged one, is rejected by name") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        REQUIRE(trained(smallAmp(), file, [](const TrainingProgress&) { return false; }).has_value());
        AmpTraining other = smallAmp();
        other.settings.actor_rate = 2e-4;
        const auto rejected = trained(other, file);
        REQUIRE_FALSE(rejected.has_value());
        CHECK(rejected.error().text().find("other settings or demonstrations") != std::string::npos);
        REQUIRE(writeFile(file.string() + ".training/cluster-0", "no archive").has_value());
        const auto damaged = trained(smallAmp(), file);
        REQUIRE_FALSE(damaged.has_value());
        CHECK(damaged.error().text().find("cluster-0: this is no state of a training, or damaged") !=
              std::string::npos);
    }

    TEST_CASE("two ranks learn the same policy from twice as much, and the first writes it") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        const auto in_rank = [&](int rank, std::vector<TrainingProgress>& reports) {
            AmpTraining training = smallAmp();
            training.rank =
                RankPlace{rank, 2, "127.0.0.1", static_cast<std::uint16_t>(20000 + getpid() % 20000)};
            return trained(training, rank == 0 ? file : folder.path / "none",
                           [&reports](const TrainingProgress& progress) {
                               reports.push_back(progress);
                               return true;
                           });
        };
        std::vector<TrainingProgress> of_first, of_second, of_one;
        Result<TrainingOutcome> second;
        std::thread other([&] { second = in_rank(1, of_second); });
        const auto first = in_rank(0, of_first);
        other.join();
        REQUIRE(first.has_value());
        REQUIRE(second.has_value());
        CHECK(first->updates == 8);
        CHECK_FALSE(std::filesystem::exists(folder.path / "none"));
        CHECK(physics::makeAmp(motion::readWeights(file, "amp").value(), motion::referenceHumanoid())
                  .has_value());
        // Each has tried out bodies of its own, and what the first did is not what it does alone.
        REQUIRE(trained(smallAmp(), folder.path / "alone", [&](const TrainingProgress& progress) {
                    of_one.push_back(progress);
                    return true;
                }).has_value());
        REQUIRE(of_first.size() == 3);
        REQUIRE(of_second.size() == 3);
        CHECK(of_first.back().numbers[0] != of_second.back().numbers[0]);
        CHECK(of_first.back().numbers[0] != of_one.back().numbers[0]);
    }
}
