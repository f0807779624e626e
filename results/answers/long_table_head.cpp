#include "long_table_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "long_table_cells.hpp"

namespace deixis::results {

namespace {

constexpr std::array<std::string_view, long_column_count> long_column_names{
    "participant",  "system",    "correct",    "rating",      "response", "stage",  "measure",
    "layout",       "distance",  "trial",      "order",       "item",     "rt",     "attention",
    "practice",     "synthetic", "balls",      "excluded",    "marked",   "status", "station",
    "other_system", "scale_low", "scale_high", "author_trial"};

constexpr std::array<std::string_view, export_column_count> export_column_names{
    "participant_status", "kind",         "question", "scored",  "value", "chosen_place",
    "check_kind",         "check_passed", "measure",  "correct", "status"};

constexpr std::string_view in_milliseconds = "rt_ms";

/// Other names for these columns.
std::string_view knownAs(std::string_view name) {
    if (name == "response_time_s" || name == "rt_s" || name == in_milliseconds) return "rt";
    if (name == "trial_index") return "trial";
    return name;
}

std::optional<std::size_t> columnNamed(std::string_view name) {
    const auto known = std::find(long_column_names.begin(), long_column_names.end(), knownAs(name));
    if (known == long_column_names.end()) return std::nullopt;
    return static_cast<std::size_t>(known - long_column_names.begin());
}

class HeadReader {
  public:
    using enum LongColumn;

    HeadReader(const CsvRecord& record, const std::string& file, char separator,
               const LongTableOptions& options)
        : file_(file), separator_(separator), options_(options) {
        for (const std::string& field : record.fields) {
            titles_.emplace_back(withoutGuard(trimmed(field)));
            names_.push_back(plainWord(titles_.back()));
        }
    }

    Result<LongHead> read() {
        head_.width = names_.size();
        if (auto mapped = mapColumns(); !mapped) return tl::unexpected(mapped.error());
        findExport();
        for (std::size_t i = 0; i < head_.width; ++i)
            if (auto known = readColumn(i); !known) return tl::unexpected(known.error());
        if (auto whole = needColumns(); !whole) return tl::unexpected(whole.error());
        for (const std::string& name : options_.between)
            if (auto found = addFactor(name, "--between", head_.between); !found)
                return tl::unexpected(found.error());
        for (const std::string& name : options_.within)
            if (auto found = addFactor(name, "--within", head_.within); !found)
                return tl::unexpected(found.error());
        return std::move(head_);
    }

  private:
    [[nodiscard]] std::string columnsFound() const {
        return fmt::format("Columns found, separated by {}: {}", separatorName(separator_),
                           fmt::join(titles_, ", "));
    }

    /// A column that is mapped gets the name that it stands for; one that has this name by itself loses it.
    Result<void> mapColumns() {
        for (const auto& [meaning, column] : options_.columns) {
            const std::string known = plainWord(meaning);
            if (!columnNamed(known))
                return fail(
                    "--column", fmt::format("found \"{}\", which is not a column that is read", meaning),
                    fmt::format("One of: {}, {}", fmt::join(long_column_names, ", "), in_milliseconds));
            const std::string wanted = plainWord(column);
            const auto found = std::find_if(titles_.begin(), titles_.end(), [&](const std::string& title) {
                return plainWord(title) == wanted;
            });
            if (found == titles_.end())
                return fail(file_, fmt::format("--column {}={}: there is no such column", meaning, column),
                            columnsFound());
            for (std::string& name : names_)
                if (knownAs(name) == knownAs(known)) name.clear();
            names_[static_cast<std::size_t>(found - titles_.begin())] = known;
        }
        return {};
    }

    /// Whether these are the columns of responses.csv.
    void findExport() {
        std::array<std::size_t, export_column_count> places{};
        for (std::size_t k = 0; k < export_column_count; ++k) {
            const auto found = std::find(names_.begin(), names_.end(), export_column_names.at(k));
            if (found == names_.end()) return;
            places.at(k) = static_cast<std::size_t>(found - names_.begin());
        }
        head_.exported = places;
        std::size_t behind = head_.width;
        for (const LongColumn made : {measure, correct, rating, status, excluded})
            head_.places.at(static_cast<std::size_t>(made)) = behind++;
    }

    Result<void> readColumn(std::size_t i) {
        const std::string& name = names_[i];
        if (head_.exported && readExportColumn(i)) return {};
        const auto known = columnNamed(name);
        if (!known) {
            if (!isFactor(i) && !titles_[i].empty()) head_.unread.push_back(titles_[i]);
            return {};
        }
        auto& place = head_.places.at(*known);
        if (place)
            return fail(file_, fmt::format("has several columns \"{}\"", long_column_names.at(*known)),
                        "Name them differently");
        place = i;
        if (name == in_milliseconds) head_.rt_unit_s = 0.001;
        return {};
    }

    /// Groups and levels of systems stand in columns of their own.
    bool readExportColumn(std::size_t i) {
        const auto factor = [&](std::string_view prefix, std::vector<LongHead::FactorAt>& to) {
            if (!names_[i].starts_with(prefix)) return false;
            to.push_back({titles_[i].substr(prefix.size()), i});
            return true;
        };
        return factor("group_", head_.between) || factor("level_", head_.within) ||
               std::find(export_column_names.begin(), export_column_names.end(), names_[i]) !=
                   export_column_names.end();
    }

    Result<void> needColumns() const {
        for (const LongColumn needed : {participant, system})
            if (!head_.place(needed))
                return fail(file_, fmt::format("has no column \"{}\"", nameOf(needed)),
                            fmt::format("A long table has one line per answer, with columns participant, "
                                        "system, and correct, rating or response; --column {}=NAME says what "
                                        "the file calls it. {}",
                                        nameOf(needed), columnsFound()));
        if (!head_.exported && !head_.place(correct) && !head_.place(rating) && !head_.place(response))
            return fail(file_, "has none of the columns \"correct\", \"rating\" and \"response\"",
                        "Use one of these names for the column of the answers, or give its name, as in "
                        "--column rating=NAME. " +
                            columnsFound());
        return {};
    }

    [[nodiscard]] bool isFactor(std::size_t column) const {
        const auto names = [&](const std::string& name) {
            return plainWord(name) == plainWord(titles_[column]);
        };
        return std::any_of(options_.between.begin(), options_.between.end(), names) ||
               std::any_of(options_.within.begin(), options_.within.end(), names);
    }

    Result<void> addFactor(const std::string& name, const char* option,
                           std::vector<LongHead::FactorAt>& places) {
        const std::string wanted = plainWord(name);
        const auto taken = [&](std::size_t i) {
            const auto at = [&](const LongHead::FactorAt& factor) { return factor.at == i; };
            return std::any_of(head_.between.begin(), head_.between.end(), at) ||
                   std::any_of(head_.within.begin(), head_.within.end(), at);
        };
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < head_.width; ++i) {
            if (plainWord(titles_[i]) != wanted) continue;
            if (columnNamed(names_[i]))
                return fail(file_, fmt::format("{} {}: this column already has a meaning", option, name),
                            "Name another column");
            if (found || taken(i))
                return fail(file_, fmt::format("{} {}: the column is named twice", option, name));
            found = i;
        }
        if (!found)
            return fail(file_, fmt::format("{} {}: there is no such column", option, name), columnsFound());
        places.push_back({titles_[*found], *found});
        return {};
    }

    const std::string& file_;
    char separator_;
    const LongTableOptions& options_;
    std::vector<std::string> titles_;  ///< as they stand in the file
    std::vector<std::string> names_;   ///< what they stand for
    LongHead head_;
};

}  // namespace

std::string_view nameOf(LongColumn column) {
    return long_column_names.at(static_cast<std::size_t>(column));
}

Result<LongHead> readLongHead(const CsvRecord& record, const std::string& file, char separator,
                              const LongTableOptions& options) {
    return HeadReader(record, file, separator, options).read();
}

}  // namespace deixis::results
