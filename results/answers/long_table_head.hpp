// The first line of a long table: which column holds what; private to its reader.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/csv.hpp"
#include "results/answers/long_table.hpp"

namespace deixis::results {

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
    marked,
    status,
    station,
    other_system,
    scale_low,
    scale_high,
    author_trial
};
constexpr std::size_t long_column_count = static_cast<std::size_t>(LongColumn::author_trial) + 1;

[[nodiscard]] std::string_view nameOf(LongColumn column);

/// Columns of an export's responses.csv that mean something else in a long table, or nothing.
enum class ExportColumnOf : std::size_t {
    participant_status,
    kind,
    question,
    scored,
    value,
    chosen_place,
    check_kind,
    check_passed,
    measure,
    correct,
    status
};
constexpr std::size_t export_column_count = static_cast<std::size_t>(ExportColumnOf::status) + 1;

/// Places are those of fields in a record.
struct LongHead {
    struct FactorAt {
        std::string name;
        std::size_t at = 0;
    };

    std::array<std::optional<std::size_t>, long_column_count> places{};
    std::vector<FactorAt> between{};
    std::vector<FactorAt> within{};
    std::size_t width = 0;
    double rt_unit_s = 1.0;
    std::vector<std::string> unread{};  ///< columns that mean nothing here
    /// Of responses.csv, whose measure, correct, rating, status and excluded stand behind the fields of a
    /// record, where the reader puts them; none: the file is another one.
    std::optional<std::array<std::size_t, export_column_count>> exported{};

    [[nodiscard]] std::optional<std::size_t> place(LongColumn column) const {
        return places[static_cast<std::size_t>(column)];
    }
    [[nodiscard]] std::size_t place(ExportColumnOf column) const {
        return exported->at(static_cast<std::size_t>(column));
    }
};

/// Fails where a column that is needed or asked for is missing, or stands twice. `file` is named in errors.
[[nodiscard]] Result<LongHead> readLongHead(const CsvRecord& record, const std::string& file, char separator,
                                            const LongTableOptions& options);

}  // namespace deixis::results
