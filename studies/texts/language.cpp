#include "studies/texts/language.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "core/text.hpp"
#include "studies/texts/language_words.hpp"
#include "studies/texts/toml_table.hpp"

namespace deixis::studies {

namespace {

constexpr std::size_t problems_told = 5;

/// A piece of a text: plain, or the name of a placeholder.
struct Piece {
    std::string_view text;
    bool placeholder = false;
};

/// A brace that is never closed begins a plain piece.
std::vector<Piece> piecesOf(std::string_view text) {
    std::vector<Piece> pieces;
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t open = text.find('{', from);
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) break;
        if (open > from) pieces.push_back({text.substr(from, open - from)});
        pieces.push_back({text.substr(open + 1, close - open - 1), true});
        from = close + 1;
    }
    if (from < text.size()) pieces.push_back({text.substr(from)});
    return pieces;
}

/// The names of a text's placeholders, each once, sorted.
std::vector<std::string_view> placeholdersOf(std::string_view text) {
    std::vector<std::string_view> names;
    for (const Piece& piece : piecesOf(text))
        if (piece.placeholder) names.push_back(piece.text);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

std::string listed(const std::vector<std::string_view>& placeholders) {
    if (placeholders.empty()) return "none";
    return fmt::format("{{{}}}", fmt::join(placeholders, "}, {"));
}

struct Problem {
    std::uint32_t line = 0;  ///< 0: of the whole table
    std::string_view key;
    std::string message;
    std::string hint{};
};

/// What is wrong with the text of a key, if anything.
void checkText(std::string_view key, std::string_view english, const toml::node& node,
               std::vector<Problem>& problems) {
    const std::uint32_t line = node.source().begin.line;
    const auto* text = node.as_string();
    if (text == nullptr) {
        problems.push_back({line, key, "this must be a text in quotation marks"});
        return;
    }
    if (trimmed(text->get()).empty()) {
        problems.push_back({line, key, fmt::format("the text is empty; in English it is \"{}\"", english)});
        return;
    }
    if (const auto why = notDrawn(text->get())) {
        problems.push_back({line, key, why->message, why->hint});
        return;
    }
    const auto found = placeholdersOf(text->get());
    const auto expected = placeholdersOf(english);
    if (found != expected)
        problems.push_back({line, key,
                            fmt::format("the placeholders of this text are {}, but must be {}", listed(found),
                                        listed(expected))});
}

/// One error that tells the first problem in full and names the next few.
Error errorOf(const std::string& file, std::string_view prefix, std::vector<Problem> problems) {
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
        return (a.line == 0 ? UINT32_MAX : a.line) < (b.line == 0 ? UINT32_MAX : b.line);
    });
    const auto place = [&](const Problem& problem) {
        return problem.line > 0 ? fmt::format(":{}: {}{}", problem.line, prefix, problem.key)
                                : fmt::format(": {}{}", prefix, problem.key);
    };
    const Problem& first = problems.front();
    Error error{file + place(first), first.message, first.hint};
    const std::size_t told = std::min(problems.size(), problems_told);
    for (std::size_t i = 1; i < told; ++i) {
        const Problem& next = problems[i];
        error.message += next.line > 0
                             ? fmt::format("{} line {}, {}: {}", i == 1 ? "; also" : ";", next.line, next.key,
                                           next.message)
                             : fmt::format("{} {}: {}", i == 1 ? "; also" : ";", next.key, next.message);
    }
    if (problems.size() > told) error.message += fmt::format("; and {} more", problems.size() - told);
    return error;
}

constexpr std::string_view status_key = "status";
constexpr std::string_view former_key = "sitting_over_text";  ///< session_over_text in older files

TextStatus readStatus(const toml::table& table, std::vector<Problem>& problems) {
    const toml::node* node = table.get(status_key);
    if (node == nullptr) return TextStatus::unstated;
    const auto* name = node->as_string();
    const auto status = name != nullptr ? textStatusFromName(name->get()) : std::nullopt;
    if (status) return *status;
    problems.push_back(
        {node->source().begin.line, status_key,
         fmt::format("found {}, expected \"written\", \"translated\" or \"reviewed\"", describe(*node))});
    return TextStatus::unstated;
}

/// A key, or the name that it had before.
const toml::node* wordsUnder(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    return node == nullptr && key == "session_over_text" ? table.get(former_key) : node;
}

}  // namespace

std::optional<TextStatus> textStatusFromName(std::string_view name) {
    if (name == "written") return TextStatus::written;
    if (name == "translated") return TextStatus::translated;
    if (name == "reviewed") return TextStatus::reviewed;
    return std::nullopt;
}

std::string_view textStatusText(TextStatus status) {
    switch (status) {
        case TextStatus::written:
            return "written in this language";
        case TextStatus::translated:
            return "translated, not reviewed by a native speaker";
        case TextStatus::reviewed:
            return "translated, reviewed by a native speaker";
        case TextStatus::unstated:
            break;
    }
    return "not stated whether a native speaker reviewed them";
}

Result<LanguageTable> readWords(const toml::table& table, const std::string& file, std::string_view prefix,
                                const std::string& code, const LanguageTable* base) {
    std::vector<Problem> problems;
    LanguageTable::Texts texts;
    std::vector<std::string_view> known{status_key, former_key};
    for (const auto& [key, english] : languageKeys()) {
        known.push_back(key);
        const toml::node* node = wordsUnder(table, key);
        if (node == nullptr) {
            if (base != nullptr)
                texts.emplace_back(key, (*base)(key));
            else
                problems.push_back(
                    {0, key, fmt::format("this key is missing; in English it is \"{}\"", english)});
            continue;
        }
        checkText(key, english, *node, problems);
        if (const auto* text = node->as_string()) texts.emplace_back(key, text->get());
    }
    for (const auto& [key, node] : table)
        if (std::find(known.begin(), known.end(), key.str()) == known.end())
            problems.push_back(
                {key.source().begin.line, key.str(), "unknown key", proposeName(key.str(), known)});
    TextStatus status = readStatus(table, problems);
    if (!problems.empty()) return tl::unexpected(errorOf(file, prefix, std::move(problems)));
    if (base != nullptr && status == TextStatus::unstated) status = base->status();
    return LanguageTable(code, status, std::move(texts));
}

LanguageTable::LanguageTable(std::string code, TextStatus status, Texts texts)
    : code_(std::move(code)), status_(status), texts_(std::move(texts)) {
    std::sort(texts_.begin(), texts_.end());
}

Result<LanguageTable> LanguageTable::load(const std::filesystem::path& file) {
    const auto table = readToml(file);
    if (!table) return tl::unexpected(table.error());
    return readWords(*table, file.string(), "", file.stem().string());
}

Result<LanguageTable> LanguageTable::loadKept(const std::filesystem::path& file,
                                              const std::filesystem::path& today) {
    const auto table = readToml(file);
    if (!table) return tl::unexpected(table.error());
    const auto now = load(today);
    const LanguageTable& base = now ? *now : english();
    std::vector<Problem> problems;
    Texts texts;
    for (const auto& [key, english_text] : languageKeys()) {
        const toml::node* node = wordsUnder(*table, key);
        problems.clear();
        if (node != nullptr) checkText(key, english_text, *node, problems);
        const bool fits = node != nullptr && problems.empty();
        texts.emplace_back(key, fits ? node->as_string()->get() : base(key));
    }
    problems.clear();
    const TextStatus status = readStatus(*table, problems);
    return LanguageTable(file.stem().string(), status, std::move(texts));
}

const LanguageTable& LanguageTable::english() {
    static const LanguageTable table("en", TextStatus::written,
                                     Texts(languageKeys().begin(), languageKeys().end()));
    return table;
}

const std::string& LanguageTable::operator()(std::string_view key) const {
    const auto at =
        std::lower_bound(texts_.begin(), texts_.end(), key,
                         [](const auto& text, std::string_view wanted) { return text.first < wanted; });
    if (at == texts_.end() || at->first != key)
        throw std::out_of_range(fmt::format("the language table '{}' has no key '{}'", code_, key));
    return at->second;
}

std::string LanguageTable::operator()(
    std::string_view key, const std::vector<std::pair<std::string_view, std::string>>& values) const {
    std::string out;
    for (const Piece& piece : piecesOf((*this)(key))) {
        if (!piece.placeholder) {
            out += piece.text;
            continue;
        }
        const auto value = std::find_if(values.begin(), values.end(),
                                        [&](const auto& one) { return one.first == piece.text; });
        if (value == values.end())
            throw std::invalid_argument(fmt::format("'{}' has no value for '{}'", key, piece.text));
        out += value->second;
    }
    return out;
}

std::string LanguageTable::seconds(std::string_view key, std::string_view one, int seconds) const {
    return seconds == 1 ? (*this)(one) : (*this)(key, {{"seconds", std::to_string(seconds)}});
}

}  // namespace deixis::studies
