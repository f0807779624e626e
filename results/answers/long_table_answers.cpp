// What a line of a long table answers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "long_table_reader.hpp"

namespace deixis::results {

namespace {

constexpr const char* expected_rating = "a number from -1e12 to 1e12";

/// Sums and squares of such values are doubles.
bool isSensible(const std::optional<double>& value) {
    constexpr double max = 1e12;
    return value && std::abs(*value) <= max;
}

}  // namespace

std::string LongTableReader::ratingName() {
    const std::string named = name(measure);
    if (!named.empty()) return named;
    const std::string of_stage = name(stage);
    return of_stage.empty() ? rating_ : of_stage;
}

Result<std::string> LongTableReader::nameOnScale(const std::string& name) {
    const NumberCell low = number(scale_low);
    const NumberCell high = number(scale_high);
    if (low.missing || high.missing) return name;
    if (!isSensible(low.value)) return bad(scale_low, "a number");
    if (!isSensible(high.value) || *high.value <= *low.value)
        return bad(scale_high, "more than \"scale_low\"");
    const std::string on_scale = fmt::format("{} ({:g} to {:g})", name, *low.value, *high.value);
    scaled_.try_emplace(on_scale, OnScale{name, {*low.value, *high.value}});
    return on_scale;
}

Result<void> LongTableReader::checkScale(const std::string& name, double value, LongColumn column) const {
    if (options_.scales.empty()) return {};
    const auto scale = options_.scales.find(name);
    if (scale == options_.scales.end() || (value >= scale->second.low && value <= scale->second.high))
        return {};
    return fail(where(column),
                fmt::format("found \"{}\", beyond the scale of {} ({:g} to {:g})", cell(column), name,
                            scale->second.low, scale->second.high),
                "Empty the cell if that means no answer, or correct --scale");
}

Result<void> LongTableReader::addRow(const ResponseRow& answer, const std::string& name, MeasureKind kind,
                                     double value) {
    const auto word = [](MeasureKind of) {
        return of == MeasureKind::accuracy ? "right or wrong"
               : of == MeasureKind::rating ? "a rating"
                                           : "a preference";
    };
    if (kind == MeasureKind::rating && name == accuracy_)
        return fail(fmt::format("{}:{}", file_, record_.line),
                    "a rating is called \"accuracy\", the name for correct choices",
                    "Give it another name in a column \"measure\"");
    Measure& of = measureNamed(name, kind);
    if (of.kind != kind)
        return fail(fmt::format("{}:{}", file_, record_.line),
                    fmt::format("\"{}\" is {} here and {} elsewhere", name, word(kind), word(of.kind)),
                    "Give the two different names in a column \"measure\"");
    ResponseRow& row = table_.rows.emplace_back(answer);
    row.measure = name;
    row.value = value;
    if (row.excluded.empty()) count(of, row);
    return {};
}

Result<void> LongTableReader::readPreference(const ResponseRow& row, LongColumn column) {
    const NumberCell found = number(column);
    const auto value = found.value;
    if (!value || *value != std::floor(*value) || std::abs(*value) > 2.0)
        return bad(
            column,
            "a preference: a whole number from -2 (clearly for \"system\") over 0 (neither) to 2 (clearly "
            "for \"other_system\")");
    const std::string called = name(measure);
    if (preference_of_.empty()) preference_of_ = called;
    if (called != preference_of_)
        return fail(where(measure),
                    fmt::format("found preferences in \"{}\", and in \"{}\" before", called, preference_of_),
                    "Analyse them separately, in separate files");
    return addRow(row, preference_, MeasureKind::preference, *value);
}

Result<void> LongTableReader::readUnanswered(const ResponseRow& row) {
    // What else was asked of such a trial stands in lines of its own.
    if (!number(rating).missing)
        return fail(where(status), fmt::format("found \"{}\" beside a rating", cell(status)),
                    "Only choices time out or are skipped");
    if (const TruthCell is_right = truth(correct); !is_right.missing && is_right.value.value_or(true))
        return fail(where(status), fmt::format("found \"{}\" beside a right choice", cell(status)),
                    "If nothing was chosen, \"correct\" is 0 or empty");
    if (row.unanswered == "timed_out") return addRow(row, accuracy_, MeasureKind::accuracy, 0.0);
    if (row.excluded.empty()) {
        ResponseRow& skipped = table_.skipped_rows.emplace_back(row);
        skipped.measure = accuracy_;
        ++measureNamed(accuracy_, MeasureKind::accuracy).planned;
    }
    return {};
}

Result<void> LongTableReader::readAnswers(const ResponseRow& row) {
    bool answered = false;
    if (!row.unanswered.empty()) return readUnanswered(row);
    if (const TruthCell is_right = truth(correct); !is_right.missing) {
        if (!is_right.value) return bad(correct, "0 or 1");
        if (!row.other_system.empty()) return bad(other_system, "nothing beside a choice");
        if (auto added = addRow(row, accuracy_, MeasureKind::accuracy, *is_right.value ? 1.0 : 0.0); !added)
            return added;
        answered = true;
    }
    if (const NumberCell found = number(rating); !found.missing) {
        if (!row.other_system.empty()) return readPreference(row, rating);
        if (!isSensible(found.value)) return bad(rating, expected_rating);
        const std::string called = ratingName();
        if (auto checked = checkScale(called, *found.value, rating); !checked) return checked;
        const auto on_scale = nameOnScale(called);
        if (!on_scale) return tl::unexpected(on_scale.error());
        if (auto added = addRow(row, *on_scale, MeasureKind::rating, *found.value); !added) return added;
        answered = true;
    }
    if (answered) return {};
    if (!head_.place(response)) {
        ++empty_;
        return {};
    }
    const TruthCell is_true = truth(response);
    if (!is_true.missing && !row.other_system.empty()) return readPreference(row, response);
    // What it is shows when all of the stage are known.
    StageResponses& responses = responses_[ratingName()];
    if (is_true.missing) {
        responses.missing += row.excluded.empty() ? 1 : 0;
        return {};
    }
    const auto value =
        is_true.value ? std::optional<double>(*is_true.value ? 1.0 : 0.0) : number(response).value;
    if (!isSensible(value)) return bad(response, "a number from -1e12 to 1e12, or true or false");
    if (auto checked = checkScale(ratingName(), *value, response); !checked) return checked;
    responses.only_truth = responses.only_truth && is_true.value.has_value();
    responses.rows.push_back(table_.rows.size());
    table_.rows.emplace_back(row).value = *value;
    return {};
}

}  // namespace deixis::results
