#include "png.hpp"

#include <zlib.h>

#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace deixis::assets {

namespace {

constexpr std::size_t rgba_bytes = 4;

void appendBigEndian(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>((value >> shift) & 0xFFU);
}

void appendChunk(std::string& out, std::string_view name, std::string_view content) {
    appendBigEndian(out, static_cast<std::uint32_t>(content.size()));
    const std::string checked = std::string(name) + std::string(content);
    out += checked;
    appendBigEndian(out, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                                                          static_cast<uInt>(checked.size()))));
}

/// Filter 4 of the standard: of left, above and left above the one nearest to left + above - left above.
std::uint8_t paeth(int left, int above, int corner) {
    const int to_left = std::abs(above - corner);
    const int to_above = std::abs(left - corner);
    const int to_corner = std::abs(left + above - 2 * corner);
    if (to_left <= to_above && to_left <= to_corner) return static_cast<std::uint8_t>(left);
    return static_cast<std::uint8_t>(to_above <= to_corner ? above : corner);
}

std::string filteredRows(std::size_t width, std::size_t height, const std::vector<std::uint8_t>& rgba) {
    constexpr char paeth_filter = 4;
    const std::size_t row_bytes = rgba_bytes * width;
    std::string out;
    out.reserve((row_bytes + 1) * height);
    for (std::size_t y = 0; y < height; ++y) {
        out += paeth_filter;
        const std::uint8_t* const row = rgba.data() + y * row_bytes;
        const std::uint8_t* const before = y > 0 ? row - row_bytes : nullptr;
        for (std::size_t x = 0; x < row_bytes; ++x) {
            const bool first = x < rgba_bytes;
            const int left = first ? 0 : row[x - rgba_bytes];
            const int above = before == nullptr ? 0 : before[x];
            const int corner = first || before == nullptr ? 0 : before[x - rgba_bytes];
            out += static_cast<char>(static_cast<std::uint8_t>(row[x] - paeth(left, above, corner)));
        }
    }
    return out;
}

}  // namespace

std::string pngBytes(int width, int height, const std::vector<std::uint8_t>& rgba) {
    constexpr int level = 4;
    const std::string rows =
        filteredRows(static_cast<std::size_t>(width), static_cast<std::size_t>(height), rgba);
    uLongf size = compressBound(rows.size());
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
                  rows.size(), level) != Z_OK)
        throw std::runtime_error("zlib cannot compress a picture");
    packed.resize(size);

    std::string head;
    appendBigEndian(head, static_cast<std::uint32_t>(width));
    appendBigEndian(head, static_cast<std::uint32_t>(height));
    head += std::string("\x08\x06\x00\x00\x00", 5);  // 8 bits each of red, green, blue, alpha
    std::string out = "\x89PNG\r\n\x1A\n";
    appendChunk(out, "IHDR", head);
    appendChunk(out, "IDAT", packed);
    appendChunk(out, "IEND", "");
    return out;
}

}  // namespace deixis::assets
