#include "toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace deixis::studies {

namespace {

/// A value as an error shows it.
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

/// Line ends inside a paragraph count as spaces; a blank line parts paragraphs. So a long text can be wrapped
/// in the file and again, to the panel's width, on the panel.
std::string unwrapped(std::string_view text) {
    std::string out;
    bool new_paragraph = false;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const auto begin = line.find_first_not_of(" \t\r");
        if (begin == std::string::npos) {
            new_paragraph = true;
            continue;
        }
        if (!out.empty()) out += new_paragraph ? "\n\n" : " ";
        new_paragraph = false;
        out += line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
    }
    return out;
}

/// Levenshtein's distance.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

}  // namespace

void TomlProblems::add(std::uint32_t line, std::string_view key, std::string message, std::string mend) {
    if (first) return;
    std::string where = file;
    if (line > 0) where += fmt::format(":{}", line);
    if (!key.empty()) where += fmt::format(": {}", key);
    first = Error{std::move(where), std::move(message), std::move(mend)};
}

Result<toml::table> parseToml(const std::string& file, std::string_view bytes) {
    try {
        return toml::parse(bytes, file);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}:{}", file, error.source().begin.line),
                    fmt::format("this is not valid TOML: {}", error.description()));
    }
}

std::string proposeName(std::string_view found, std::span<const std::string_view> names) {
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(2, found.size() / 3) + 1;
    for (const std::string_view name : names) {
        const std::size_t distance = editDistance(found, name);
        if (distance < least) {
            least = distance;
            nearest = name;
        }
    }
    if (!nearest.empty()) return fmt::format("Did you mean {}?", nearest);
    return fmt::format("Known here: {}", fmt::join(names, ", "));
}

TomlTable::TomlTable(const toml::table* table, std::string prefix, std::span<const std::string_view> known,
                     TomlProblems& problems)
    : table_(table), prefix_(std::move(prefix)), known_(known.begin(), known.end()), problems_(problems) {
    if (table_ == nullptr) return;
    const toml::key* unknown = nullptr;  // the first in the file; the table itself is sorted by name
    for (const auto& [key, node] : *table_) {
        if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
        if (unknown == nullptr || key.source().begin.line < unknown->source().begin.line) unknown = &key;
    }
    if (unknown == nullptr) return;
    problems_.add(unknown->source().begin.line, dotted(unknown->str()),
                  prefix_.empty() ? "unknown section or key" : fmt::format("unknown key in [{}]", prefix_),
                  proposeName(unknown->str(), known_));
}

bool TomlTable::has(std::string_view key) const {
    return table_ != nullptr && table_->get(key) != nullptr;
}

std::string TomlTable::dotted(std::string_view key) const {
    return prefix_.empty() ? std::string(key) : fmt::format("{}.{}", prefix_, key);
}

const toml::node* TomlTable::find(std::string_view key, bool required, std::string_view expected) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end())
        throw std::logic_error(fmt::format("the loader reads '{}', which is not among the known keys", key));
    const toml::node* node = table_ != nullptr ? table_->get(key) : nullptr;
    if (node == nullptr && required) problem(key, fmt::format("missing; expected {}", expected));
    return node;
}

void TomlTable::problem(std::string_view key, std::string message, std::string mend) {
    std::uint32_t line = table_ != nullptr ? table_->source().begin.line : 0;
    if (prefix_.empty()) line = 0;  // the whole file has no line of its own
    if (has(key)) line = table_->get(key)->source().begin.line;
    problems_.add(line, dotted(key), std::move(message), std::move(mend));
}

void TomlTable::wrongType(std::string_view key, const toml::node& found, std::string_view expected) {
    problem(key, fmt::format("found {}, expected {}", describe(found), expected));
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> fallback) {
    constexpr std::string_view expected = "a text in quotes";
    const toml::node* node = find(key, !fallback, expected);
    if (node == nullptr) return fallback.value_or("");
    if (!node->is_string()) {
        wrongType(key, *node, expected);
        return {};
    }
    std::string out = unwrapped(node->as_string()->get());
    if (out.empty()) problem(key, "found an empty text, expected some words");
    return out;
}

std::vector<std::string> TomlTable::texts(std::string_view key, std::size_t least, std::size_t most) {
    const std::string expected = fmt::format("a list of {} to {} texts", least, most);
    const toml::node* node = find(key, true, expected);
    if (node == nullptr) return {};
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() < least || list->size() > most) {
        wrongType(key, *node, expected);
        return {};
    }
    std::vector<std::string> out;
    for (const toml::node& entry : *list) {
        out.push_back(entry.is_string() ? unwrapped(entry.as_string()->get()) : "");
        if (out.back().empty())
            problem(key, fmt::format("entry {} is {}, expected some words in quotes", out.size(),
                                     entry.is_string() ? "an empty text" : describe(entry)));
    }
    return out;
}

std::int64_t TomlTable::whole(std::string_view key, std::int64_t low, std::int64_t high,
                              std::optional<std::int64_t> fallback) {
    const std::string expected = high == std::numeric_limits<std::int64_t>::max()
                                     ? fmt::format("a whole number from {} up", low)
                                     : fmt::format("a whole number from {} to {}", low, high);
    const toml::node* node = find(key, !fallback, expected);
    if (node == nullptr) return fallback.value_or(low);
    const auto* value = node->as_integer();
    if (value == nullptr || value->get() < low || value->get() > high) {
        wrongType(key, *node, expected);
        return low;
    }
    return value->get();
}

double TomlTable::number(std::string_view key, double low, double high, std::optional<double> fallback) {
    const std::string expected = fmt::format("a number from {} to {}", low, high);
    const toml::node* node = find(key, !fallback, expected);
    if (node == nullptr) return fallback.value_or(low);
    const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !(*value >= low && *value <= high)) {  // not-a-number fails both
        wrongType(key, *node, expected);
        return low;
    }
    return *value;
}

bool TomlTable::flag(std::string_view key, bool fallback) {
    constexpr std::string_view expected = "true or false";
    const toml::node* node = find(key, false, expected);
    if (node == nullptr) return fallback;
    if (!node->is_boolean()) wrongType(key, *node, expected);
    return node->value<bool>().value_or(fallback);
}

std::size_t TomlTable::choice(std::string_view key, std::span<const std::string_view> names,
                              std::size_t fallback) {
    const std::string expected = fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
    const toml::node* node = find(key, false, expected);
    if (node == nullptr) return fallback;
    const std::optional<std::string_view> found = node->value_exact<std::string_view>();
    const auto place = found ? std::find(names.begin(), names.end(), *found) : names.end();
    if (place == names.end()) {
        wrongType(key, *node, expected);
        return fallback;
    }
    return static_cast<std::size_t>(place - names.begin());
}

std::pair<double, double> TomlTable::pair(std::string_view key, double low, double high) {
    const std::string expected = fmt::format("a list [a, b] of two numbers from {} to {}", low, high);
    const toml::node* node = find(key, true, expected);
    if (node == nullptr) return {low, low};
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() != 2) {
        wrongType(key, *node, expected);
        return {low, low};
    }
    double values[2] = {low, low};
    for (std::size_t i = 0; i < 2; ++i) {
        const toml::node& entry = (*list)[i];
        const std::optional<double> value = entry.is_number() ? entry.value<double>() : std::nullopt;
        if (!value || !(*value >= low && *value <= high))
            problem(key, fmt::format("entry {} is {}, expected {}", i + 1, describe(entry), expected));
        else
            values[i] = *value;
    }
    return {values[0], values[1]};
}

const toml::table* TomlTable::section(std::string_view key, bool required) {
    const std::string expected = fmt::format("a section [{}]", key);
    const toml::node* node = find(key, required, expected);
    if (node == nullptr) return nullptr;
    if (!node->is_table()) wrongType(key, *node, expected);
    return node->as_table();
}

std::vector<const toml::table*> TomlTable::sections(std::string_view key) {
    const std::string expected = fmt::format("one or more sections [[{}]], in double brackets", key);
    const toml::node* node = find(key, true, expected);
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

}  // namespace deixis::studies
