// Whole simulated studies with the built-in systems.
#include <doctest/doctest.h>

#include <map>

#include "core/random.hpp"
#include "motion/generator.hpp"
#include "session_fixture.hpp"
#include "studies/simulated_participant.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Clips of the built-in systems, made when asked for.
class GeneratedClips : public ClipSource {
  public:
    GeneratedClips() {
        for (const std::string& name : motion::generatorNames()) {
            auto made = motion::makeGenerator(name, motion::referenceHumanoid(), {});
            REQUIRE(made.has_value());
            generators_.emplace(name, std::move(*made));
        }
    }
    [[nodiscard]] const motion::Clip& clip(const Trial& trial) const override {
        const auto key = std::make_pair(trial.system, trial.target_id);
        const auto found = clips_.find(key);
        if (found != clips_.end()) return found->second;
        const motion::GenerationRequest request{trial.target_id, trial.target,
                                                deriveSeed(1, trial.target_id)};
        return clips_.emplace(key, generators_.at(trial.system)->generate(request).clip).first->second;
    }

  private:
    std::map<std::string, std::unique_ptr<motion::Generator>> generators_;
    mutable std::map<std::pair<std::string, std::string>, motion::Clip> clips_;
};

struct Tally {
    double ratings = 0.0;
    int rated = 0;
    int correct = 0;
    int chosen = 0;

    [[nodiscard]] double naturalness() const { return ratings / rated; }
    [[nodiscard]] double accuracy() const { return static_cast<double>(correct) / chosen; }
};

/// Thirty targets, each shown by all four systems in both stages.
StudyPlan thirtyTargets() {
    TargetSpace space;
    space.count = 30;
    space.height_m = {0.1, 2.1};
    space.arc_deg = {-85.0, 85.0};
    space.radius_m = {1.9, 2.2};
    space.ball_diameter_m = 0.1;
    space.distractor_distance_m = {0.2, 0.4};
    const auto targets = sampleTargets(space, 5);
    REQUIRE(targets.has_value());
    StudyPlan plan;
    for (const StageKind stage : {StageKind::naturalness, StageKind::game})
        for (std::size_t i = 0; i < targets->size(); ++i)
            for (const std::string& system : motion::generatorNames()) {
                Trial trial;
                trial.index = static_cast<int>(plan.trials.size());
                trial.stage = stage;
                trial.system = system;
                trial.target_id = (*targets)[i].id;
                trial.target = (*targets)[i].target;
                trial.layout = "across";
                if (stage == StageKind::game) {
                    trial.layout = i % 2 == 0 ? "across" : "side-by-side";
                    trial.distractors = (*targets)[i].distractors;
                    const int turn = trial.index % 3;
                    trial.ball_order = {turn, (turn + 1) % 3, (turn + 2) % 3};
                }
                plan.trials.push_back(trial);
            }
    return plan;
}

std::map<std::string, Tally> run(const StudyPlan& plan, const ClipSource& clips,
                                 const SimulatedParameters& parameters, int participants) {
    Study study = handStudy();
    study.layouts[1] = {"side-by-side", -0.75, -0.25, 10.0};
    study.rating.break_every = 0;
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const motion::LocalPose idle = motion::relaxedPose(avatar);
    std::map<std::string, Tally> tallies;
    for (int person = 1; person <= participants; ++person) {
        SimulatedStation station(parameters, avatar, static_cast<std::uint64_t>(person));
        SessionRunner session(study, plan, clips, avatar, idle, {});
        int answers = 0;
        for (int i = 0; i < 200000 && !session.finished(); ++i) {
            const SessionStep step = session.step(station.beginFrame());
            for (const SessionEvent& event : step.events) {
                const auto* response = std::get_if<Response>(&event);
                if (response == nullptr) continue;
                ++answers;
                Tally& tally = tallies[plan.trials[static_cast<std::size_t>(response->trial_index)].system];
                if (response->rating > 0) {
                    tally.ratings += response->rating;
                    ++tally.rated;
                } else {
                    ++tally.chosen;
                    tally.correct += response->correct ? 1 : 0;
                }
            }
            (void)session.shown(station.present(step.frame));
        }
        CHECK(answers == static_cast<int>(plan.trials.size()));
    }
    return tallies;
}

}  // namespace

TEST_SUITE("studies/simulated_study") {
    TEST_CASE(
        "over 30 targets stiff is the least natural of the accurate systems and drifting the least "
        "accurate") {
        const StudyPlan plan = thirtyTargets();
        const GeneratedClips clips;
        auto tallies = run(plan, clips, {}, 3);
        REQUIRE(tallies.size() == 4);
        CHECK(tallies["demonstration-nn"].naturalness() > 3.7);
        CHECK(tallies["demonstration-nn"].naturalness() < 4.3);
        CHECK(tallies["direct"].naturalness() > 3.7);
        CHECK(tallies["stiff"].naturalness() > 2.1);
        CHECK(tallies["stiff"].naturalness() < 2.9);
        CHECK(tallies["drifting"].naturalness() > 2.3);
        CHECK(tallies["drifting"].naturalness() < 3.2);
        CHECK(tallies["drifting"].accuracy() < tallies["demonstration-nn"].accuracy() - 0.1);
        CHECK(tallies["demonstration-nn"].accuracy() < tallies["direct"].accuracy());
        CHECK(tallies["direct"].accuracy() > 0.85);
        CHECK(tallies["stiff"].accuracy() > 0.85);
    }

    TEST_CASE("without noise it finds every target of a system that points exactly") {
        StudyPlan plan = thirtyTargets();
        std::erase_if(plan.trials, [](const Trial& trial) {
            return trial.stage == StageKind::naturalness || trial.system != "stiff";
        });
        for (std::size_t i = 0; i < plan.trials.size(); ++i) plan.trials[i].index = static_cast<int>(i);
        SimulatedParameters exact;
        exact.pointing_noise_deg = 0.0;
        exact.lapse_rate = 0.0;
        const GeneratedClips clips;
        CHECK(run(plan, clips, exact, 1)["stiff"].accuracy() == 1.0);
    }
}
