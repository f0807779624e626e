// Comparing tokens.
#pragma once

#include <string>
#include <string_view>

namespace deixis::server {

/// In a time that does not tell how much of it is right.
[[nodiscard]] bool sameSecret(std::string_view a, std::string_view b);

/// Whether a text can be a token: such letters that stand unchanged in a header, a cookie and an address.
[[nodiscard]] bool canBeToken(std::string_view text);

}  // namespace deixis::server
