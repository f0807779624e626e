// One cluster's policy through its training, with what is on disk of it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "learning/amp/training.hpp"
#include "physics/policy/amp_system.hpp"
#include "trainer.hpp"

namespace deixis::learning {

/// What the policies of a training have in common. All of it stays where it is.
struct AmpCommon {
    const DemonstrationSets& data;
    const AmpTraining& training;
    const physics::Body& body;
    const physics::BaseMotion& base;
    const motion::Skeleton& avatar;
    physics::AmpModel model;                  ///< with all targets
    std::vector<ReferenceMotion> references;  ///< one for each of the data's training set
    Ranks& ranks;
    std::filesystem::path folder;  ///< FILE.training
};

class PolicyTraining {
  public:
    /// The one that is best yet.
    struct Best {
        std::vector<motion::NamedArray> policy;  ///< arrays named policy0...
        ClipMeasures measures;
        int iteration = 0;  ///< 0: it has learned what the demonstrations do, and tried out nothing
    };

    PolicyTraining(const AmpCommon& common, int cluster);

    /// Goes on from the folder, or learns what the demonstrations do.
    [[nodiscard]] Result<void> begin();
    /// Iterates until the next try-out, and tries out. `report` is told of every tenth iteration and of the
    /// try-out; where it says no, what was done since the last try-out is left.
    [[nodiscard]] Result<void> continueToTryOut(const std::function<bool(TrainingProgress&)>& report);

    [[nodiscard]] bool done() const { return iterations_ >= common_.training.settings.iterations; }
    [[nodiscard]] int iterations() const { return iterations_; }
    [[nodiscard]] int cluster() const { return cluster_; }
    [[nodiscard]] const Best& best() const { return best_; }

  private:
    [[nodiscard]] std::string identity() const;
    [[nodiscard]] Result<bool> resume();
    [[nodiscard]] Result<void> save() const;
    [[nodiscard]] Result<ClipMeasures> tryOut(const std::vector<motion::NamedArray>& policy) const;
    /// Whether it is the best yet.
    [[nodiscard]] Result<bool> tryOutNow(ClipMeasures& measures);

    const AmpCommon& common_;
    int cluster_;
    std::uint64_t seed_;
    std::filesystem::path state_;
    std::vector<motion::Demonstration> validation_;
    std::vector<Vec3> validation_targets_m_;
    double demonstrated_jerk_ = 0.0;
    std::vector<ReferenceMotion> references_;
    std::optional<AmpTrainer> trainer_;
    int iterations_ = 0;
    Best best_;
};

}  // namespace deixis::learning
