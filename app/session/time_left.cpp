#include "app/session/time_left.hpp"

#include <algorithm>
#include <cstddef>

#include "core/order_statistics.hpp"

namespace deixis::app {

namespace {

// None where there are fewer than `enough`.
std::optional<double> medianOf(const std::vector<double>& values, int enough) {
    if (values.empty() || values.size() < static_cast<std::size_t>(enough)) return std::nullopt;
    return median(values);
}

// A page is done where nothing of it is counted.
int unitsOf(const studies::StageProgress& stage) {
    return std::max(stage.of, 1);
}

}  // namespace

int SessionPace::units() const {
    std::size_t count = 0;
    for (const auto& [stage, units] : units_s_) count += units.size();
    return static_cast<int>(count);
}

void SessionPace::see(const std::vector<studies::StageProgress>& stages, double time_s, bool paused) {
    const bool first = !last_s_;
    if (!first && !paused) under_way_s_ += std::max(0.0, time_s - *last_s_);
    last_s_ = time_s;
    for (const studies::StageProgress& stage : stages) {
        const auto [known, is_new] = done_.try_emplace(stage.name, stage.done);
        const int more = is_new ? 0 : stage.done - known->second;
        known->second = stage.done;
        if (more == 0) continue;
        // What is done again was no shorter for it: only the clock starts again.
        if (more > 0) {
            std::vector<double>& kept = stage.of > 0 ? units_s_[stage.name] : pages_s_;
            kept.insert(kept.end(), static_cast<std::size_t>(more), under_way_s_ / more);
        }
        under_way_s_ = 0.0;
    }
}

std::optional<double> timeLeft_s(const std::vector<studies::StageProgress>& stages,
                                 const std::map<std::string, double>& history, const SessionPace& own) {
    std::vector<double> all_own;
    for (const auto& [stage, units] : own.units_s())
        all_own.insert(all_own.end(), units.begin(), units.end());
    std::vector<double> all_history;
    for (const auto& [stage, seconds] : history) all_history.push_back(seconds);
    std::optional<double> otherwise = medianOf(all_own, enough_units);
    if (!otherwise) otherwise = medianOf(all_history, 1);
    if (!otherwise) return std::nullopt;

    const auto unit_s = [&](const studies::StageProgress& stage) {
        if (stage.of == 0) return medianOf(own.pages_s(), 1).value_or(0.0);
        if (const auto known = history.find(stage.name); known != history.end()) return known->second;
        const auto here = own.units_s().find(stage.name);
        if (here == own.units_s().end()) return *otherwise;
        return medianOf(here->second, enough_units).value_or(*otherwise);
    };
    double left_s = 0.0;
    for (const studies::StageProgress& stage : stages) {
        const int left = std::max(0, unitsOf(stage) - stage.done);
        if (left == 0) continue;
        const double each_s = unit_s(stage);
        left_s += left * each_s;
        if (stage.current) left_s -= std::min(each_s, own.underWay_s());
    }
    return left_s;
}

}  // namespace deixis::app
