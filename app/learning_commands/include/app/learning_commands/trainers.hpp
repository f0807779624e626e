// What trains. LibTorch takes most of a second to load, so the trainers are in a program of their own,
// deixis-train, which is built with DEIXIS_LEARNING=ON and lies beside deixis; deixis starts it in its own
// place, with the same arguments. It is the same program with trainers (app/trainers).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "learning/gesture_scores/gesture_takes.hpp"
#include "learning/gesture_scores/gesture_training.hpp"
#include "learning/training/training.hpp"

namespace deixis::app {

struct TrainingRequest {
    std::string system;  ///< moglow, amp-no-runtime, amp-base or amp-pfnn
    std::filesystem::path file;
    std::uint64_t seed = 1;
    int threads = 1;
    std::optional<int> updates{};  ///< iterations of a policy; what is not named stays as the trainer has it
    std::optional<int> validate_every{};
    std::optional<int> clusters{};  ///< these as clustersOf() takes them
    std::string bandwidth{};        ///< metres, or "scott"; empty: none named
    std::optional<int> only_cluster{};
    std::string reward = "forearm";  ///< or "eye-fingertip", "observer": the task that AMP rewards
    bool full_body = false;
    std::vector<std::string> settings{};  ///< NAME=VALUE of AmpSettings
    std::optional<learning::RankPlace> rank{};
    learning::Provenance provenance{};  ///< this program
};

struct GestureTrainingRequest {
    std::filesystem::path file;
    std::uint64_t seed = 1;
    int threads = 1;
    bool controls = true;         ///< false: the paper's baseline
    std::optional<int> epochs{};  ///< these as the trainer has them where they are not named
    std::optional<int> hidden{};  ///< size of each GRU
    learning::Provenance provenance{};
};

struct Trainers {
    /// `remark` is told what is to be known of the training before it begins.
    using Remark = std::function<void(const std::string&)>;

    Result<learning::TrainingOutcome> (*train)(const TrainingRequest& request,
                                               const learning::DemonstrationSets& data, const Remark& remark,
                                               const learning::TrainingReport& report);
    Result<learning::GestureOutcome> (*train_gestures)(const GestureTrainingRequest& request,
                                                       const learning::GestureTakes& takes,
                                                       const learning::GestureCallbacks& callbacks);
    Result<void> (*join)(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& file);
};

/// `deixis learn` trains with these, and starts deixis-train where there are none.
void useTrainers(const Trainers& trainers);

}  // namespace deixis::app
