#include "core/foreign_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/text.hpp"

namespace deixis {

namespace {

/// Behind the mark. None where a character is cut off.
std::optional<std::string> fromUtf16(std::string_view bytes, bool big_end_first) {
    if (bytes.size() % 2 != 0) return std::nullopt;
    const auto unit = [&](std::size_t at) -> std::uint32_t {
        const auto first = static_cast<unsigned char>(bytes[at]);
        const auto second = static_cast<unsigned char>(bytes[at + 1]);
        return big_end_first ? first * 256U + second : second * 256U + first;
    };
    std::string out;
    for (std::size_t at = 0; at < bytes.size(); at += 2) {
        std::uint32_t character = unit(at);
        if (character >= 0xD800U && character < 0xE000U) {
            if (character >= 0xDC00U || at + 2 >= bytes.size()) return std::nullopt;
            const std::uint32_t low = unit(at += 2);
            if (low < 0xDC00U || low >= 0xE000U) return std::nullopt;
            character = 0x10000U + ((character - 0xD800U) << 10U) + (low - 0xDC00U);
        }
        appendUtf8(out, character);
    }
    return out;
}

/// None where a byte has no meaning in it.
std::optional<std::string> fromWindows1252(std::string_view bytes) {
    // 0x80 to 0x9F; the rest is Latin-1.
    constexpr std::array<std::uint16_t, 32> own{
        0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
        0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};
    std::string out;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const std::uint32_t character = byte >= 0x80U && byte < 0xA0U ? own.at(byte - 0x80U) : byte;
        if (character == 0U) return std::nullopt;
        appendUtf8(out, character);
    }
    return out;
}

/// That which the first record has most of, outside quotes; of as many, what names hold less often.
char separatorOf(std::string_view text) {
    constexpr std::array<char, 3> separators{'\t', ';', ','};
    std::array<int, 3> counts{};
    while (!text.empty() && (text.front() == '\n' || text.front() == '\r' || isCsvComment(text))) {
        if (text.starts_with("sep=") && text.size() > 4 &&
            std::find(separators.begin(), separators.end(), text[4]) != separators.end())
            return text[4];
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    }
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') quoted = !quoted;
        if (c == '\n' && !quoted) break;
        for (std::size_t i = 0; i < separators.size(); ++i)
            if (c == separators.at(i) && !quoted) ++counts.at(i);
    }
    const auto max = std::max_element(counts.begin(), counts.end());
    return *max == 0 ? ',' : separators.at(static_cast<std::size_t>(max - counts.begin()));
}

}  // namespace

Result<ForeignCsv> readForeignCsv(std::string bytes, const std::string& name) {
    ForeignCsv out;
    const auto lineOf = [&](std::size_t at) {
        return fmt::format(
            "{}:{}", name,
            1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    };
    if (bytes.starts_with("PK\x03\x04"))
        return fail(name, "is a workbook or an archive, expected text", "Save the sheet as CSV in UTF-8");
    if (const bool big = bytes.starts_with("\xFE\xFF"); big || bytes.starts_with("\xFF\xFE")) {
        auto text = fromUtf16(std::string_view(bytes).substr(2), big);
        if (!text) return fail(name, "is marked as UTF-16 but is not", "Save the file as CSV in UTF-8");
        out.text = std::move(*text);
    } else if (const auto bad = firstUnstorable(bytes); !bad) {
        out.text = std::move(bytes);
    } else {
        auto text = fromWindows1252(bytes);
        if (!text)
            return fail(lineOf(*bad),
                        fmt::format("found the byte {:#04x}, which is not UTF-8 text",
                                    static_cast<unsigned char>(bytes[*bad])),
                        "Save the file as CSV in UTF-8");
        const auto first = std::find_if(text->begin(), text->end(),
                                        [](char c) { return static_cast<unsigned char>(c) >= 0x80U; });
        out.taken_for_windows_1252.assign(first,
                                          std::find_if_not(first + 1, text->end(), continuesCharacter));
        out.text = std::move(*text);
    }
    if (out.text.starts_with("\xEF\xBB\xBF")) out.text.erase(0, 3);
    if (out.text.find('\n') == std::string::npos) std::replace(out.text.begin(), out.text.end(), '\r', '\n');
    out.form = {separatorOf(out.text), true};
    return out;
}

std::optional<std::string> decimalCommaAsPoint(std::string_view number) {
    const auto comma = number.find(',');
    if (comma == std::string_view::npos || comma == 0 || comma + 1 == number.size()) return std::nullopt;
    const std::size_t sign = number.front() == '-' ? 1 : 0;
    for (std::size_t i = sign; i < number.size(); ++i)
        if (i != comma && !isDigit(number[i])) return std::nullopt;
    if (comma == sign) return std::nullopt;
    std::string out(number);
    out[comma] = '.';
    return out;
}

}  // namespace deixis
