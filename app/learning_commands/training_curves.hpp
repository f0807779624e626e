// How a training went: its numbers as a table, and as a page of curves.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "learning/training/training.hpp"

namespace deixis::app {

/// Numbers by part and update. Beside FILE they are FILE.curves.csv (part, update, measure, value) and
/// FILE.curves.html.
class TrainingCurves {
  public:
    TrainingCurves(std::filesystem::path weights_file, std::string system);

    /// Those of an earlier run, which this one goes on with. Fails on a table that is none.
    [[nodiscard]] Result<void> read();
    void add(const learning::TrainingProgress& progress);
    [[nodiscard]] Result<void> write() const;

  private:
    [[nodiscard]] std::string page() const;

    std::filesystem::path weights_file_;
    std::string system_;
    /// measure -> part -> update -> value
    std::map<std::string, std::map<std::string, std::map<int, double>>> values_;
};

}  // namespace deixis::app
