// Numbers that may not be known, as JSON; private to the outputs.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace deixis::results {

[[nodiscard]] inline nlohmann::ordered_json numberOrNull(bool known, double value) {
    return known ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

[[nodiscard]] inline nlohmann::ordered_json numberOrNull(const std::optional<double>& value) {
    return numberOrNull(value.has_value(), value.value_or(0.0));
}

}  // namespace deixis::results
