// Characters, whatever the locale.
#pragma once

namespace deixis {

[[nodiscard]] constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace deixis
