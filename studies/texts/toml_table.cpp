#include "studies/texts/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "core/files.hpp"
#include "core/text.hpp"
#include "studies/texts/study_texts.hpp"

namespace deixis::studies {

std::string describe(const toml::node& node) {
    if (const auto* value = node.as_string()) {
        constexpr std::size_t shown = 40;
        const std::string& text = value->get();
        return text.size() <= shown ? fmt::format("the text \"{}\"", text) : "a long text";
    }
    if (const auto* value = node.as_integer()) return fmt::format("the whole number {}", value->get());
    if (const auto* value = node.as_floating_point()) return fmt::format("the number {}", value->get());
    if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
    if (const auto* value = node.as_array()) return fmt::format("a list of {}", value->size());
    if (node.is_table()) return "a table";
    return "a date or time";
}

std::string unwrapped(std::string_view text) {
    std::string out;
    bool new_paragraph = false;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const std::string_view words = trimmed(line);
        if (words.empty()) {
            new_paragraph = true;
            continue;
        }
        if (!out.empty()) out += new_paragraph ? "\n\n" : " ";
        new_paragraph = false;
        out += words;
    }
    return out;
}

bool isName(std::string_view text) {
    constexpr std::size_t longest = 48;
    return !text.empty() && text.size() <= longest && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

void Problems::add(toml::source_position at, std::string_view key, std::string message, std::string hint) {
    std::string where = file_;
    if (at.line > 0) where += fmt::format(":{}", at.line);
    if (!key.empty()) where += fmt::format(": {}", key);
    found_.push_back({at, Error{std::move(where), std::move(message), std::move(hint)}});
}

void Problems::add(toml::source_position at, std::vector<Error> others) {
    for (Error& error : others) found_.push_back({at, std::move(error)});
}

std::vector<Error> Problems::sorted() const {
    std::vector<Found> ordered = found_;
    std::stable_sort(ordered.begin(), ordered.end(), [](const Found& a, const Found& b) {
        return a.at.line != b.at.line ? a.at.line < b.at.line : a.at.column < b.at.column;
    });
    std::vector<Error> out;
    for (Found& found : ordered) out.push_back(std::move(found.error));
    return out;
}

namespace {

/// Where a text or key holds a NUL ("\u0000"), which TOML allows and no database does.
std::optional<std::uint32_t> lineOfNul(const toml::node& node) {
    if (const auto* text = node.as_string(); text != nullptr && text->get().find('\0') != std::string::npos)
        return node.source().begin.line;
    if (const auto* list = node.as_array())
        for (const toml::node& entry : *list)
            if (const auto line = lineOfNul(entry)) return line;
    if (const auto* table = node.as_table())
        for (const auto& [key, entry] : *table) {
            if (key.str().find('\0') != std::string_view::npos) return key.source().begin.line;
            if (const auto line = lineOfNul(entry)) return line;
        }
    return std::nullopt;
}

}  // namespace

Result<toml::table> parseToml(const std::string& file, std::string_view bytes) {
    try {
        toml::table table = toml::parse(bytes, file);
        if (const auto line = lineOfNul(table))
            return fail(fmt::format("{}:{}", file, *line),
                        "found the character U+0000 in a text, which cannot be stored in a database",
                        "Remove it");
        return table;
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}:{}", file, error.source().begin.line),
                    fmt::format("this is not valid TOML: {}", error.description()));
    }
}

Result<toml::table> readToml(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return parseToml(path.string(), *bytes);
}

std::string proposeName(std::string_view found, std::span<const std::string_view> names) {
    const std::string_view nearest = nearestName(found, names);
    if (!nearest.empty()) return fmt::format("Did you mean {}?", nearest);
    return fmt::format("Known here: {}", fmt::join(names, ", "));
}

TomlTable::TomlTable(const toml::table* table, std::string prefix, Names known, Problems& problems,
                     TextBook& texts)
    : table_(table),
      prefix_(std::move(prefix)),
      known_(known.begin(), known.end()),
      problems_(&problems),
      texts_(&texts) {
    if (table_ == nullptr) return;
    std::vector<std::string_view> missing;  // what a mistyped key may have been meant to be
    std::copy_if(known_.begin(), known_.end(), std::back_inserter(missing),
                 [this](std::string_view key) { return !has(key); });
    for (const auto& [key, node] : *table_) {
        if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
        const std::string_view nearest = nearestName(key.str(), missing);
        if (!nearest.empty()) meant_.emplace(nearest);
        problems_->add(
            key.source().begin, dotted(key.str()), prefix_.empty() ? "unknown section or key" : "unknown key",
            nearest.empty() ? proposeName(key.str(), known_) : fmt::format("Did you mean {}?", nearest));
    }
}

bool TomlTable::has(std::string_view key) const {
    return table_ != nullptr && table_->get(key) != nullptr;
}

std::vector<std::string_view> TomlTable::keys() const {
    std::vector<std::string_view> out;
    if (table_ != nullptr)
        for (const auto& [key, node] : *table_) out.push_back(key.str());
    return out;
}

std::string TomlTable::dotted(std::string_view key) const {
    return prefix_.empty() ? std::string(key) : fmt::format("{}.{}", prefix_, key);
}

TomlTable TomlTable::below(std::string_view key, const toml::table* table, Names known) const {
    return {table, dotted(key), known, *problems_, *texts_};
}

const toml::node* TomlTable::find(std::string_view key, bool required, std::string_view expected) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end())
        throw std::logic_error(fmt::format("the loader reads '{}', which is not a known key", key));
    if (table_ == nullptr) return nullptr;
    const toml::node* node = table_->get(key);
    if (node != nullptr || !required) return node;
    if (meant_.count(key) > 0)
        bad_.emplace(key);  // told already, with the proposal
    else
        problem(key, fmt::format("missing; expected {}", expected));
    return nullptr;
}

toml::source_position TomlTable::place(std::string_view key) const {
    if (has(key)) return table_->get(key)->source().begin;
    if (table_ == nullptr || prefix_.empty()) return {};  // the whole file has no line of its own
    return table_->source().begin;
}

void TomlTable::problem(std::string_view key, std::string message, std::string hint) {
    bad_.emplace(key);
    problems_->add(place(key), dotted(key), std::move(message), std::move(hint));
}

void TomlTable::problemAt(std::string_view key, std::size_t index, std::string message, std::string hint) {
    bad_.emplace(key);
    const toml::array* list = has(key) ? table_->get(key)->as_array() : nullptr;
    const toml::node* entry = list != nullptr ? list->get(index) : nullptr;
    problems_->add(entry != nullptr ? entry->source().begin : place(key), dotted(key), std::move(message),
                   std::move(hint));
}

void TomlTable::problemAt(std::string_view key, std::string_view name, std::string message,
                          std::string hint) {
    bad_.emplace(key);
    const toml::table* table = has(key) ? table_->get(key)->as_table() : nullptr;
    const toml::node* entry = table != nullptr ? table->get(name) : nullptr;
    problems_->add(entry != nullptr ? entry->source().begin : place(key),
                   dotted(fmt::format("{}.{}", key, name)), std::move(message), std::move(hint));
}

void TomlTable::reject(std::string_view key, std::string_view why) {
    if (has(key)) problem(key, fmt::format("found a value, expected no {} {}", key, why), "Remove it");
}

void TomlTable::wrongType(std::string_view key, const toml::node& found, std::string_view expected) {
    problem(key, fmt::format("found {}, expected {}", describe(found), expected));
}

std::vector<const toml::table*> TomlTable::sections(std::string_view key, bool required) {
    const std::string expected = fmt::format("one or more sections [[{}]], in double brackets", dotted(key));
    const toml::node* node = find(key, required, expected);
    if (node == nullptr) return {};
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty() || !list->is_homogeneous<toml::table>()) {
        wrongType(key, *node, expected);
        return {};
    }
    std::vector<const toml::table*> out;
    for (const toml::node& entry : *list) out.push_back(entry.as_table());
    return out;
}

const toml::table* TomlTable::section(std::string_view key, bool required) {
    const std::string expected = fmt::format("a section [{}]", dotted(key));
    const toml::node* node = find(key, required, expected);
    if (node == nullptr) return nullptr;
    if (!node->is_table()) wrongType(key, *node, expected);
    return node->as_table();
}

}  // namespace deixis::studies
