#include "answers_csv.hpp"

#include <map>
#include <vector>

#include "results/analysis/tests.hpp"
#include "results/tables/csv_table.hpp"

namespace deixis::results {

namespace {

std::vector<ColumnSpec> answerColumns(const ResponseTable& table) {
    using enum ColumnType;
    std::vector<ColumnSpec> columns{
        {"participant", text, ""},  {"measure", text, ""},      {"system", text, ""},
        {"other_system", text, ""}, {"layout", text, ""},       {"distance", text, ""},
        {"item", text, ""},         {"order", whole, ""},       {"balls", whole, ""},
        {"status", text, ""},       {"correct", whole, ""},     {"rating", number, ""},
        {"scale_low", number, ""},  {"scale_high", number, ""}, {"rt", number, "", "s"},
        {"synthetic", truth, ""},   {"station", text, ""},      {"marked", text, ""},
        {"excluded", text, ""},     {"author_trial", whole, ""}};
    for (const auto* factors : {&table.within, &table.between})
        for (const Factor& factor : *factors) columns.push_back({factor.name, text, ""});
    return columns;
}

void addAnswer(const ResponseTable& table, const ResponseRow& row, const Measure& measure, CsvTable& csv) {
    const bool is_choice = measure.kind == MeasureKind::accuracy;
    for (const std::string* name : {&row.participant, &row.measure, &row.system, &row.other_system,
                                    &row.layout, &row.distance, &row.target_id})
        csv.text(*name);
    row.trial >= 0 ? csv.whole(row.trial) : csv.empty();
    row.balls > 0 ? csv.whole(row.balls) : csv.empty();
    csv.text(row.unanswered.empty() ? "answered" : row.unanswered);
    is_choice&& row.unanswered != "skipped" ? csv.whole(static_cast<int>(row.value)) : csv.empty();
    is_choice ? csv.empty() : csv.number(row.value);
    for (const double end : {measure.low, measure.high})
        measure.kind == MeasureKind::rating ? csv.number(end) : csv.empty();
    row.response_time_s > 0.0 ? csv.number(row.response_time_s) : csv.empty();
    csv.whole(row.synthetic ? 1 : 0);
    csv.text(row.station);
    csv.text(row.marked);
    csv.text(row.excluded);
    row.author_trial > 0 ? csv.whole(row.author_trial) : csv.empty();
    for (const Factor& factor : table.within) csv.text(levelOf(table, row, factor.name));
    for (const Factor& factor : table.between)
        csv.text(levelOfParticipant(table, row.participant, factor.name));
    csv.endRow();
}

}  // namespace

std::string answersCsv(const ResponseTable& table) {
    std::map<std::string, Measure> measures;
    for (const Measure& measure : table.measures) measures[measure.name] = measure;
    CsvTable csv(answerColumns(table));
    for (const auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        for (const ResponseRow& row : *rows) addAnswer(table, row, measures[row.measure], csv);
    return csv.take();
}

}  // namespace deixis::results
