// The first line of a long table: which column holds what; private to its reader.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/csv.hpp"
#include "results/long_table.hpp"

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
    station
};
constexpr std::size_t long_column_count = static_cast<std::size_t>(LongColumn::station) + 1;

[[nodiscard]] std::string_view nameOf(LongColumn column);

/// Places are those of fields in a record.
struct LongHead {
    std::array<std::optional<std::size_t>, long_column_count> places{};
    std::vector<std::size_t> between{};  ///< of FactorColumns::between, in its order
    std::vector<std::size_t> within{};
    std::size_t width = 0;
    std::vector<std::string> unread{};  ///< columns that mean nothing here

    [[nodiscard]] std::optional<std::size_t> place(LongColumn column) const {
        return places[static_cast<std::size_t>(column)];
    }
};

/// Fails where a column that is needed or asked for is missing, or stands twice. `file` is named in errors.
[[nodiscard]] Result<LongHead> readLongHead(const CsvRecord& record, const std::string& file,
                                            const FactorColumns& factors);

}  // namespace deixis::results
