#include "results/long_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/csv.hpp"
#include "core/files.hpp"

namespace deixis::results {

namespace {

enum class LongColumn : std::size_t {
    participant,
    system,
    correct,
    rating,
    response,
    stage,
    measure,
    layout,
    distance,
    trial,
    order,
    item,
    rt,
    attention,
    practice,
    synthetic,
    balls
};
constexpr std::size_t long_column_count = static_cast<std::size_t>(LongColumn::balls) + 1;
constexpr std::array<std::string_view, long_column_count> long_column_names{
    "participant", "system", "correct", "rating", "response",  "stage",    "measure",   "layout", "distance",
    "trial",       "order",  "item",    "rt",     "attention", "practice", "synthetic", "balls"};

std::size_t place(LongColumn column) {
    return static_cast<std::size_t>(column);
}

std::string lowered(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    std::string out(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    return out;
}

bool isMissing(const std::string& lower) {
    return lower.empty() || lower == "na" || lower == "nan" || lower == "null";
}

std::optional<bool> truthOf(const std::string& lower) {
    if (lower == "1" || lower == "true" || lower == "yes") return true;
    if (lower == "0" || lower == "false" || lower == "no") return false;
    return std::nullopt;
}

std::optional<double> numberOf(const std::string& lower) {
    double value = 0.0;
    const char* end = lower.data() + lower.size();
    const auto [at, error] = std::from_chars(lower.data(), end, value);
    if (error != std::errc() || at != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

enum class Attention : unsigned char { none, check, passed, failed };

std::optional<Attention> attentionOf(const std::string& lower) {
    if (isMissing(lower) || lower == "none") return Attention::none;
    if (lower == "passed" || lower == "pass") return Attention::passed;
    if (lower == "failed" || lower == "fail") return Attention::failed;
    if (lower == "check") return Attention::check;
    if (const auto is_check = truthOf(lower)) return *is_check ? Attention::check : Attention::none;
    return std::nullopt;
}

void addOnce(std::vector<std::string>& known, const std::string& name) {
    if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
}

/// What a column "response" holds in one stage: right and wrong, or ratings.
struct StageResponses {
    std::vector<std::size_t> rows;  ///< of ResponseTable::rows
    bool only_truth = true;
    int missing = 0;
};

class LongTableReader {
  public:
    using enum LongColumn;

    LongTableReader(const std::filesystem::path& file, std::string_view text)
        : file_(file.string()), reader_(text, file_), has_() {
        table_.study_name = file.stem().string();
        table_.study_title = file.filename().string();
        table_.database = file.filename().string();
    }

    Result<ResponseTable> read() {
        if (auto head = readHead(); !head) return tl::unexpected(head.error());
        for (;;) {
            const auto more = reader_.next(record_);
            if (!more) return tl::unexpected(more.error());
            if (!*more) break;
            if (auto row = readRow(); !row) return tl::unexpected(row.error());
        }
        return finish();
    }

  private:
    Result<void> readHead() {
        const auto more = reader_.next(record_);
        if (!more) return tl::unexpected(more.error());
        if (!*more)
            return fail(
                file_, "is empty; expected a CSV file with the columns' long_column_names in its first line");
        width_ = record_.fields.size();
        std::vector<std::string> unread;
        for (std::size_t i = 0; i < width_; ++i) {
            std::string name = lowered(record_.fields[i]);
            if (name == "response_time_s") name = long_column_names[place(rt)];
            const auto known = std::find(long_column_names.begin(), long_column_names.end(), name);
            if (known == long_column_names.end()) {
                unread.push_back(record_.fields[i]);
                continue;
            }
            const auto column = static_cast<std::size_t>(known - long_column_names.begin());
            if (has_[column])
                return fail(file_, fmt::format("has several columns \"{}\"", name), "Name them differently");
            has_[column] = i;
        }
        for (const LongColumn needed : {participant, system})
            if (!has_[place(needed)])
                return fail(file_, fmt::format("has no column \"{}\"", long_column_names[place(needed)]),
                            "A long table has one line an answer, with columns participant, system, and "
                            "correct, rating or response");
        if (!has_[place(correct)] && !has_[place(rating)] && !has_[place(response)])
            return fail(file_, "has none of the columns \"correct\", \"rating\" and \"response\"",
                        "Name the column of the answers so");
        if (!unread.empty())
            table_.notes.push_back(fmt::format("Columns of {} that are not read: {}.", table_.database,
                                               fmt::join(unread, ", ")));
        return {};
    }

    [[nodiscard]] const std::string& cell(LongColumn column) const {
        static const std::string none;
        return has_[place(column)] ? record_.fields[*has_[place(column)]] : none;
    }
    [[nodiscard]] std::string where(LongColumn column) const {
        return fmt::format("{}:{}: column \"{}\"", file_, record_.line, long_column_names[place(column)]);
    }
    [[nodiscard]] tl::unexpected<Error> bad(LongColumn column, const char* expected) const {
        return fail(where(column), fmt::format("found \"{}\", expected {}", cell(column), expected));
    }
    [[nodiscard]] static std::string trimmed(const std::string& text) {
        const auto first = text.find_first_not_of(" \t\r");
        if (first == std::string::npos) return {};
        return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
    }

    Result<void> readRow() {
        if (record_.fields.size() != width_)
            return fail(fmt::format("{}:{}", file_, record_.line),
                        fmt::format("has {} fields, but the first line long_column_names {} columns",
                                    record_.fields.size(), width_));
        ResponseRow row;
        row.participant = trimmed(cell(participant));
        row.system = trimmed(cell(system));
        for (const LongColumn needed : {participant, system})
            if (trimmed(cell(needed)).empty()) return fail(where(needed), "is empty; expected a name");
        row.layout = trimmed(cell(layout));
        row.distance = trimmed(cell(distance));
        row.target_id = trimmed(cell(item));
        if (auto read = readDetails(row); !read) return read;

        const auto is_practice = has_[place(practice)] ? truthOf(lowered(cell(practice))) : false;
        if (!is_practice && !isMissing(lowered(cell(practice)))) return bad(practice, "0 or 1");
        const auto check = attentionOf(lowered(cell(attention)));
        if (!check) return bad(attention, "0, 1, passed or failed");
        const std::string stage_name = trimmed(cell(stage));
        if (*check != Attention::none) {
            countCheck(stage_name, *check);
            return {};
        }
        if (is_practice.value_or(false)) return {};
        participants_.insert(row.participant);
        addOnce(table_.systems, row.system);
        addOnce(table_.layouts, row.layout);
        addOnce(table_.distances, row.distance);
        return readAnswers(row, stage_name);
    }

    Result<void> readDetails(ResponseRow& row) {
        const LongColumn counter = has_[place(order)] ? order : trial;
        if (const std::string text = lowered(cell(counter)); !isMissing(text)) {
            const auto value = numberOf(text);
            const bool whole = value && *value == std::floor(*value) && std::abs(*value) < 1e9;
            if (!whole && counter == order) return bad(order, "a whole number");
            if (whole) row.trial = static_cast<int>(*value);
        }
        if (const std::string text = lowered(cell(rt)); !isMissing(text)) {
            const auto value = numberOf(text);
            if (!value || *value < 0.0) return bad(rt, "seconds, from 0 up");
            row.response_time_s = *value;
        }
        if (const std::string text = lowered(cell(synthetic)); !isMissing(text)) {
            const auto value = truthOf(text);
            if (!value) return bad(synthetic, "0 or 1");
            row.synthetic = *value;
        }
        if (const std::string text = lowered(cell(balls)); !isMissing(text)) {
            const auto value = numberOf(text);
            if (!value || *value != std::floor(*value) || *value < 2.0 || *value > 1000.0)
                return bad(balls, "how many balls were shown, from 2 up");
            balls_ = std::max(balls_, static_cast<int>(*value));
        }
        return {};
    }

    void countCheck(const std::string& stage_name, Attention result) {
        if (result == Attention::check) {
            ++unscored_checks_;
            return;
        }
        auto found = std::find_if(table_.checks.begin(), table_.checks.end(),
                                  [&](const CheckCount& one) { return one.stage == stage_name; });
        if (found == table_.checks.end())
            found = table_.checks.insert(table_.checks.end(), {stage_name, "attention", 0, 0});
        ++(result == Attention::passed ? found->passed : found->failed);
    }

    /// The measure's place in the table, made where it is new.
    Measure& measureNamed(const std::string& name, MeasureKind kind) {
        for (Measure& known : table_.measures)
            if (known.name == name) return known;
        table_.measures.push_back({name, kind, std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity(), 0, 0});
        return table_.measures.back();
    }

    [[nodiscard]] std::string ratingName(const std::string& stage_name) const {
        const std::string named = trimmed(cell(measure));
        return !named.empty() ? named : !stage_name.empty() ? stage_name : "rating";
    }

    Result<void> addRow(ResponseRow row, const std::string& name, MeasureKind kind, double value) {
        Measure& of = measureNamed(name, kind);
        if (of.kind != kind)
            return fail(fmt::format("{}:{}", file_, record_.line),
                        fmt::format("\"{}\" is a rating here and right or wrong elsewhere", name),
                        "Give the two different long_column_names in a column \"measure\"");
        ++of.planned;
        of.low = std::min(of.low, value);
        of.high = std::max(of.high, value);
        row.measure = name;
        row.value = value;
        table_.rows.push_back(std::move(row));
        return {};
    }

    Result<void> readAnswers(const ResponseRow& row, const std::string& stage_name) {
        bool answered = false;
        if (const std::string text = lowered(cell(correct)); !isMissing(text)) {
            const auto value = truthOf(text);
            if (!value) return bad(correct, "0 or 1");
            if (auto added = addRow(row, "accuracy", MeasureKind::accuracy, *value ? 1.0 : 0.0); !added)
                return added;
            answered = true;
        }
        if (const std::string text = lowered(cell(rating)); !isMissing(text)) {
            const auto value = numberOf(text);
            if (!value) return bad(rating, "a number");
            if (auto added = addRow(row, ratingName(stage_name), MeasureKind::rating, *value); !added)
                return added;
            answered = true;
        }
        if (answered) return {};
        if (!has_[place(response)]) {
            ++empty_;
            return {};
        }
        // What it is shows when all of the stage are known.
        StageResponses& responses = responses_[ratingName(stage_name)];
        const std::string text = lowered(cell(response));
        if (isMissing(text)) {
            ++responses.missing;
            return {};
        }
        const auto is_true = truthOf(text);
        const auto value = is_true ? std::optional<double>(*is_true ? 1.0 : 0.0) : numberOf(text);
        if (!value) return bad(response, "a number, or true or false");
        responses.only_truth = responses.only_truth && is_true.has_value();
        responses.rows.push_back(table_.rows.size());
        table_.rows.push_back(row);
        table_.rows.back().value = *value;
        return {};
    }

    void nameResponses() {
        for (const auto& [stage_name, responses] : responses_) {
            const bool accuracy = responses.only_truth;
            const std::string name = accuracy ? "accuracy" : stage_name;
            Measure& of = measureNamed(name, accuracy ? MeasureKind::accuracy : MeasureKind::rating);
            of.planned += static_cast<int>(responses.rows.size()) + responses.missing;
            for (const std::size_t i : responses.rows) {
                table_.rows[i].measure = name;
                of.low = std::min(of.low, table_.rows[i].value);
                of.high = std::max(of.high, table_.rows[i].value);
            }
            if (accuracy)
                table_.notes.push_back(fmt::format(
                    "Every response in \"{}\" is 0 or 1: they are taken as wrong and right.", stage_name));
        }
    }

    Result<ResponseTable> finish() {
        nameResponses();
        if (table_.rows.empty()) return fail(file_, "holds no answers to analyse");
        for (Measure& one : table_.measures)
            if (one.kind == MeasureKind::accuracy) {
                one.low = 0.0;
                one.high = 1.0;
                one.balls = balls_;
            }
        std::stable_partition(table_.measures.begin(), table_.measures.end(),
                              [](const Measure& one) { return one.kind == MeasureKind::accuracy; });
        if (empty_ > 0) table_.notes.push_back(fmt::format("{} lines hold no answer.", empty_));
        if (unscored_checks_ > 0)
            table_.notes.push_back(fmt::format(
                "{} attention checks are left out; whether they were passed is not told.", unscored_checks_));
        table_.planned_participants = static_cast<int>(participants_.size());
        std::stable_sort(
            table_.rows.begin(), table_.rows.end(), [](const ResponseRow& a, const ResponseRow& b) {
                return a.participant != b.participant ? a.participant < b.participant : a.trial < b.trial;
            });
        return std::move(table_);
    }

    std::string file_;
    CsvReader reader_;
    CsvRecord record_;
    std::array<std::optional<std::size_t>, long_column_count> has_;
    std::size_t width_ = 0;
    ResponseTable table_;
    std::set<std::string> participants_;
    std::map<std::string, StageResponses> responses_;
    int balls_ = 0;
    int empty_ = 0;
    int unscored_checks_ = 0;
};

}  // namespace

Result<ResponseTable> loadLongTable(const std::filesystem::path& file) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    return LongTableReader(file, *text).read();
}

Result<ResponseTable> loadAnswers(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string start(15, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    const bool csv = in.gcount() > 0 && start != "SQLite format 3";
    return csv ? loadLongTable(file) : loadResponses(file);
}

}  // namespace deixis::results
