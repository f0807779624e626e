// Numbers written by people and files: the one place that decides what a number is.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace deixis {

/// The number that the whole text is, such as "0.5", "-2" or "1e-3". None for anything else: nan, inf,
/// numbers beyond double's range, hexadecimal ones, a leading '+', spaces, anything behind the number.
[[nodiscard]] std::optional<double> finiteNumber(std::string_view text);

/// The whole number, in decimal digits, that the whole text is; likewise.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(std::string_view text);
/// The same from 0 on.
[[nodiscard]] std::optional<std::uint64_t> naturalNumber(std::string_view text);

}  // namespace deixis
