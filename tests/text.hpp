// Looking into texts.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace deixis::tests {

[[nodiscard]] inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// A text of one paragraph as it was before it was laid out in lines.
[[nodiscard]] inline std::string unwrapped(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace deixis::tests
