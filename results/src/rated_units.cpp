#include "rated_units.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "results/descriptive.hpp"

namespace deixis::results {

namespace {

bool isRated(const Measure& measure) {
    return measure.kind == MeasureKind::rating && measure.name != "confidence";
}

/// None of fewer than three pairs, and where one side does not vary.
std::optional<double> correlation(const std::vector<double>& x, const std::vector<double>& y) {
    if (x.size() < 3) return std::nullopt;
    const double mean_x = mean(x), mean_y = mean(y);
    double xx = 0.0, yy = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        yy += (y[i] - mean_y) * (y[i] - mean_y);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (xx <= 0.0 || yy <= 0.0) return std::nullopt;
    return xy / std::sqrt(xx * yy);
}

}  // namespace

RatedUnits::RatedUnits(const ResponseTable& table) {
    std::unordered_set<Name> rated;
    for (const Measure& measure : table.measures)
        if (isRated(measure)) rated.insert(measure.name);
    for (const ResponseRow& row : table.rows) {
        if (row.target_id.empty() || !rated.contains(row.measure)) continue;
        const auto [found, added] = index_.try_emplace(keyOf(row), units_.size());
        if (added) units_.push_back({row.measure});
        Unit& unit = units_[found->second];
        unit.ratings.push_back(row.value);
        unit.raters.push_back(row.participant);
        unit.sum += row.value;
    }
}

std::optional<double> RatedUnits::agreement(const std::vector<const ResponseRow*>& rows) const {
    struct Own {
        double sum = 0.0;
        double n = 0.0;
    };
    std::unordered_map<std::size_t, Own> own;
    std::vector<std::pair<std::size_t, double>> given;
    for (const ResponseRow* row : rows) {
        const auto found = index_.find(keyOf(*row));
        if (found == index_.end()) continue;
        given.emplace_back(found->second, row->value);
        if (!row->excluded.empty()) continue;  // of whom does not count the unit knows nothing
        own[found->second].sum += row->value;
        own[found->second].n += 1.0;
    }
    std::vector<double> ratings, means;
    for (const auto& [index, rating] : given) {
        const Unit& unit = units_[index];
        const Own mine = own[index];
        const double others = static_cast<double>(unit.ratings.size()) - mine.n;
        if (others <= 0.0) continue;
        ratings.push_back(rating);
        means.push_back((unit.sum - mine.sum) / others);
    }
    return correlation(ratings, means);
}

std::vector<Reliability> RatedUnits::reliability(const ResponseTable& table) const {
    std::vector<Reliability> out;
    for (const Measure& measure : table.measures) {
        if (!isRated(measure)) continue;
        Reliability& one = out.emplace_back();
        one.measure = measure.name;
        std::vector<std::vector<double>> shared;
        std::unordered_set<Name> raters;
        for (const Unit& unit : units_) {
            const bool several = std::any_of(unit.raters.begin(), unit.raters.end(),
                                             [&](const Name& rater) { return rater != unit.raters.front(); });
            if (!several || unit.measure != measure.name) continue;
            shared.push_back(unit.ratings);
            raters.insert(unit.raters.begin(), unit.raters.end());
            one.ratings += static_cast<int>(unit.ratings.size());
        }
        one.raters = static_cast<int>(raters.size());
        one.units = static_cast<int>(shared.size());
        one.alpha = krippendorffAlpha(shared);
        if (const auto icc = intraclassCorrelation(shared)) {
            one.icc_single = icc->single;
            one.icc_mean = icc->mean;
            one.k = icc->k;
        }
    }
    return out;
}

}  // namespace deixis::results
