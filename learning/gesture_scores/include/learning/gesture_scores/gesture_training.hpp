// How a training of speech gestures goes: what it tells while it runs, and how it ended.
#pragma once

#include <functional>

#include "learning/gesture_scores/scores.hpp"
#include "learning/training/training.hpp"

namespace deixis::learning {

/// Terms of equation 7 before they are weighted; what is not computed is 0.
struct GestureLosses {
    double huber = 0.0;
    double gan = 0.0;
    double style = 0.0;
    double discriminator = 0.0;
};

/// After an epoch in which the model was tried out.
struct GestureEpoch {
    int epoch = 0;  ///< from 1
    int updates = 0;
    GestureLosses losses;     ///< mean since the last time
    GestureScores scores;     ///< on what is held out
    GestureScores mean_pose;  ///< the same of a motion that is always the mean pose
    bool best = false;        ///< the best yet, and was written
};

struct GestureCallbacks {
    TrainingReport report{};  ///< after every tenth update and each try-out
    std::function<void(const GestureEpoch&)> epoch{};
};

struct GestureOutcome {
    bool stopped = false;  ///< before the last epoch, as the report asked
    int updates = 0;       ///< also those of earlier runs
    int best_epoch = 0;    ///< the file's
    GestureScores best{};
    GestureScores mean_pose{};
};

}  // namespace deixis::learning
