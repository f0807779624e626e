#include "long_table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace deixis::results {

namespace {

constexpr const char* expected_rating = "a number from -1e12 to 1e12";

/// Sums and squares of such values are doubles.
bool isSensible(const std::optional<double>& value) {
    constexpr double most = 1e12;
    return value && std::abs(*value) <= most;
}

}  // namespace

LongTableReader::LongTableReader(const std::filesystem::path& file, std::string_view text,
                                 const FactorColumns& factors)
    : file_(file.string()), reader_(text, file_), factors_(factors) {
    table_.study_name = file.stem().string();
    table_.study_title = file.filename().string();
    table_.database = file.filename().string();
}

LongTableReader::LongTableReader(const LongTableReader& first, std::string_view text)
    : file_(first.file_), reader_(text, file_), factors_(first.factors_) {
    setUp(first.record_, first.head_);
}

void LongTableReader::setUp(const CsvRecord& names, const LongHead& head) {
    head_ = head;
    for (const std::size_t at : head.between) table_.between.push_back({trimmed(names.fields[at])});
    for (const std::size_t at : head.within) table_.within.push_back({trimmed(names.fields[at])});
    between_seen_.resize(table_.between.size());
    within_seen_.resize(table_.within.size());
    within_cells_.resize(table_.within.size());
}

Result<void> LongTableReader::readHead() {
    const auto more = reader_.next(record_);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return fail(file_, "is empty; expected a CSV file with the columns' names in its first line");
    const auto head = readLongHead(record_, file_, factors_);
    if (!head) return tl::unexpected(head.error());
    setUp(record_, *head);
    if (!head_.unread.empty())
        table_.notes.push_back(fmt::format("Columns of {} that are not read: {}.", table_.database,
                                           fmt::join(head_.unread, ", ")));
    return {};
}

Result<void> LongTableReader::readRows(std::size_t lines) {
    table_.rows.reserve(lines);
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

Name LongTableReader::name(LongColumn column) {
    return names_[static_cast<std::size_t>(column)].of(cell(column));
}

const TruthCell& LongTableReader::truth(LongColumn column) {
    return truths_[static_cast<std::size_t>(column)].of(cell(column), truthCell);
}

std::string LongTableReader::where(LongColumn column) const {
    return fmt::format("{}:{}: column \"{}\"", file_, record_.line, nameOf(column));
}

tl::unexpected<Error> LongTableReader::bad(LongColumn column, const char* expected) const {
    return fail(where(column), fmt::format("found \"{}\", expected {}", cell(column), expected));
}

Result<void> LongTableReader::agree(std::optional<Name>& known, Name value, Name who,
                                    std::string_view column) const {
    if (!known) known = value;
    if (*known == value) return {};
    return fail(
        fmt::format("{}:{}: column \"{}\"", file_, record_.line, column),
        fmt::format("found \"{}\", but \"{}\" in an earlier line of participant {}", value, *known, who),
        "It must be the same in all lines of a participant");
}

Person& LongTableReader::personOf(Name who) {
    if (person_ == nullptr || who != person_name_) {
        person_ = &people_[who];
        person_name_ = who;
        person_->between.resize(table_.between.size());
    }
    return *person_;
}

Result<void> LongTableReader::readFactors(Person& person, ResponseRow& row) {
    for (std::size_t i = 0; i < table_.between.size(); ++i) {
        const std::string level = trimmed(record_.fields[head_.between[i]]);
        Factor& factor = table_.between[i];
        if (isMissing(lowered(level))) continue;
        if (auto same = agree(person.between[i], level, row.participant, factor.name); !same) return same;
        between_seen_[i].add(level, factor.levels);
    }
    for (std::size_t i = 0; i < table_.within.size(); ++i) {
        const Name level = within_cells_[i].of(record_.fields[head_.within[i]], [](const std::string& cell) {
            return isMissing(lowered(cell)) ? Name() : Name(trimmed(cell));
        });
        within_seen_[i].add(level, table_.within[i].levels);
        row.within.push_back(level);
    }
    return {};
}

Result<void> LongTableReader::readRow() {
    if (record_.fields.size() != head_.width)
        return fail(fmt::format("{}:{}", file_, record_.line),
                    fmt::format("has {} field{}, but the first line names {} columns", record_.fields.size(),
                                record_.fields.size() == 1 ? "" : "s", head_.width));
    ResponseRow row;
    row.participant = name(participant);
    row.system = name(system);
    for (const LongColumn needed : {participant, system})
        if (name(needed).empty()) return fail(where(needed), "is empty; expected a name");
    row.layout = name(layout);
    row.distance = name(distance);
    row.target_id = name(item);
    row.station = name(station);
    if (auto read = readDetails(row); !read) return read;

    const TruthCell& is_practice = truth(practice);
    if (!is_practice.missing && !is_practice.value) return bad(practice, "0 or 1");
    const auto check =
        attention_.of(cell(attention), [](const std::string& text) { return attentionOf(lowered(text)); });
    if (!check) return bad(attention, "0, 1, passed or failed");
    row.excluded = excluded_.of(cell(excluded),
                                [](const std::string& text) { return Name(reasonOf(text, "excluded")); });
    Person& person = personOf(row.participant);
    if (auto same = agree(person.excluded, row.excluded.empty() ? not_excluded_ : row.excluded,
                          row.participant, "excluded");
        !same)
        return same;
    row.marked =
        marked_.of(cell(marked), [](const std::string& text) { return Name(reasonOf(text, "marked")); });
    if (*check != Attention::none) {
        countCheck(name(stage), *check);
        if (*check == Attention::failed && row.excluded.empty()) table_.failed_checks.insert(row.participant);
        return {};
    }
    if (is_practice.value.value_or(false)) return {};
    if (auto read = readFactors(person, row); !read) return read;
    person.counts = person.counts || row.excluded.empty();
    systems_.add(row.system, table_.systems);
    layouts_.add(row.layout, table_.layouts);
    distances_.add(row.distance, table_.distances);
    return readAnswers(row);
}

Result<void> LongTableReader::readDetails(ResponseRow& row) {
    const LongColumn counter = head_.place(order) ? order : trial;
    if (const NumberCell number = numberCell(cell(counter)); !number.missing) {
        const auto value = number.value;
        const bool whole = value && *value == std::floor(*value) && std::abs(*value) < 1e9;
        if (!whole && counter == order) return bad(order, "a whole number");
        if (whole) row.trial = static_cast<int>(*value);
    }
    if (const NumberCell number = numberCell(cell(rt)); !number.missing) {
        if (!number.value || *number.value < 0.0) return bad(rt, "seconds, from 0 up");
        row.response_time_s = *number.value;
    }
    if (const TruthCell& is_synthetic = truth(synthetic); !is_synthetic.missing) {
        if (!is_synthetic.value) return bad(synthetic, "0 or 1");
        row.synthetic = *is_synthetic.value;
    }
    if (const NumberCell number = numberCell(cell(balls)); !number.missing) {
        const auto value = number.value;
        if (!value || *value != std::floor(*value) || *value < 2.0 || *value > 1000.0)
            return bad(balls, "how many balls were shown, from 2 up");
        row.balls = static_cast<int>(*value);
        balls_ = std::max(balls_, row.balls);
        fewest_balls_ = std::min(fewest_balls_, row.balls);
    }
    if (const std::string said = lowered(cell(status)); !isMissing(said) && said != "answered") {
        if (said != "timed_out" && said != "skipped") return bad(status, "answered, timed_out or skipped");
        row.unanswered = said;
    }
    return {};
}

void LongTableReader::countCheck(const std::string& stage_name, Attention result) {
    if (result == Attention::check) {
        ++unscored_checks_;
        return;
    }
    CheckCount& checks = checksOf(stage_name);
    ++(result == Attention::passed ? checks.passed : checks.failed);
}

CheckCount& LongTableReader::checksOf(const std::string& stage_name) {
    for (CheckCount& known : table_.checks)
        if (known.stage == stage_name) return known;
    return table_.checks.emplace_back(CheckCount{stage_name, "attention", 0, 0});
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

Name LongTableReader::ratingName() {
    const Name named = name(measure);
    if (!named.empty()) return named;
    const Name of_stage = name(stage);
    return of_stage.empty() ? rating_ : of_stage;
}

Result<void> LongTableReader::addRow(const ResponseRow& answer, Name name, MeasureKind kind, double value) {
    Measure& of = measureNamed(name, kind);
    if (of.kind != kind)
        return fail(fmt::format("{}:{}", file_, record_.line),
                    fmt::format("\"{}\" is a rating here and right or wrong elsewhere", name),
                    "Give the two different names in a column \"measure\"");
    ResponseRow& row = table_.rows.emplace_back(answer);
    row.measure = name;
    row.value = value;
    if (row.excluded.empty()) count(of, row);
    return {};
}

Result<void> LongTableReader::readUnanswered(const ResponseRow& row) {
    // What else was asked of such a trial stands in lines of its own.
    if (!numberCell(cell(rating)).missing)
        return fail(where(status), fmt::format("found \"{}\" beside a rating", cell(status)),
                    "Only choices time out or are skipped");
    if (const TruthCell& is_right = truth(correct); !is_right.missing && is_right.value.value_or(true))
        return fail(where(status), fmt::format("found \"{}\" beside a right choice", cell(status)),
                    "Where nothing was chosen, \"correct\" is 0 or empty");
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
    if (const TruthCell& is_right = truth(correct); !is_right.missing) {
        if (!is_right.value) return bad(correct, "0 or 1");
        if (auto added = addRow(row, accuracy_, MeasureKind::accuracy, *is_right.value ? 1.0 : 0.0); !added)
            return added;
        answered = true;
    }
    if (const NumberCell number = numberCell(cell(rating)); !number.missing) {
        if (!isSensible(number.value)) return bad(rating, expected_rating);
        if (auto added = addRow(row, ratingName(), MeasureKind::rating, *number.value); !added) return added;
        answered = true;
    }
    if (answered) return {};
    if (!head_.place(response)) {
        ++empty_;
        return {};
    }
    // What it is shows when all of the stage are known.
    StageResponses& responses = responses_[ratingName()];
    const TruthCell& is_true = truth(response);
    if (is_true.missing) {
        responses.missing += row.excluded.empty() ? 1 : 0;
        return {};
    }
    const auto value =
        is_true.value ? std::optional<double>(*is_true.value ? 1.0 : 0.0) : numberCell(cell(response)).value;
    if (!isSensible(value)) return bad(response, "a number from -1e12 to 1e12, or true or false");
    responses.only_truth = responses.only_truth && is_true.value.has_value();
    responses.rows.push_back(table_.rows.size());
    table_.rows.emplace_back(row).value = *value;
    return {};
}

}  // namespace deixis::results
