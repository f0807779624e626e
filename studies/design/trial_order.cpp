#include "trial_order.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

namespace deixis::studies {

namespace {

bool bears(const OrderTask::Unit& unit, int label) {
    return std::find(unit.labels.begin(), unit.labels.end(), label) != unit.labels.end();
}

/// Depth first, a place after the other: at each the units that are left in random order. A branch is left as
/// soon as what remains of a block bears a label too often to be kept apart by the rest.
class Search {
  public:
    explicit Search(const OrderTask& task) : task_(task), labels_(task.max_run.size()) {
        for (const OrderTask::Unit& unit : task.units)
            blocks_ = std::max<std::size_t>(blocks_, unit.block + 1);
        members_.resize(blocks_);
        left_.assign(blocks_ * labels_, 0);
        for (std::size_t i = 0; i < task.units.size(); ++i) {
            members_[block(i)].push_back(static_cast<int>(i));
            count(static_cast<int>(i), 1);
        }
        std::size_t end = 0;
        for (std::size_t b = 0; b < blocks_; ++b) {
            end += members_[b].size();
            ends_.resize(end, end);
        }
        std::size_t largest = 0;
        for (const std::vector<int>& members : members_) largest = std::max(largest, members.size());
        candidates_.resize(task.units.size() * largest);
        row_ = largest;
        open_.resize(task.units.size());
        tried_.resize(task.units.size());
        used_.resize(task.units.size());
        order_.reserve(task.units.size());
    }

    enum class Outcome { found, none, gave_up };

    Outcome run(Random& random, long max_steps) {
        const std::size_t n = task_.units.size();
        while (!order_.empty()) takeBack();
        if (n == 0) return Outcome::found;
        open(0);
        for (long step = 0; step < max_steps; ++step) {
            const std::size_t place = order_.size();
            int* const candidates = candidatesAt(place);
            std::size_t& tried = tried_[place];
            if (tried == open_[place]) {
                if (place == 0) return Outcome::none;
                takeBack();
                continue;
            }
            std::swap(candidates[tried], candidates[tried + random.below(open_[place] - tried)]);
            const int unit = candidates[tried++];
            if (!allowed(unit)) continue;
            put(unit);
            if (!canStillFit()) {
                takeBack();
                continue;
            }
            if (order_.size() == n) return Outcome::found;
            open(order_.size());
        }
        return Outcome::gave_up;
    }

    [[nodiscard]] const std::vector<int>& order() const { return order_; }

  private:
    [[nodiscard]] const OrderTask::Unit& unit(int i) const { return task_.units[i]; }
    [[nodiscard]] std::size_t block(std::size_t i) const { return task_.units[i].block; }

    void count(int i, int by) {
        for (const int label : unit(i).labels) left_[block(i) * labels_ + label] += by;
    }

    int* candidatesAt(std::size_t place) { return candidates_.data() + place * row_; }

    void open(std::size_t place) {
        std::size_t b = 0;
        for (std::size_t end = members_[0].size(); place >= end; end += members_[b].size()) ++b;
        int* end = candidatesAt(place);
        for (const int i : members_[b])
            if (!used_[i]) *end++ = i;
        open_[place] = static_cast<std::size_t>(end - candidatesAt(place));
        tried_[place] = 0;
    }

    void put(int i) {
        order_.push_back(i);
        used_[i] = true;
        count(i, -1);
    }
    void takeBack() {
        const int i = order_.back();
        order_.pop_back();
        used_[i] = false;
        count(i, 1);
    }

    /// Length of the run of a label at the end of the order so far.
    [[nodiscard]] int runOf(int label) const {
        int run = 0;
        for (auto i = order_.rbegin(); i != order_.rend() && bears(unit(*i), label); ++i) ++run;
        return run;
    }

    [[nodiscard]] bool allowed(int i) const {
        const std::vector<int>& labels = unit(i).labels;
        return std::all_of(labels.begin(), labels.end(),
                           [&](int label) { return runOf(label) < task_.max_run[label]; });
    }

    /// Whether, for each label by itself, the rest of the block can still be ordered.
    [[nodiscard]] bool canStillFit() const {
        const std::size_t place = order_.size() - 1;
        const std::size_t b = block(order_.back());
        const int rest = static_cast<int>(ends_[place] - order_.size());
        for (std::size_t label = 0; label < labels_; ++label) {
            const int bearing = left_[b * labels_ + label];
            const int others = rest - bearing;
            const int limit = task_.max_run[label];
            if (bearing > limit * others &&  // else there is room even straight after a full run
                bearing > limit * others + limit - runOf(static_cast<int>(label)))
                return false;
        }
        return true;
    }

    const OrderTask& task_;
    std::size_t labels_;
    std::size_t blocks_ = 0;
    std::vector<std::vector<int>> members_;  ///< units by block
    std::vector<std::size_t> ends_;          ///< by place: where its block ends
    std::vector<int> left_;                  ///< by block and label: units not placed yet
    std::vector<int> order_;
    std::vector<int>
        candidates_;  ///< by place, a row each: one array, for a plan is made of many small parts
    std::size_t row_ = 0;
    std::vector<std::size_t> open_;   ///< by place: how many candidates
    std::vector<std::size_t> tried_;  ///< by place: how many of the first have had their turn
    std::vector<char> used_;
};

std::vector<int> shuffledBlocks(const OrderTask& task, Random& random) {
    std::vector<int> order(task.units.size());
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(std::span<int>(order));
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return task.units[a].block < task.units[b].block; });
    return order;
}

}  // namespace

std::optional<std::vector<int>> shuffledOrder(const OrderTask& task, Random& random) {
    const bool free = std::all_of(task.units.begin(), task.units.end(),
                                  [](const OrderTask::Unit& unit) { return unit.labels.empty(); });
    if (free) return shuffledBlocks(task, random);

    // An unlucky beginning can cost long: better to begin again than to go through all its ends.
    constexpr int attempts = 200;
    constexpr long steps_per_unit = 100;
    Search search(task);
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const Search::Outcome outcome =
            search.run(random, steps_per_unit * static_cast<long>(task.units.size()));
        if (outcome == Search::Outcome::found) return search.order();
        if (outcome == Search::Outcome::none) break;
    }
    return std::nullopt;
}

bool fitsBefore(const OrderTask& task, const std::vector<int>& order, std::size_t place,
                const std::vector<int>& labels) {
    return std::all_of(labels.begin(), labels.end(), [&](int label) {
        const auto here = [&](std::size_t at) { return bears(task.units[order[at]], label); };
        int run = 1;
        for (std::size_t at = place; at > 0 && here(at - 1); --at) ++run;
        for (std::size_t at = place; at < order.size() && here(at); ++at) ++run;
        return run <= task.max_run[label];
    });
}

}  // namespace deixis::studies
