// Single ratings, beside participants' means: pairs of systems, and clips by their authors' trials.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "results/analysis/analysis_steps.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

constexpr double no_interval = 0.0;  // of ratings that are not independent it would be too narrow

std::optional<double> medianOf(const std::vector<double>& values) {
    return values.empty() ? std::nullopt : std::optional<double>(quantile(values, 0.5));
}

RowPointers rowsOf(const AnalysisResult& result, const Measure& measure) {
    RowPointers out;
    for (const ResponseRow& row : result.table.rows)
        if (row.measure == measure.name) out.push_back(&row);
    return out;
}

std::vector<double> valuesOf(const RowPointers& rows, const std::string& system) {
    std::vector<double> out;
    for (const ResponseRow* row : rows)
        if (row->system == system) out.push_back(row->value);
    return out;
}

constexpr char after_participant = '\x1f';

/// What two ratings have in common to be a pair; begins with the participant. Ratings of several systems in
/// one trial were given on one page; others belong together by their item, layout and distance. Empty: the
/// item is not known either.
class PairKeys {
  public:
    explicit PairKeys(const RowPointers& rows) {
        std::map<Trial, std::string> first;
        for (const ResponseRow* row : rows)
            if (row->trial >= 0 && first.try_emplace(trialOf(*row), row->system).first->second != row->system)
                pages_.insert(trialOf(*row));
    }
    [[nodiscard]] std::string of(const ResponseRow& row) const {
        const std::string start = row.participant + after_participant;
        if (pages_.contains(trialOf(row)))
            return fmt::format("{}page {}\x1f{}", start, row.trial, row.target_id);
        if (row.target_id.empty()) return "";
        return fmt::format("{}item {}\x1f{}\x1f{}", start, row.target_id, row.layout, row.distance);
    }

  private:
    // With the item: where a file counts trials again for each system, those with one number are no page.
    using Trial = std::tuple<std::string, int, std::string>;
    static Trial trialOf(const ResponseRow& row) { return {row.participant, row.trial, row.target_id}; }

    std::set<Trial> pages_{};
};

/// System -> pair -> rating; where a system has several in one pair, their mean.
Means meansByPair(const RowPointers& rows) {
    const PairKeys keys(rows);
    Cells cells;
    for (const ResponseRow* row : rows)
        if (const std::string key = keys.of(*row); !key.empty())
            cells[row->system][key].push_back(row->value);
    return exactMeans(cells);
}

void countPairs(const Means& means, RatingComparison& out) {
    const std::map<std::string, Rational> none;
    const auto of = [&](const std::string& system) -> const std::map<std::string, Rational>& {
        const auto found = means.find(system);
        return found == means.end() ? none : found->second;
    };
    const auto& a = of(out.a);
    const auto& b = of(out.b);
    std::set<std::string> participants;
    for (const auto& [key, rating] : a)
        if (b.contains(key)) participants.insert(key.substr(0, key.find(after_participant)));
    out.participants = static_cast<int>(participants.size());
    out.n_missing = static_cast<int>(a.size() + b.size()) - 2 * out.test.n_pairs;
}

}  // namespace

void compareRatings(AnalysisResult& result) {
    if (!result.by_ratings) return;
    for (Measure measure : result.measures) {
        if (measure.kind != MeasureKind::rating) continue;
        measure.equivalence_bound = 0.0;  // p of such a test would be too small as well
        const RowPointers rows = rowsOf(result, measure);
        const MeansByMeasure means{{measure.name, meansByPair(rows)}};
        bool paired = false;
        for (Comparison& pair :
             pairTests(means, {measure}, result.table.systems, no_interval, result.alpha)) {
            RatingComparison& out = result.rating_pairs.emplace_back();
            static_cast<Comparison&>(out) = std::move(pair);
            out.family += ", by ratings";
            out.median_a = medianOf(valuesOf(rows, out.a));
            out.median_b = medianOf(valuesOf(rows, out.b));
            countPairs(means.at(measure.name), out);
            paired = paired || out.test.n_pairs > 0;
        }
        if (!paired && result.table.systems.size() > 1)
            result.remarks.push_back(
                fmt::format("No single ratings of {} can be paired: no participant rated two systems on one "
                            "page or for one item.",
                            measure.name));
    }
}

namespace {

/// A system's ratings by the authors' trials.
struct RatingsByTrial {
    std::map<int, std::vector<double>> values{};
    Cells by_participant{};
};

void compareTrials(const Measure& measure, const std::string& system, RatingsByTrial& ratings,
                   AnalysisResult& result) {
    Factor trials{"author_trial"};
    std::map<std::string, std::vector<Rational>> exactly;
    std::map<std::string, double> medians;
    for (const auto& [trial, values] : ratings.values) {
        trials.levels.push_back(fmt::format("{}", trial));
        for (const double value : values) exactly[trials.levels.back()].push_back(exactMeanOf({value}));
        medians[trials.levels.back()] = quantile(values, 0.5);
    }
    const Means means = exactMeans(ratings.by_participant);
    for (std::size_t i = 0; i < trials.levels.size(); ++i)
        for (std::size_t j = i + 1; j < trials.levels.size(); ++j) {
            AuthorTrialResult& out = result.author_trials.emplace_back();
            out.measure = measure.name;
            out.system = system;
            compareLevelsOf(out, trials, i, j, exactly, no_interval);
            out.median_a = medians[out.a];
            out.median_b = medians[out.b];

            MedianComparison& paired = result.author_trials_paired.emplace_back();
            paired.measure = measure.name;
            paired.factor = trials.name;
            paired.system = system;
            paired.a = out.a;
            paired.b = out.b;
            testDifferences(paired, means, result.level);
            std::vector<double> of_a, of_b;
            for (const auto& [participant, mean] : means.at(out.a))
                if (const auto other = means.at(out.b).find(participant); other != means.at(out.b).end()) {
                    of_a.push_back(mean.toDouble());
                    of_b.push_back(other->second.toDouble());
                }
            paired.median_a = medianOf(of_a);
            paired.median_b = medianOf(of_b);
        }
}

}  // namespace

void compareAuthorTrials(AnalysisResult& result) {
    for (const Measure& measure : result.measures) {
        if (measure.kind != MeasureKind::rating) continue;
        const std::size_t first = result.author_trials.size();
        std::map<std::string, RatingsByTrial> systems;
        for (const ResponseRow& row : result.table.rows) {
            if (row.measure != measure.name || row.author_trial <= 0) continue;
            RatingsByTrial& of = systems[row.system];
            of.values[row.author_trial].push_back(row.value);
            of.by_participant[fmt::format("{}", row.author_trial)][row.participant].push_back(row.value);
        }
        for (const std::string& system : result.table.systems)
            if (const auto found = systems.find(system); found != systems.end())
                compareTrials(measure, system, found->second, result);
        const std::string family = measure.name + ": clips by their authors' trials";
        adjustGroups(result.author_trials, first, family + ", by ratings", result.alpha);
        adjustFrom(result.author_trials_paired, first, family, result.alpha);
    }
}

}  // namespace deixis::results
