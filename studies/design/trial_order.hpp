// Orders of a stage's trials: shuffled, in blocks, under limits on runs.
#pragma once

#include <optional>
#include <vector>

#include "core/random.hpp"

namespace deixis::studies {

/// What is to be ordered.
struct OrderTask {
    struct Unit {
        int block = 0;
        std::vector<int> labels{};  ///< what must not come too often running: its systems, its item
    };
    std::vector<Unit> units;
    /// By label: of how many units one after another that bear it a run may consist.
    std::vector<int> max_run;
};

/// An order of the units (indices), the blocks one after another from 0 up, shuffled within and such that no
/// run is too long; none where none was found. The search goes through all orders, in an order that chance
/// gives, and gives up after a bounded number of steps: the same ones on every machine. Where runs are not
/// limited all orders are equally likely.
[[nodiscard]] std::optional<std::vector<int>> shuffledOrder(const OrderTask& task, Random& random);

/// Whether a unit with `labels` put before place `place` of `order` makes no run too long.
[[nodiscard]] bool fitsBefore(const OrderTask& task, const std::vector<int>& order, std::size_t place,
                              const std::vector<int>& labels);

}  // namespace deixis::studies
