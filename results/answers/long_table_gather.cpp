// What the lines of a long table make together.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "long_table_reader.hpp"

namespace deixis::results {

namespace {

void sortByParticipantAndTrial(std::vector<ResponseRow>& rows) {
    const auto before = [](const ResponseRow& a, const ResponseRow& b) {
        return std::tie(a.participant, a.trial) < std::tie(b.participant, b.trial);
    };
    // Most files are in order, and a row is large.
    if (!std::is_sorted(rows.begin(), rows.end(), before)) std::stable_sort(rows.begin(), rows.end(), before);
}

}  // namespace

Result<void> LongTableReader::nameResponses() {
    for (const auto& [stage_name, responses] : responses_) {
        const bool accuracy = responses.only_truth;
        const std::string& name = accuracy ? accuracy_ : stage_name;
        const MeasureKind kind = accuracy ? MeasureKind::accuracy : MeasureKind::rating;
        Measure& of = measureNamed(name, kind);
        if (of.kind != kind || (!accuracy && name == accuracy_))
            return fail(file_, fmt::format("has answers of different kinds under the name \"{}\"", name),
                        "Give them different names in a column \"measure\"");
        of.planned += responses.missing;
        for (const std::size_t i : responses.rows) {
            table_.rows[i].measure = name;
            if (table_.rows[i].excluded.empty()) count(of, table_.rows[i]);
        }
        if (accuracy)
            table_.notes.push_back(fmt::format(
                "Every response in \"{}\" is 0 or 1: they are read as wrong and right.", stage_name));
    }
    return {};
}

void LongTableReader::nameScales() {
    std::map<std::string, int> scales;
    for (const auto& [on_scale, of] : scaled_) ++scales[of.measure];
    std::map<std::string, std::string> plain;
    for (const auto& [on_scale, of] : scaled_) {
        const auto known =
            std::find_if(table_.measures.begin(), table_.measures.end(),
                         [&scaled = on_scale](const Measure& one) { return one.name == scaled; });
        const bool taken = std::any_of(table_.measures.begin(), table_.measures.end(),
                                       [&base = of.measure](const Measure& one) { return one.name == base; });
        if (known == table_.measures.end()) continue;
        known->low = std::min(known->low, of.scale.low);
        known->high = std::max(known->high, of.scale.high);
        if (scales[of.measure] > 1 || taken) continue;
        known->name = of.measure;
        plain[on_scale] = of.measure;
    }
    if (plain.empty()) return;
    for (auto* rows : {&table_.rows, &table_.left_out_rows})
        for (ResponseRow& row : *rows)
            if (const auto found = plain.find(row.measure); found != plain.end()) row.measure = found->second;
}

Result<void> LongTableReader::finishMeasures() {
    if (!decimal_comma_.empty() && !decimal_point_.empty())
        return fail(file_,
                    fmt::format("has numbers with a decimal comma ({}) and with a decimal point ({})",
                                decimal_comma_, decimal_point_),
                    "Write all of them in the same way");
    if (!decimal_comma_.empty())
        table_.notes.push_back(
            fmt::format("Commas in numbers are read as decimal points, as in {}.", decimal_comma_));
    for (const auto& [name, scale] : options_.scales) {
        const auto found = std::find_if(table_.measures.begin(), table_.measures.end(),
                                        [&wanted = name](const Measure& one) {
                                            return one.name == wanted && one.kind == MeasureKind::rating;
                                        });
        if (found == table_.measures.end()) {
            std::vector<std::string> ratings;
            for (const Measure& one : table_.measures)
                if (one.kind == MeasureKind::rating) ratings.push_back(one.name);
            return fail("--scale",
                        fmt::format("found \"{}\", but {} has no ratings of that name", name, file_),
                        fmt::format("Its ratings: {}",
                                    ratings.empty() ? "none" : fmt::format("{}", fmt::join(ratings, ", "))));
        }
        found->low = scale.low;
        found->high = scale.high;
    }
    for (Measure& one : table_.measures) {
        if (one.kind == MeasureKind::preference) {
            one.low = -2.0;
            one.high = 2.0;
        }
        if (one.kind != MeasureKind::accuracy) continue;
        one.low = 0.0;
        one.high = 1.0;
        one.balls = balls_;
        one.min_balls = std::min(min_balls_, balls_);
    }
    std::stable_partition(table_.measures.begin(), table_.measures.end(),
                          [](const Measure& one) { return one.kind == MeasureKind::accuracy; });
    return {};
}

void LongTableReader::takeParticipants() {
    for (const auto& [who, person] : people_) {
        table_.planned_participants += person.counts ? 1 : 0;
        for (std::size_t i = 0; i < person.between.size(); ++i)
            if (person.between[i]) table_.groups[who][table_.between[i].name] = *person.between[i];
        const std::string& reason = *person.excluded;
        if (reason == not_excluded_) continue;
        // The table of answers writes the status before the reason.
        const bool dropped = reason.starts_with("dropped: ");
        const bool with_status = dropped || reason.starts_with("excluded: ");
        table_.left_out.push_back({who, dropped, with_status ? reason.substr(reason.find(' ') + 1) : reason});
    }
}

void LongTableReader::partLeftOut() {
    if (!table_.left_out.empty()) {
        // Without consent the answers come back nowhere.
        std::erase_if(table_.rows, [&](const ResponseRow& row) {
            return !row.excluded.empty() && declines(row.participant);
        });
        const auto first = std::stable_partition(table_.rows.begin(), table_.rows.end(),
                                                 [](const ResponseRow& row) { return row.excluded.empty(); });
        table_.left_out_rows.assign(std::move_iterator(first), std::move_iterator(table_.rows.end()));
        table_.rows.erase(first, table_.rows.end());
    }
    std::erase_if(table_.measures, [](const Measure& one) { return one.planned == 0; });
}

Result<ResponseTable> LongTableReader::finish() {
    if (auto named = nameResponses(); !named) return tl::unexpected(named.error());
    takeParticipants();
    partLeftOut();
    if (table_.rows.empty())
        return fail(file_, table_.left_out_rows.empty()
                               ? "has no answers to analyse"
                               : "has no answers to analyse: everybody who answered is excluded");
    nameScales();
    if (auto finished = finishMeasures(); !finished) return tl::unexpected(finished.error());
    if (empty_ > 0) table_.notes.push_back(fmt::format("{} lines have no answer.", empty_));
    if (unscored_checks_ > 0)
        table_.notes.push_back(
            fmt::format("{} attention checks are left out; the data do not say whether they were passed.",
                        unscored_checks_));
    for (auto* rows : {&table_.rows, &table_.left_out_rows, &table_.skipped_rows})
        sortByParticipantAndTrial(*rows);
    return std::move(table_);
}

}  // namespace deixis::results
