#include "long_table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "long_table_warnings.hpp"

namespace deixis::results {

namespace {

/// Levels stand in the order in which they first occur.
void addLevel(const std::string& level, std::vector<std::string>& levels) {
    if (!level.empty() && std::find(levels.begin(), levels.end(), level) == levels.end())
        levels.push_back(level);
}

}  // namespace

LongTableReader::LongTableReader(const std::filesystem::path& file, std::string_view text, CsvForm form,
                                 const LongTableOptions& options)
    : file_(file.string()), form_(form), reader_(text, file_, form), options_(options) {
    table_.study_name = file.stem().string();
    table_.study_title = file.filename().string();
    table_.database = file.filename().string();
}

Result<void> LongTableReader::readHead() {
    const auto more = reader_.next(record_);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return fail(file_, "is empty; expected a CSV file with the columns' names in its first line");
    const auto head = readLongHead(record_, file_, form_.separator, options_);
    if (!head) return tl::unexpected(head.error());
    head_ = *head;
    for (const LongHead::FactorAt& factor : head_.between) table_.between.push_back({factor.name});
    for (const LongHead::FactorAt& factor : head_.within) table_.within.push_back({factor.name});
    if (!head_.unread.empty() && !head_.exported) {
        table_.notes.push_back(fmt::format("Columns of {} that are not read: {}.", table_.database,
                                           fmt::join(head_.unread, ", ")));
        if (auto warning = warningOfUnread(head_.unread)) table_.notes.push_back(std::move(*warning));
    }
    return {};
}

Result<void> LongTableReader::readRows() {
    for (;;) {
        const auto more = reader_.next(record_);
        if (!more) return tl::unexpected(more.error());
        if (!*more) return {};
        if (auto row = readRow(); !row) return row;
    }
}

const std::string& LongTableReader::cell(LongColumn column) const {
    static const std::string none;
    const auto at = head_.place(column);
    return at ? record_.fields[*at] : none;
}

std::string LongTableReader::name(LongColumn column) const {
    return nameIn(cell(column));
}

NumberCell LongTableReader::number(LongColumn column) {
    const std::string& text = cell(column);
    NumberCell out = numberCell(text);
    if (!out.value) return out;
    const bool with_point = text.find('.') != std::string::npos;
    if (std::string& first = out.with_comma ? decimal_comma_ : decimal_point_;
        (out.with_comma || with_point) && first.empty())
        first = fmt::format("\"{}\" in line {}", trimmed(text), record_.line);
    return out;
}

TruthCell LongTableReader::truth(LongColumn column) const {
    return truthCell(cell(column));
}

std::string LongTableReader::where(LongColumn column) const {
    return fmt::format("{}:{}: column \"{}\"", file_, record_.line, nameOf(column));
}

tl::unexpected<Error> LongTableReader::bad(LongColumn column, const char* expected) const {
    return fail(where(column), fmt::format("found \"{}\", expected {}", cell(column), expected));
}

Result<void> LongTableReader::agree(std::optional<std::string>& known, const std::string& value,
                                    const std::string& who, std::string_view column) const {
    if (!known) known = value;
    if (*known == value) return {};
    return fail(
        fmt::format("{}:{}: column \"{}\"", file_, record_.line, column),
        fmt::format("found \"{}\", but \"{}\" in an earlier line of participant {}", value, *known, who),
        "It must be the same in all lines of a participant");
}

Person& LongTableReader::personOf(const std::string& who) {
    Person& person = people_[who];
    person.between.resize(table_.between.size());
    return person;
}

Result<void> LongTableReader::readFactors(Person& person, ResponseRow& row) {
    for (std::size_t i = 0; i < table_.between.size(); ++i) {
        const std::string level = nameIn(record_.fields[head_.between[i].at]);
        Factor& factor = table_.between[i];
        if (isMissing(plainWord(level))) continue;
        if (auto same = agree(person.between[i], level, row.participant, factor.name); !same) return same;
        addLevel(level, factor.levels);
    }
    for (std::size_t i = 0; i < table_.within.size(); ++i) {
        const std::string& level = record_.fields[head_.within[i].at];
        row.within.push_back(isMissing(plainWord(level)) ? "" : nameIn(level));
        addLevel(row.within.back(), table_.within[i].levels);
    }
    return {};
}

Result<void> LongTableReader::readRow() {
    if (record_.fields.size() != head_.width)
        return fail(fmt::format("{}:{}", file_, record_.line),
                    fmt::format("has {} field{}, but the first line names {} columns", record_.fields.size(),
                                record_.fields.size() == 1 ? "" : "s", head_.width));
    if (head_.exported && !takeExportLine()) return {};
    ResponseRow row;
    row.participant = name(participant);
    row.system = name(system);
    for (const LongColumn needed : {participant, system})
        if (name(needed).empty()) return fail(where(needed), "is empty; expected a name");
    row.other_system = name(other_system);
    if (row.other_system == row.system) return bad(other_system, "another one than in \"system\"");
    row.layout = name(layout);
    row.distance = name(distance);
    row.target_id = name(item);
    row.station = name(station);
    if (auto read = readDetails(row); !read) return read;

    const TruthCell is_practice = truth(practice);
    if (!is_practice.missing && !is_practice.value) return bad(practice, "0 or 1");
    const auto check = attentionOf(plainWord(cell(attention)));
    if (!check) return bad(attention, "0, 1, passed or failed");
    row.excluded = reasonOf(cell(excluded), "excluded");
    Person& person = personOf(row.participant);
    if (auto same = agree(person.excluded, row.excluded.empty() ? not_excluded_ : row.excluded,
                          row.participant, "excluded");
        !same)
        return same;
    row.marked = reasonOf(cell(marked), "marked");
    if (*check != Attention::none) {
        countCheck(name(stage), "attention", *check);
        if (*check == Attention::failed && row.excluded.empty()) table_.failed_checks.insert(row.participant);
        return {};
    }
    if (is_practice.value.value_or(false)) return {};
    if (auto read = readFactors(person, row); !read) return read;
    person.counts = person.counts || row.excluded.empty();
    addLevel(row.system, table_.systems);
    addLevel(row.other_system, table_.systems);
    addLevel(row.layout, table_.layouts);
    addLevel(row.distance, table_.distances);
    return readAnswers(row);
}

Result<void> LongTableReader::readDetails(ResponseRow& row) {
    const LongColumn counter = head_.place(order) ? order : trial;
    if (const NumberCell found = number(counter); !found.missing) {
        const auto value = found.value;
        const bool whole = value && *value == std::floor(*value) && std::abs(*value) < 1e9;
        if (!whole && counter == order) return bad(order, "a whole number");
        if (whole) row.trial = static_cast<int>(*value);
    }
    if (const NumberCell found = number(rt); !found.missing) {
        if (!found.value || *found.value < 0.0)
            return bad(rt, head_.rt_unit_s < 1.0 ? "milliseconds, from 0 up" : "seconds, from 0 up");
        row.response_time_s = *found.value * head_.rt_unit_s;
    }
    if (const TruthCell is_synthetic = truth(synthetic); !is_synthetic.missing) {
        if (!is_synthetic.value) return bad(synthetic, "0 or 1");
        row.synthetic = *is_synthetic.value;
    }
    if (const NumberCell found = number(balls); !found.missing) {
        const auto value = found.value;
        if (!value || *value != std::floor(*value) || *value < 2.0 || *value > 1000.0)
            return bad(balls, "how many balls were shown, from 2 up");
        row.balls = static_cast<int>(*value);
        balls_ = std::max(balls_, row.balls);
        min_balls_ = std::min(min_balls_, row.balls);
    }
    if (const NumberCell found = number(author_trial); !found.missing) {
        const auto value = found.value;
        if (!value || *value != std::floor(*value) || *value < 1.0 || *value > 1e6)
            return bad(author_trial, "in which of its author's trials the clip was made, from 1 up");
        row.author_trial = static_cast<int>(*value);
    }
    if (const std::string said = plainWord(cell(status)); !isMissing(said) && said != "answered") {
        if (said != "timed_out" && said != "skipped") return bad(status, "answered, timed_out or skipped");
        row.unanswered = said;
        row.response_time_s = 0.0;
    }
    return {};
}

void LongTableReader::countCheck(const std::string& stage_name, const std::string& kind, Attention result) {
    if (result == Attention::check) {
        ++unscored_checks_;
        return;
    }
    CheckCount& checks = checksOf(stage_name, kind);
    ++(result == Attention::passed ? checks.passed : checks.failed);
}

CheckCount& LongTableReader::checksOf(const std::string& stage_name, const std::string& kind) {
    for (CheckCount& known : table_.checks)
        if (known.stage == stage_name && known.kind == kind) return known;
    return table_.checks.emplace_back(CheckCount{stage_name, kind, 0, 0});
}

Measure& LongTableReader::measureNamed(const std::string& name, MeasureKind kind) {
    for (Measure& known : table_.measures)
        if (known.name == name) return known;
    table_.measures.push_back({name, kind, std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), 0, 0});
    return table_.measures.back();
}

void LongTableReader::count(Measure& of, const ResponseRow& row) {
    ++of.planned;
    of.low = std::min(of.low, row.value);
    of.high = std::max(of.high, row.value);
}

}  // namespace deixis::results
