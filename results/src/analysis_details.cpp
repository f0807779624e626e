#include "analysis_details.hpp"

#include <algorithm>
#include <map>

#include "analysis_tests.hpp"
#include "results/descriptive.hpp"

namespace deixis::results {

namespace {

void compareWithChance(const RowPointers& rows, const Measure& measure, AnalysisResult& result) {
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> counts;  // right ones, all
    for (const ResponseRow* row : rows) {
        auto& [right, all] = counts[row->system];
        right += row->value > 0.5 ? 1 : 0;
        ++all;
    }
    const auto chance = measure.balls > 1 ? std::optional<double>(1.0 / measure.balls) : std::nullopt;
    for (const std::string& system : result.table.systems) {
        const auto [right, all] = counts[system];
        result.chance.push_back({system, proportion(right, all, result.options.level, chance)});
    }
}

void describeTimes(const RowPointers& rows, const Measure& measure, AnalysisResult& result) {
    std::map<std::string, std::vector<double>> times;
    for (const ResponseRow* row : rows)
        if (row->response_time_s > 0.0) times[row->system].push_back(row->response_time_s);
    for (const std::string& system : result.table.systems)
        if (const auto& of_system = times[system]; !of_system.empty())
            result.times.push_back({measure.name, system, static_cast<int>(of_system.size()),
                                    quantile(of_system, 0.25), quantile(of_system, 0.5),
                                    quantile(of_system, 0.75)});
}

void compareHalves(const RowPointers& rows, const Measure& measure, AnalysisResult& result) {
    std::map<std::string, RowPointers> by_participant;
    for (const ResponseRow* row : rows)
        if (row->trial >= 0) by_participant[row->participant].push_back(row);
    Cells halves;
    for (auto& [participant, answers] : by_participant) {
        if (answers.size() < 2) continue;
        std::stable_sort(answers.begin(), answers.end(),
                         [](const ResponseRow* a, const ResponseRow* b) { return a->trial < b->trial; });
        const std::size_t middle = (answers.size() + 1) / 2;
        for (std::size_t i = 0; i < answers.size(); ++i)
            halves[i < middle ? "first" : "second"][participant].push_back(answers[i]->value);
    }
    if (halves.empty()) return;
    Comparison difference;
    difference.a = "second";
    difference.b = "first";
    testDifferences(difference, halves, result.options.level);
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

void describeItems(const RowPointers& rows, const Measure& measure, AnalysisResult& result) {
    std::map<std::string, Scores> by_item;
    for (const ResponseRow* row : rows)
        if (!row->target_id.empty()) by_item[row->target_id].push_back(row->value);
    const auto first = static_cast<std::ptrdiff_t>(result.items.size());
    for (const auto& [item, scores] : by_item)
        result.items.push_back({measure.name, item, mean(scores), static_cast<int>(scores.size())});
    std::stable_sort(result.items.begin() + first, result.items.end(),
                     [](const ItemResult& a, const ItemResult& b) { return a.mean < b.mean; });
}

void poolRatings(const RowPointers& rows, const Measure& measure, AnalysisResult& result) {
    std::map<std::string, std::vector<double>> by_system;
    for (const ResponseRow* row : rows) by_system[row->system].push_back(row->value);
    for (const std::string& system : result.table.systems)
        if (const auto& one = by_system[system]; !one.empty())
            result.pooled.push_back({measure.name, system, static_cast<int>(one.size()), mean(one),
                                     sampleSd(one), quantile(one, 0.05), quantile(one, 0.25),
                                     quantile(one, 0.5), quantile(one, 0.75), quantile(one, 0.95)});
}

void countPresence(const std::vector<RowPointers>& rows, AnalysisResult& result) {
    const auto& systems = result.table.systems;
    std::map<std::string, std::vector<std::vector<int>>> counts;
    for (std::size_t m = 0; m < rows.size(); ++m)
        for (const ResponseRow* row : rows[m]) {
            auto& of_participant = counts[row->participant];
            if (of_participant.empty())
                of_participant.assign(rows.size(), std::vector<int>(systems.size(), 0));
            const auto at = std::find(systems.begin(), systems.end(), row->system) - systems.begin();
            ++of_participant[m][static_cast<std::size_t>(at)];
        }
    for (auto& [participant, answers] : counts) result.presence.push_back({participant, std::move(answers)});
}

}  // namespace

bool hasManySteps(const Measure& measure) {
    return measure.kind == MeasureKind::rating && measure.high - measure.low + 1.0 > 10.0;
}

void describeAnswers(AnalysisResult& result) {
    std::vector<RowPointers> rows(result.measures.size());
    for (const ResponseRow& row : result.table.rows)
        for (std::size_t m = 0; m < rows.size(); ++m)
            if (row.measure == result.measures[m].name) rows[m].push_back(&row);
    for (std::size_t m = 0; m < rows.size(); ++m) {
        const Measure& measure = result.measures[m];
        if (rows[m].empty()) continue;
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
