#include "analysis_details.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "analysis_tests.hpp"
#include "by_name.hpp"
#include "results/descriptive.hpp"

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
    ByName<std::size_t> measures;
    for (std::size_t m = 0; m < out.size(); ++m) measures[result.measures[m].name] = m + 1;
    ByName<std::size_t> systems;
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

void compareWithChance(const MeasureRows& rows, const Measure& measure, AnalysisResult& result) {
    const auto chance = measure.balls > 1 ? std::optional<double>(1.0 / measure.balls) : std::nullopt;
    for (std::size_t s = 0; s < rows.by_system.size(); ++s) {
        const RowPointers& of_system = rows.by_system[s];
        const auto right = std::count_if(of_system.begin(), of_system.end(),
                                         [](const ResponseRow* row) { return row->value > 0.5; });
        result.chance.push_back(
            {result.table.systems[s],
             proportion(right, static_cast<std::int64_t>(of_system.size()), result.options.level, chance)});
    }
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
    testDifferences(difference, exactMeans(halves), result.options.level);
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
    std::unordered_map<Name, Scores> by_item;
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
    std::map<Name, std::vector<std::vector<int>>> counts;
    for (std::size_t m = 0; m < rows.size(); ++m)
        for (std::size_t s = 0; s < systems; ++s) {
            std::vector<std::vector<int>>* of_participant = nullptr;
            Name participant;
            for (const ResponseRow* row : rows[m].by_system[s]) {
                if (of_participant == nullptr || participant != row->participant) {
                    participant = row->participant;
                    of_participant = &counts[participant];
                    if (of_participant->empty())
                        of_participant->assign(rows.size(), std::vector<int>(systems, 0));
                }
                ++(*of_participant)[m][s];
            }
        }
    for (auto& [participant, answers] : counts) result.presence.push_back({participant, std::move(answers)});
}

}  // namespace

bool hasManySteps(const Measure& measure) {
    return measure.kind == MeasureKind::rating && measure.high - measure.low + 1.0 > 10.0;
}

void describeAnswers(AnalysisResult& result) {
    const std::vector<MeasureRows> rows = rowsOfMeasures(result);
    for (std::size_t m = 0; m < rows.size(); ++m) {
        const Measure& measure = result.measures[m];
        if (rows[m].all.empty()) continue;
        if (measure.kind == MeasureKind::accuracy) compareWithChance(rows[m], measure, result);
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
