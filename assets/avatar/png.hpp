// Writing pictures as PNG (ISO/IEC 15948).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace deixis::assets {

/// `rgba`: 4 bytes a pixel, rows from the top.
[[nodiscard]] std::string pngBytes(int width, int height, const std::vector<std::uint8_t>& rgba);

}  // namespace deixis::assets
