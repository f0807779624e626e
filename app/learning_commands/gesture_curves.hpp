// How a training of speech gestures went, epoch by epoch: as a table, and as a page of curves.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/error.hpp"
#include "learning/gesture_scores/gesture_training.hpp"

namespace deixis::app {

/// Beside FILE they are FILE.curves.csv and FILE.curves.html: PCS, SCS and FGD over epochs on logarithmic
/// axes as in figure 8 of Yoon et al. (2021), with what the mean pose has, and the terms of the loss.
class GestureCurves {
  public:
    explicit GestureCurves(std::filesystem::path weights_file) : weights_file_(std::move(weights_file)) {}

    /// Those of an earlier run, which this one goes on with. Fails on a table that is none.
    [[nodiscard]] Result<void> read();
    void add(const learning::GestureEpoch& epoch) { epochs_[epoch.epoch] = epoch; }
    [[nodiscard]] Result<void> write() const;

  private:
    [[nodiscard]] std::string page() const;

    std::filesystem::path weights_file_;
    std::map<int, learning::GestureEpoch> epochs_;
};

}  // namespace deixis::app
