#include "learning/corpus/transcript.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/csv_sheet.hpp"
#include "core/foreign_csv.hpp"
#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis::learning {

namespace {

constexpr double longest_s = 24.0 * 3600.0;
constexpr double rounding_s = 0.0015;  ///< by which words of rounded times may overlap

/// Puts words behind each other: those that overlap by a rounding are parted in its middle.
Result<void> appendWord(std::vector<SpokenWord>& words, SpokenWord word, const std::string& where) {
    if (!(word.start_s >= 0.0 && word.start_s < word.end_s))
        return fail(where, fmt::format("found \"{}\" from {} to {} s, expected times that rise from 0",
                                       word.text, word.start_s, word.end_s));
    if (!words.empty() && word.start_s < words.back().end_s) {
        SpokenWord& before = words.back();
        if (before.end_s - word.start_s > rounding_s)
            return fail(where, fmt::format("found \"{}\" at {} s, before \"{}\" is over at {} s", word.text,
                                           word.start_s, before.text, before.end_s));
        before.end_s = word.start_s;
        if (!(before.start_s < before.end_s)) words.pop_back();
    }
    words.push_back(std::move(word));
    return {};
}

Result<std::size_t> findColumn(const CsvSheet& sheet, std::span<const std::string_view> names) {
    for (const std::string_view name : names)
        for (std::size_t c = 0; c < sheet.header.fields.size(); ++c)
            if (sameLetters(sheet.header.fields[c], name)) return c;
    return fail(fmt::format("{}:{}", sheet.name, sheet.header.line),
                fmt::format("found columns {}, expected one named {}", fmt::join(sheet.header.fields, ", "),
                            fmt::join(names, " or ")));
}

bool isSilence(std::string_view text) {
    constexpr std::array<std::string_view, 10> silences{"sil", "sp",    "spn",  "<p>",     "<unk>",
                                                        "#",   "<sil>", "{sl}", "[noise]", "_"};
    return text.empty() || std::ranges::any_of(silences, [&](auto one) { return sameLetters(text, one); });
}

/// Praat's text files are a row of numbers, texts in quotes and flags in <>; all other characters are
/// comments for people.
class TextGridReader {
  public:
    TextGridReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Result<std::vector<SpokenWord>> read() {
        const auto file_type = textToken(), object = textToken();
        if (file_type != "ooTextFile" || object != "TextGrid")
            return fail(name_, "found no TextGrid of Praat, expected one saved as a text file");
        const auto from = number(), to = number();
        const auto tiers = count();
        if (!from || !to || !tiers) return cutOff();
        std::vector<std::string> found;
        std::optional<std::vector<SpokenWord>> words;
        for (std::size_t t = 0; t < *tiers; ++t) {
            const auto kind = textToken(), tier = textToken();
            const auto tier_from = number(), tier_to = number();
            const auto rows = count();
            if (!kind || !tier || !tier_from || !tier_to || !rows) return cutOff();
            found.push_back(fmt::format("{} ({})", *tier, *kind));
            const bool intervals = *kind == "IntervalTier";
            const bool wanted = intervals && isWordTier(*tier);
            if (wanted && words)
                return fail(name_, fmt::format("found several tiers of words: {}", fmt::join(found, ", ")),
                            "Keep the tier \"words\" of the person who moves");
            auto read = readTier(*rows, intervals, wanted);
            if (!read) return tl::unexpected(read.error());
            if (wanted) words = std::move(*read);
        }
        if (!words)
            return fail(name_,
                        fmt::format("found tiers {}, expected an interval tier named \"words\"",
                                    found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", "))));
        return std::move(*words);
    }

  private:
    static bool isWordTier(std::string_view tier) {
        const std::string small = lowerCase(trimmed(tier));
        return small.ends_with("words") || small.ends_with("word");
    }

    [[nodiscard]] tl::unexpected<Error> cutOff() const {
        return fail(name_, "found the end of the file within a tier: it is cut off or damaged");
    }

    Result<std::vector<SpokenWord>> readTier(std::size_t count, bool intervals, bool wanted) {
        std::vector<SpokenWord> words;
        for (std::size_t i = 0; i < count; ++i) {
            const auto start_s = number(), end_s = intervals ? number() : start_s;
            const auto text = textToken();
            if (!start_s || !end_s || !text) return cutOff();
            const std::string word(trimmed(*text));
            if (!wanted || isSilence(word)) continue;
            if (auto added = appendWord(words, {word, *start_s, *end_s}, name_); !added)
                return tl::unexpected(added.error());
        }
        return words;
    }

    void skipBlanks() {
        while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '\n')) ++at_;
    }

    /// What follows: a text in quotes as it stands, or what is between blanks.
    std::optional<std::string_view> token() {
        skipBlanks();
        if (at_ >= text_.size()) return {};
        const std::size_t start = at_;
        if (text_[at_] == '!') {  // a comment to the end of the line
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (text_[at_] == '"') {
            do {
                at_ = text_.find('"', at_ + 1);
                if (at_ == std::string_view::npos) {
                    at_ = text_.size();
                    return {};
                }
                ++at_;  // two quotes are one within the text
            } while (at_ < text_.size() && text_[at_] == '"');
        } else {
            while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != '\n') ++at_;
        }
        return text_.substr(start, at_ - start);
    }

    std::optional<double> number() {
        while (const auto next = token()) {
            if (next->front() == '"') return {};
            if (const auto value = finiteNumber(*next)) return value;
        }
        return {};
    }

    /// Of tiers or intervals; none where the file has not even as many letters.
    std::optional<std::size_t> count() {
        const auto value = number();
        if (!value || *value < 0.0 || *value > static_cast<double>(text_.size())) return {};
        return static_cast<std::size_t>(*value);
    }

    std::optional<std::string> textToken() {
        while (const auto next = token()) {
            if (next->front() != '"') continue;
            std::string text(next->substr(1, next->size() - 2));
            for (std::size_t quote = text.find("\"\""); quote != std::string::npos;
                 quote = text.find("\"\"", quote + 1))
                text.erase(quote, 1);
            return text;
        }
        return {};
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
};

}  // namespace

Result<std::vector<SpokenWord>> parseWordTable(std::string bytes, const std::string& name) {
    const auto csv = readForeignCsv(std::move(bytes), name);
    if (!csv) return tl::unexpected(csv.error());
    const auto sheet = parseCsvSheet(csv->text, name, csv->form);
    if (!sheet) return tl::unexpected(sheet.error());
    constexpr std::array<std::string_view, 3> word_names{"word", "text", "label"};
    constexpr std::array<std::string_view, 4> start_names{"start_s", "start", "begin", "xmin"};
    constexpr std::array<std::string_view, 3> end_names{"end_s", "end", "xmax"};
    const auto word = findColumn(*sheet, word_names);
    const auto start = findColumn(*sheet, start_names);
    const auto end = findColumn(*sheet, end_names);
    for (const auto* column : {&word, &start, &end})
        if (!*column) return tl::unexpected(column->error());
    std::vector<SpokenWord> words;
    for (const CsvRecord& row : sheet->rows) {
        if (auto width = sheet->checkWidth(row); !width) return tl::unexpected(width.error());
        const std::string text(trimmed(row.fields[*word]));
        if (isSilence(text)) continue;
        const auto start_s = sheet->number(row, *start, "seconds", longest_s);
        const auto end_s = sheet->number(row, *end, "seconds", longest_s);
        if (!start_s) return tl::unexpected(start_s.error());
        if (!end_s) return tl::unexpected(end_s.error());
        if (auto added = appendWord(words, {text, *start_s, *end_s}, sheet->place(row)); !added)
            return tl::unexpected(added.error());
    }
    return words;
}

std::string wordTable(const std::vector<SpokenWord>& words) {
    std::string out = "word,start_s,end_s\n";
    for (const SpokenWord& word : words)
        out += fmt::format("{},{:.4f},{:.4f}\n", csvField(word.text), word.start_s, word.end_s);
    return out;
}

Result<std::vector<SpokenWord>> parseTextGrid(std::string bytes, const std::string& name) {
    const auto text = readForeignCsv(std::move(bytes), name);  // finds out the encoding
    if (!text) return tl::unexpected(text.error());
    return TextGridReader(text->text, name).read();
}

}  // namespace deixis::learning
