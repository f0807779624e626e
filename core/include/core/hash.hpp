// Content hashes: what was shown and which study it was, identified by its bytes.
#pragma once

#include <string>
#include <string_view>

namespace deixis {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256Hex(std::string_view bytes);

}  // namespace deixis
