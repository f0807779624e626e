// The text of a request as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.hpp"

namespace deixis::server {

/// Lists and objects within one another.
inline constexpr int max_json_depth = 32;

/// Strictly RFC 8259 in UTF-8. A name that stands twice in an object is an error, as is what lies deeper than
/// `max_json_depth`. Errors name the field where there is one, else nothing.
[[nodiscard]] Result<nlohmann::json> parseJsonText(std::string_view text);

}  // namespace deixis::server
