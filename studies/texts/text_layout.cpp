#include "studies/texts/text_layout.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "text_advances.hpp"

namespace deixis::studies {

namespace {

// What Open Sans lacks is drawn in the Hangul face: 0.86 of the size, and all of its wide characters are 892
// of 1149 units wide. A character that neither has is drawn as a question mark, which is narrower.
constexpr double hangul_em = 0.86 * 892.0 / 1149.0;
constexpr char32_t first_direct = 0x20;
constexpr char32_t last_direct = 0x7E;

double widthOf(char32_t c, bool bold) {
    const auto em = [bold](const TextAdvance& advance) {
        return static_cast<double>(bold ? advance.bold : advance.regular) / advance_units;
    };
    if (c >= first_direct && c <= last_direct) return em(text_advances[c - first_direct]);
    const auto found = std::lower_bound(
        text_advances.begin(), text_advances.end(), c,
        [](const TextAdvance& advance, char32_t character) { return advance.character < character; });
    return found != text_advances.end() && found->character == c ? em(*found) : hangul_em;
}

struct Wrapping {
    double size_m;
    double width_m;
    bool bold;

    [[nodiscard]] bool fits(std::string_view line) const {
        constexpr double rounding = 1e-9;
        return studies::textWidth(line, size_m, bold) <= width_m + rounding;
    }

    /// Bytes of a word that go on a line of their own; at least one character.
    [[nodiscard]] std::size_t cut(std::string_view word) const {
        std::size_t end = 0;
        (void)nextCharacter(word, end);
        for (std::size_t longer = end; longer < word.size(); end = longer) {
            (void)nextCharacter(word, longer);
            if (!fits(word.substr(0, longer))) break;
        }
        return end;
    }

    /// Bytes of a paragraph's beginning that go on its first line.
    [[nodiscard]] std::size_t lineOf(std::string_view text) const {
        std::size_t end = 0;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t stop = std::min(text.find(' ', at), text.size());
            if (!fits(text.substr(0, stop))) return end > 0 ? end : cut(text.substr(0, stop));
            end = stop;
            at = std::min(text.find_first_not_of(' ', stop), text.size());
        }
        return end;
    }
};

}  // namespace

double textWidth(std::string_view text, double size_m, bool bold) {
    double em = 0.0;
    for (std::size_t at = 0; at < text.size();) em += widthOf(nextCharacter(text, at), bold);
    return em * size_m;
}

double widestWord(std::string_view text, double size_m, bool bold) {
    double widest_m = 0.0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find_first_of(" \n", from), text.size());
        widest_m = std::max(widest_m, textWidth(text.substr(from, to - from), size_m, bold));
        from = to + 1;
    }
    return widest_m;
}

std::vector<std::string> wrapText(std::string_view text, double size_m, double width_m, bool bold) {
    const Wrapping wrapping{size_m, width_m, bold};
    const auto trimmed = [](std::string_view rest) {
        return rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
    };
    std::vector<std::string> lines;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t stop = std::min(text.find('\n', start), text.size());
        std::string_view rest = trimmed(text.substr(start, stop - start));
        do {
            const std::size_t end = wrapping.lineOf(rest);
            lines.emplace_back(rest.substr(0, end));
            rest = trimmed(rest.substr(end));
        } while (!rest.empty());
        start = stop + 1;
    }
    return lines;
}

}  // namespace deixis::studies
