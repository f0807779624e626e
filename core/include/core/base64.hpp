// Bytes as text (RFC 4648, section 4).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace deixis {

/// None where a character is no digit of base64; "=" at the end may be left out.
[[nodiscard]] std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace deixis
