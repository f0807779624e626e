#include "results/long_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "long_table_cells.hpp"

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
    balls,
    excluded,
    marked
};
constexpr std::size_t long_column_count = static_cast<std::size_t>(LongColumn::marked) + 1;
constexpr std::array<std::string_view, long_column_count> long_column_names{
    "participant", "system",    "correct", "rating",   "response", "stage", "measure",
    "layout",      "distance",  "trial",   "order",    "item",     "rt",    "attention",
    "practice",    "synthetic", "balls",   "excluded", "marked"};

std::size_t place(LongColumn column) {
    return static_cast<std::size_t>(column);
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

    LongTableReader(const std::filesystem::path& file, std::string_view text, const FactorColumns& factors)
        : file_(file.string()), reader_(text, file_), factors_(factors), has_() {
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
                if (!isFactor(i)) unread.push_back(record_.fields[i]);
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
        for (const auto& [asked, option, factors, found] :
             {std::tuple(&factors_.between, "--between", &table_.between, &between_at_),
              std::tuple(&factors_.within, "--within", &table_.within, &within_at_)})
            for (const std::string& name : *asked) {
                if (auto at = factorColumn(name, option); at)
                    found->push_back(*at);
                else
                    return tl::unexpected(at.error());
                factors->push_back({trimmed(record_.fields[found->back()])});
            }
        level_of_.resize(table_.between.size());
        if (!unread.empty())
            table_.notes.push_back(fmt::format("Columns of {} that are not read: {}.", table_.database,
                                               fmt::join(unread, ", ")));
        return {};
    }

    [[nodiscard]] bool isFactor(std::size_t column) const {
        const auto names = [&](const std::string& name) {
            return lowered(name) == lowered(record_.fields[column]);
        };
        return std::any_of(factors_.between.begin(), factors_.between.end(), names) ||
               std::any_of(factors_.within.begin(), factors_.within.end(), names);
    }

    /// Of the first line.
    [[nodiscard]] Result<std::size_t> factorColumn(const std::string& name, const char* option) const {
        const std::string wanted = lowered(name);
        if (std::find(long_column_names.begin(), long_column_names.end(), wanted) != long_column_names.end())
            return fail(file_, fmt::format("{} {}: this column has a meaning of its own", option, name),
                        "Name another column");
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < width_; ++i) {
            if (lowered(record_.fields[i]) != wanted) continue;
            if (found || std::count(between_at_.begin(), between_at_.end(), i) +
                                 std::count(within_at_.begin(), within_at_.end(), i) >
                             0)
                return fail(file_, fmt::format("{} {}: the column stands twice", option, name));
            found = i;
        }
        if (!found)
            return fail(file_, fmt::format("{} {}: there is no such column", option, name),
                        fmt::format("The columns are {}", fmt::join(record_.fields, ", ")));
        return *found;
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
    /// What holds of a participant stands alike in all of the participant's lines; an empty cell says
    /// nothing.
    Result<void> agree(std::map<std::string, std::string>& known, const std::string& who,
                       const std::string& value, const std::string& column) const {
        if (value.empty()) return {};
        const auto [found, is_new] = known.try_emplace(who, value);
        if (is_new || found->second == value) return {};
        return fail(fmt::format("{}:{}: column \"{}\"", file_, record_.line, column),
                    fmt::format("found \"{}\", but \"{}\" in an earlier line of participant {}", value,
                                found->second, who),
                    "It must be the same in all lines of a participant");
    }

    Result<void> readFactors(ResponseRow& row) {
        for (std::size_t i = 0; i < table_.between.size(); ++i) {
            const std::string level = trimmed(record_.fields[between_at_[i]]);
            Factor& factor = table_.between[i];
            if (isMissing(lowered(level))) continue;
            if (auto same = agree(level_of_[i], row.participant, level, factor.name); !same) return same;
            addOnce(factor.levels, level);
            table_.groups[row.participant][factor.name] = level;
        }
        for (std::size_t i = 0; i < table_.within.size(); ++i) {
            const std::string level = trimmed(record_.fields[within_at_[i]]);
            const bool missing = isMissing(lowered(level));
            if (!missing) addOnce(table_.within[i].levels, level);
            row.within.push_back(missing ? "" : level);
        }
        return {};
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
        row.excluded = reasonOf(cell(excluded), "excluded");
        if (auto same =
                agree(excluded_, row.participant, row.excluded.empty() ? "no" : row.excluded, "excluded");
            !same)
            return same;
        row.marked = reasonOf(cell(marked), "marked");
        if (*check != Attention::none) {
            countCheck(stage_name, *check);
            if (*check == Attention::failed && row.excluded.empty())
                table_.failed_checks.insert(row.participant);
            return {};
        }
        if (is_practice.value_or(false)) return {};
        if (auto read = readFactors(row); !read) return read;
        if (row.excluded.empty()) participants_.insert(row.participant);
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

    /// Who is left out has no say in what was planned and in the scale.
    static void count(Measure& of, const ResponseRow& row) {
        ++of.planned;
        of.low = std::min(of.low, row.value);
        of.high = std::max(of.high, row.value);
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
        row.measure = name;
        row.value = value;
        if (row.excluded.empty()) count(of, row);
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
            responses.missing += row.excluded.empty() ? 1 : 0;
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
            of.planned += responses.missing;
            for (const std::size_t i : responses.rows) {
                table_.rows[i].measure = name;
                if (table_.rows[i].excluded.empty()) count(of, table_.rows[i]);
            }
            if (accuracy)
                table_.notes.push_back(fmt::format(
                    "Every response in \"{}\" is 0 or 1: they are taken as wrong and right.", stage_name));
        }
    }

    void partLeftOut() {
        for (const auto& [who, reason] : excluded_) {
            if (reason == "no") continue;
            // The table of answers writes the status before the reason.
            const bool dropped = reason.starts_with("dropped: ");
            const bool with_status = dropped || reason.starts_with("excluded: ");
            table_.left_out.push_back(
                {who, dropped, with_status ? reason.substr(reason.find(' ') + 1) : reason});
        }
        const auto first = std::stable_partition(table_.rows.begin(), table_.rows.end(),
                                                 [](const ResponseRow& row) { return row.excluded.empty(); });
        table_.left_out_rows.assign(std::move_iterator(first), std::move_iterator(table_.rows.end()));
        table_.rows.erase(first, table_.rows.end());
        std::erase_if(table_.measures, [](const Measure& one) { return one.planned == 0; });
    }

    Result<ResponseTable> finish() {
        nameResponses();
        partLeftOut();
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
        for (auto* rows : {&table_.rows, &table_.left_out_rows})
            std::stable_sort(rows->begin(), rows->end(), [](const ResponseRow& a, const ResponseRow& b) {
                return a.participant != b.participant ? a.participant < b.participant : a.trial < b.trial;
            });
        return std::move(table_);
    }

    std::string file_;
    CsvReader reader_;
    CsvRecord record_;
    const FactorColumns& factors_;
    std::vector<std::size_t> between_at_;  ///< columns of ResponseTable::between
    std::vector<std::size_t> within_at_;
    std::vector<std::map<std::string, std::string>> level_of_;  ///< by factor between, of each participant
    std::map<std::string, std::string> excluded_;               ///< participant: why, or "no"
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

Result<ResponseTable> loadLongTable(const std::filesystem::path& file, const FactorColumns& factors) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    return LongTableReader(file, *text, factors).read();
}

Result<ResponseTable> loadAnswers(const std::filesystem::path& file, const FactorColumns& factors) {
    std::ifstream in(file, std::ios::binary);
    std::string start(15, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    const bool no_bytes = in.is_open() && in.gcount() == 0;
    std::error_code code;
    if (no_bytes && std::filesystem::is_regular_file(file, code))
        return fail(file.string(),
                    "the file is empty (0 bytes); expected a database or a CSV file with answers");
    const bool csv = in.gcount() > 0 && start != "SQLite format 3";
    if (csv) return loadLongTable(file, factors);
    if (!factors.between.empty() || !factors.within.empty())
        return fail(file.string(), "--between and --within name columns of CSV files, and this is a database",
                    "Leave them out: its study names its factors");
    return loadResponses(file);
}

}  // namespace deixis::results
