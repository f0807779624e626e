#include "rated_units.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

/// Confidence may be asked on several scales, each then a measure of its own.
bool isRated(const Measure& measure) {
    return measure.kind == MeasureKind::rating && measure.unit.empty() && measure.name != "confidence" &&
           !measure.name.starts_with("confidence (");
}

/// Pearson's correlation, of one measure or several: each about its own means, in parts of its scale.
class Correlation {
  public:
    void add(const std::vector<double>& x, const std::vector<double>& y, double range) {
        if (range <= 0.0) return;
        const double mean_x = mean(x), mean_y = mean(y);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double off_x = (x[i] - mean_x) / range, off_y = (y[i] - mean_y) / range;
            xx_ += off_x * off_x;
            yy_ += off_y * off_y;
            xy_ += off_x * off_y;
        }
        n_ += x.size();
    }
    /// None of fewer than three pairs, and where one side does not vary.
    [[nodiscard]] std::optional<double> value() const {
        if (n_ < 3 || xx_ <= 0.0 || yy_ <= 0.0) return std::nullopt;
        return xy_ / std::sqrt(xx_ * yy_);
    }

  private:
    std::size_t n_ = 0;
    double xx_ = 0.0, yy_ = 0.0, xy_ = 0.0;
};

}  // namespace

RatedUnits::RatedUnits(const ResponseTable& table) {
    for (const Measure& measure : table.measures)
        if (isRated(measure)) range_[measure.name] = measure.high - measure.low;
    for (const ResponseRow& row : table.rows) {
        if (row.target_id.empty() || !range_.contains(row.measure)) continue;
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
    struct Pairs {
        std::vector<double> ratings{}, means{};
    };
    std::map<std::string, Pairs> by_measure;
    for (const auto& [index, rating] : given) {
        const Unit& unit = units_[index];
        const Own mine = own[index];
        const double others = static_cast<double>(unit.ratings.size()) - mine.n;
        if (others <= 0.0) continue;
        Pairs& pairs = by_measure[unit.measure];
        pairs.ratings.push_back(rating);
        pairs.means.push_back((unit.sum - mine.sum) / others);
    }
    Correlation correlation;
    for (const auto& [measure, pairs] : by_measure)
        correlation.add(pairs.ratings, pairs.means, range_.at(measure));
    return correlation.value();
}

std::vector<Reliability> RatedUnits::reliability(const ResponseTable& table) const {
    std::vector<Reliability> out;
    for (const Measure& measure : table.measures) {
        if (!isRated(measure)) continue;
        Reliability& one = out.emplace_back();
        one.measure = measure.name;
        std::vector<std::vector<double>> shared;
        std::set<std::string> raters;
        for (const Unit& unit : units_) {
            const bool several =
                std::any_of(unit.raters.begin(), unit.raters.end(),
                            [&](const std::string& rater) { return rater != unit.raters.front(); });
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
