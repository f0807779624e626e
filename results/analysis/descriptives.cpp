#include "results/analysis/analysis_steps.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

/// The answers on one measure, by system in the order of the table's.
struct MeasureRows {
    RowPointers all;
    std::vector<RowPointers> by_system;
};

/// For each of AnalysisResult::measures.
std::vector<MeasureRows> rowsOfMeasures(const AnalysisResult& result) {
    std::vector<MeasureRows> out(result.measures.size());
    std::map<std::string, std::size_t> measures;
    for (std::size_t m = 0; m < out.size(); ++m) measures[result.measures[m].name] = m + 1;
    std::map<std::string, std::size_t> systems;
    for (std::size_t s = 0; s < result.table.systems.size(); ++s) systems[result.table.systems[s]] = s;
    for (MeasureRows& rows : out) rows.by_system.resize(systems.size());
    for (const ResponseRow& row : result.table.rows) {
        const std::size_t place = measures[row.measure];
        if (place == 0) continue;  // a preference
        out[place - 1].all.push_back(&row);
        out[place - 1].by_system[systems[row.system]].push_back(&row);
    }
    return out;
}

/// A participant's choices under one system, of trials whose number of balls is known.
struct AboveChance {
    int n = 0;
    int right = 0;
    Rational chance{};  ///< sum of 1 / balls
};

/// Participants' means of correct - 1 / balls, each trial's own balls, against 0.
void compareWithChance(const MeasureRows& rows, const Measure& measure, AnalysisResult& result) {
    for (std::size_t s = 0; s < rows.by_system.size(); ++s) {
        ChanceResult& out = result.chance.emplace_back();
        out.system = result.table.systems[s];
        std::map<std::string, AboveChance> participants;
        for (const ResponseRow* row : rows.by_system[s]) {
            ++out.n;
            out.successes += row->value > 0.5 ? 1 : 0;
            if (row->balls < 2) continue;
            ++out.n_known;
            AboveChance& of = participants[row->participant];
            ++of.n;
            of.right += row->value > 0.5 ? 1 : 0;
            of.chance += Rational(1, row->balls);
        }
        std::vector<Rational> chances;
        std::vector<Rational> above;
        for (const auto& [participant, of] : participants) {
            chances.push_back(of.chance / Rational(of.n));
            above.push_back(Rational(of.right, of.n) - chances.back());
        }
        out.chance = meanOf(chances);
        out.mean_above = meanOf(above);
        out.test = signedRankTest(above, result.level);
        out.normality = shapiroWilk(above);
    }
    adjustFrom(result.chance, 0, measure.name + ": chance", result.alpha);
}

/// Means of participants' means; none without answers.
std::optional<double> meanOverParticipants(const RowPointers& rows) {
    std::map<std::string, Scores> scores;
    for (const ResponseRow* row : rows) scores[row->participant].push_back(row->value);
    std::vector<double> means;
    for (const auto& [participant, of] : scores) means.push_back(mean(of));
    return means.empty() ? std::nullopt : std::optional<double>(mean(means));
}

void countUnanswered(const MeasureRows& rows, AnalysisResult& result) {
    std::vector<UnansweredResult> out;
    bool any = false;
    for (std::size_t s = 0; s < rows.by_system.size(); ++s) {
        UnansweredResult& one = out.emplace_back();
        one.system = result.table.systems[s];
        RowPointers made;
        RowPointers all = rows.by_system[s];
        for (const ResponseRow* row : all)
            if (row->unanswered.empty()) made.push_back(row);
        for (const ResponseRow& row : result.table.skipped_rows)
            if (row.system == one.system) all.push_back(&row);
        one.answered = static_cast<int>(made.size());
        one.timed_out = static_cast<int>(rows.by_system[s].size() - made.size());
        one.skipped = static_cast<int>(all.size() - rows.by_system[s].size());
        one.headline = meanOverParticipants(rows.by_system[s]);
        one.answered_only = meanOverParticipants(made);
        one.unanswered_wrong = meanOverParticipants(all);
        any = any || one.timed_out > 0 || one.skipped > 0;
    }
    if (any) result.unanswered = std::move(out);
}

void describeTimes(const MeasureRows& rows, const Measure& measure, AnalysisResult& result) {
    for (std::size_t s = 0; s < rows.by_system.size(); ++s) {
        std::vector<double> times;
        for (const ResponseRow* row : rows.by_system[s])
            if (row->response_time_s > 0.0) times.push_back(row->response_time_s);
        if (times.empty()) continue;
        std::sort(times.begin(), times.end());
        result.times.push_back({measure.name, result.table.systems[s], static_cast<int>(times.size()),
                                quantileOfSorted(times, 0.25), quantileOfSorted(times, 0.5),
                                quantileOfSorted(times, 0.75)});
    }
}

void addHalves(RowPointers& answers, Cells& halves) {
    if (answers.size() < 2) return;
    std::stable_sort(answers.begin(), answers.end(),
                     [](const ResponseRow* a, const ResponseRow* b) { return a->trial < b->trial; });
    const std::string& participant = answers.front()->participant;
    Scores& first = halves["first"][participant];
    Scores& second = halves["second"][participant];
    const std::size_t middle = (answers.size() + 1) / 2;
    for (std::size_t i = 0; i < answers.size(); ++i)
        (i < middle ? first : second).push_back(answers[i]->value);
}

void compareHalves(const MeasureRows& rows, const Measure& measure, AnalysisResult& result) {
    Cells halves;
    RowPointers of_participant;
    for (const ResponseRow* row : rows.all) {
        if (row->trial < 0) continue;
        if (!of_participant.empty() && of_participant.front()->participant != row->participant) {
            addHalves(of_participant, halves);
            of_participant.clear();
        }
        of_participant.push_back(row);
    }
    addHalves(of_participant, halves);
    if (halves.empty()) return;
    Comparison difference;
    difference.a = "second";
    difference.b = "first";
    testDifferences(difference, exactMeans(halves), result.level);
    OrderResult& out = result.order.emplace_back();
    static_cast<AdjustedTest&>(out) = difference;
    out.measure = measure.name;
    const auto meanOfMeans = [&](const char* half) {
        std::vector<double> means;
        for (const auto& [participant, scores] : halves[half]) means.push_back(mean(scores));
        return mean(means);
    };
    out.first = meanOfMeans("first");
    out.second = meanOfMeans("second");
}

void describeItems(const MeasureRows& rows, const Measure& measure, AnalysisResult& result) {
    std::unordered_map<std::string, Scores> by_item;
    for (const ResponseRow* row : rows.all)
        if (!row->target_id.empty()) by_item[row->target_id].push_back(row->value);
    const auto first = static_cast<std::ptrdiff_t>(result.items.size());
    for (const auto& [item, scores] : by_item)
        result.items.push_back({measure.name, item, mean(scores), static_cast<int>(scores.size())});
    std::sort(result.items.begin() + first, result.items.end(), [](const ItemResult& a, const ItemResult& b) {
        return std::tie(a.mean, a.item) < std::tie(b.mean, b.item);
    });
}

void poolRatings(const MeasureRows& rows, const Measure& measure, AnalysisResult& result) {
    for (std::size_t s = 0; s < rows.by_system.size(); ++s) {
        if (rows.by_system[s].empty()) continue;
        std::vector<double> one;
        for (const ResponseRow* row : rows.by_system[s]) one.push_back(row->value);
        const double centre = mean(one);
        const double sd = sampleSd(one);
        std::sort(one.begin(), one.end());
        result.pooled.push_back({measure.name, result.table.systems[s], static_cast<int>(one.size()), centre,
                                 sd, quantileOfSorted(one, 0.05), quantileOfSorted(one, 0.25),
                                 quantileOfSorted(one, 0.5), quantileOfSorted(one, 0.75),
                                 quantileOfSorted(one, 0.95)});
    }
}

void countPresence(const std::vector<MeasureRows>& rows, AnalysisResult& result) {
    const std::size_t systems = result.table.systems.size();
    std::map<std::string, std::vector<std::vector<int>>> counts;
    for (std::size_t m = 0; m < rows.size(); ++m)
        for (std::size_t s = 0; s < systems; ++s)
            for (const ResponseRow* row : rows[m].by_system[s]) {
                std::vector<std::vector<int>>& of_participant = counts[row->participant];
                of_participant.resize(rows.size(), std::vector<int>(systems, 0));
                ++of_participant[m][s];
            }
    for (auto& [participant, answers] : counts) result.presence.push_back({participant, std::move(answers)});
}

}  // namespace

bool hasManySteps(const Measure& measure) {
    return measure.kind == MeasureKind::rating && measure.high - measure.low + 1.0 > 10.0;
}

bool hasRatingsOnly(const AnalysisResult& result) {
    return std::all_of(result.measures.begin(), result.measures.end(),
                       [](const Measure& measure) { return measure.unit.empty(); });
}

void describeAnswers(AnalysisResult& result) {
    const std::vector<MeasureRows> rows = rowsOfMeasures(result);
    for (std::size_t m = 0; m < rows.size(); ++m) {
        const Measure& measure = result.measures[m];
        if (rows[m].all.empty()) continue;
        if (measure.kind == MeasureKind::accuracy) {
            compareWithChance(rows[m], measure, result);
            countUnanswered(rows[m], result);
        }
        describeTimes(rows[m], measure, result);
        compareHalves(rows[m], measure, result);
        describeItems(rows[m], measure, result);
        if (measure.kind == MeasureKind::rating) poolRatings(rows[m], measure, result);
    }
    std::vector<AdjustedTest*> family;
    for (OrderResult& one : result.order) family.push_back(&one);
    adjustFamily(family, "order: halves in each measure", result.alpha);
    countPresence(rows, result);
}

}  // namespace deixis::results
