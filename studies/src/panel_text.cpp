#include <algorithm>

#include "panel_layout.hpp"

namespace deixis::studies {

namespace {

constexpr double space_em = 0.25;

bool among(char32_t c, std::string_view characters) {
    return c < 0x80 && characters.find(static_cast<char>(c)) != std::string_view::npos;
}

/// Hangul, CJK and full-width forms, which are about square (the wide ones of Unicode's East Asian Width).
bool isWide(char32_t c) {
    return (c >= 0x1100 && c <= 0x115F) || (c >= 0x2E80 && c <= 0xA4CF) || (c >= 0xA960 && c <= 0xA97F) ||
           (c >= 0xAC00 && c <= 0xD7FF) || (c >= 0xF900 && c <= 0xFAFF) || (c >= 0xFE30 && c <= 0xFE6F) ||
           (c >= 0xFF00 && c <= 0xFF60) || (c >= 0xFFE0 && c <= 0xFFE6) || (c >= 0x1F300 && c <= 0x1FAFF) ||
           (c >= 0x20000 && c <= 0x3FFFD);
}

/// Of a line's height: sans-serif fonts, with some room.
double widthOf(char32_t c) {
    if (isWide(c)) return 0.8;
    if (among(c, " ijlI.,:;'!|()[]")) return space_em;
    if (among(c, "fcrstzJ-/\"")) return 0.36;
    if (among(c, "mwMW@%")) return 0.7;
    return among(c, "ABCDGHKNOQRUVX") ? 0.56 : 0.46;
}

/// The next code point of UTF-8; a broken byte counts as one.
char32_t next(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(at++);
    int more = 0;
    char32_t c = lead;
    if (lead >= 0xF0) {
        more = 3;
        c = lead & 0x07U;
    } else if (lead >= 0xE0) {
        more = 2;
        c = lead & 0x0FU;
    } else if (lead >= 0xC0) {
        more = 1;
        c = lead & 0x1FU;
    }
    for (; more > 0 && at < text.size() && (byte(at) & 0xC0U) == 0x80U; --more)
        c = (c << 6U) | (byte(at++) & 0x3FU);
    return c;
}

/// Lines and what is used of the last one, as parts of a line's height.
struct Wrap {
    double fits;
    int lines = 1;
    double used = 0.0;

    void word(std::string_view word) {
        const double width = estimateWidth(word, 1.0);
        if (used > 0.0 && used + space_em + width > fits) {
            ++lines;
            used = 0.0;
        }
        if (width > fits) {  // broken anywhere
            for (std::size_t at = 0; at < word.size();) {
                const double character = widthOf(next(word, at));
                if (used > 0.0 && used + character > fits) {
                    ++lines;
                    used = 0.0;
                }
                used += character;
            }
            return;
        }
        used += width + (used > 0.0 ? space_em : 0.0);
    }
};

}  // namespace

double estimateWidth(std::string_view text, double size_m) {
    double em = 0.0;
    for (std::size_t at = 0; at < text.size();) em += widthOf(next(text, at));
    return em * size_m;
}

int estimateLines(std::string_view text, double size_m, double width_m) {
    int lines = 0;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t stop = std::min(text.find('\n', start), text.size());
        const std::string_view paragraph = text.substr(start, stop - start);
        Wrap wrap{width_m / size_m + 1e-9};
        std::size_t word_start = 0;
        while (word_start < paragraph.size()) {
            const std::size_t word_stop = std::min(paragraph.find(' ', word_start), paragraph.size());
            wrap.word(paragraph.substr(word_start, word_stop - word_start));
            word_start = word_stop + 1;
        }
        lines += wrap.lines;
        start = stop + 1;
    }
    return lines;
}

}  // namespace deixis::studies
