// The name that was probably meant by a mistyped one.
#pragma once

#include <span>
#include <string_view>

namespace deixis {

/// The name nearest to `found`; empty if none is near.
[[nodiscard]] std::string_view nearestName(std::string_view found, std::span<const std::string_view> names);

}  // namespace deixis
