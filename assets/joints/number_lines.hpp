// Tables of numbers as text, which core/csv.hpp reads: how their fields are parted, and what is a number.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/csv.hpp"

namespace deixis::assets {

/// The first line that is not empty, without blanks around it; empty where there is none.
[[nodiscard]] std::string_view firstLine(std::string_view text);

/// Fields without blanks around them, separated as those of the first line are: by tabs, semicolons, commas,
/// or else blanks.
[[nodiscard]] CsvForm formOfNumbers(std::string_view text);

/// The field as a finite number; none where it is anything else.
[[nodiscard]] std::optional<double> finiteNumber(std::string_view field);

/// What may help where a field is no number: a word on decimal commas where it has one, else empty.
[[nodiscard]] std::string hintOfNumber(std::string_view field);

}  // namespace deixis::assets
