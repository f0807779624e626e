#include "studies/texts/language.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/text.hpp"
#include "studies/texts/language_words.hpp"
#include "studies/texts/toml_table.hpp"
#include "text_pieces.hpp"

namespace deixis::studies {

namespace {

constexpr std::size_t problems_told = 5;

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

}  // namespace deixis::studies
