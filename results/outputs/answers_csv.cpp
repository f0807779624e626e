#include "answers_csv.hpp"

#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "results/analysis/analysis_tests.hpp"
#include "results/tables/by_name.hpp"
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
    for (const Name name : {row.participant, row.measure, row.system, row.other_system, row.layout,
                            row.distance, row.target_id})
        csv.text(name.text());
    row.trial >= 0 ? csv.whole(row.trial) : csv.empty();
    row.balls > 0 ? csv.whole(row.balls) : csv.empty();
    csv.text(row.unanswered.empty() ? "answered" : row.unanswered.text());
    is_choice&& row.unanswered != "skipped" ? csv.whole(static_cast<int>(row.value)) : csv.empty();
    is_choice ? csv.empty() : csv.number(row.value);
    for (const double end : {measure.low, measure.high})
        measure.kind == MeasureKind::rating ? csv.number(end) : csv.empty();
    row.response_time_s > 0.0 ? csv.number(row.response_time_s) : csv.empty();
    csv.whole(row.synthetic ? 1 : 0);
    csv.text(row.station.text());
    csv.text(row.marked.text());
    csv.text(row.excluded.text());
    row.author_trial > 0 ? csv.whole(row.author_trial) : csv.empty();
    for (const Factor& factor : table.within) csv.text(levelOf(table, row, factor.name).text());
    for (const Factor& factor : table.between)
        csv.text(levelOfParticipant(table, row.participant, factor.name));
    csv.endRow();
}

}  // namespace

std::string answersCsv(const ResponseTable& table) {
    constexpr std::size_t rows_worth_a_thread = 50000;
    constexpr std::size_t usual_row_bytes = 64;
    std::string out;
    for (const auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows}) {
        auto parts = mapRanges(rows->size(), rows_worth_a_thread, [&](std::size_t from, std::size_t to) {
            CsvTable csv(answerColumns(table));
            if (from > 0 || rows != &table.rows) (void)csv.take();  // the columns' names stand once
            // The first part takes the others'.
            csv.expect((from == 0 ? rows->size() : to - from) * usual_row_bytes);
            ByName<Measure> measures;
            for (const Measure& measure : table.measures) measures[measure.name] = measure;
            for (std::size_t i = from; i < to; ++i)
                addAnswer(table, (*rows)[i], measures[(*rows)[i].measure], csv);
            return csv.take();
        });
        for (std::string& part : parts)
            if (out.empty())
                out = std::move(part);
            else
                out += part;
    }
    return out;
}

}  // namespace deixis::results
