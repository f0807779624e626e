// What TomlTable reads from single values and lists.
#include <fmt/format.h>

#include <algorithm>

#include "studies/texts/study_texts.hpp"
#include "studies/texts/toml_table.hpp"

namespace deixis::studies {

std::string TomlTable::note(std::string_view key, std::optional<std::string> fallback) {
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

std::string TomlTable::textOf(std::string_view key, const toml::node& node) {
    return texts_->resolve(node.as_string()->get(), node.source().begin, dotted(key));
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> fallback) {
    constexpr std::string_view expected = "a text in quotes";
    const toml::node* node = find(key, !fallback, expected);
    if (node == nullptr) return fallback.value_or("");
    if (node->is_string()) return textOf(key, *node);
    wrongType(key, *node, expected);
    return {};
}

std::vector<std::string> TomlTable::texts(std::string_view key) {
    const toml::node* node = find(key, false, "");
    if (node == nullptr) return {};
    std::vector<std::string> out;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        wrongType(key, *node, "a list of texts");
        return {};
    }
    for (const toml::node& entry : *list) {
        if (entry.is_string())
            out.push_back(textOf(key, entry));
        else
            problemAt(
                key, out.size(),
                fmt::format("entry {} is {}, expected a text in quotes", out.size() + 1, describe(entry)));
        if (!entry.is_string()) out.emplace_back();
    }
    return out;
}

std::string TomlTable::name(std::string_view key, std::optional<std::string> fallback) {
    constexpr std::string_view expected = "a name of 1 to 48 letters A-Z a-z, digits, '-' and '_'";
    const toml::node* node = find(key, !fallback, expected);
    if (node == nullptr) return fallback.value_or("");
    if (!node->is_string() || !isName(node->as_string()->get())) {
        wrongType(key, *node, expected);
        return {};
    }
    return node->as_string()->get();
}

std::vector<std::string> TomlTable::names(std::string_view key, std::size_t min, bool required,
                                          bool repeats) {
    const std::string expected = fmt::format("a list of {} or more names", min);
    const toml::node* node = find(key, required, expected);
    if (node == nullptr) return {};
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() < min) {
        wrongType(key, *node, expected);
        return {};
    }
    std::vector<std::string> out;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const toml::node& entry = (*list)[i];
        if (!entry.is_string() || !isName(entry.as_string()->get())) {
            problemAt(key, i,
                      fmt::format("entry {} is {}, expected a name in quotes", i + 1, describe(entry)));
            continue;
        }
        const std::string& name = entry.as_string()->get();
        if (!repeats && std::find(out.begin(), out.end(), name) != out.end())
            problemAt(key, i, fmt::format("\"{}\" occurs twice, expected each once", name));
        else
            out.push_back(name);
    }
    return out;
}

void TomlTable::checkKnown(std::string_view key, std::string_view found, Names known,
                           std::string_view section) {
    if (known.empty() || std::find(known.begin(), known.end(), found) != known.end()) return;
    std::size_t index = 0;
    if (const toml::array* list = has(key) ? table_->get(key)->as_array() : nullptr)
        while (index < list->size() && (*list)[index].value<std::string_view>() != found) ++index;
    problemAt(key, index, fmt::format("there is no \"{}\" in {}", found, section), proposeName(found, known));
}

std::vector<std::string> TomlTable::namesOf(std::string_view key, Names known, std::string_view section,
                                            bool required) {
    std::vector<std::string> out = names(key, 1, required);
    for (const std::string& name : out) checkKnown(key, name, known, section);
    return out;
}

std::map<std::string, std::string> TomlTable::levels(std::string_view key) {
    constexpr std::string_view expected = "a table such as {factor = \"level\"}";
    const toml::node* node = find(key, false, expected);
    if (node == nullptr) return {};
    const toml::table* table = node->as_table();
    if (table == nullptr || table->empty()) {
        wrongType(key, *node, expected);
        return {};
    }
    std::map<std::string, std::string> out;
    for (const auto& [factor, level] : *table) {
        if (!isName(factor.str()) || !level.is_string() || !isName(level.as_string()->get()))
            problemAt(
                key, factor.str(),
                fmt::format("found {}, expected a name in quotes, and a name before it", describe(level)));
        else
            out.emplace(factor.str(), level.as_string()->get());
    }
    return out;
}

std::int64_t TomlTable::whole(std::string_view key, std::int64_t low, std::int64_t high,
                              std::optional<std::int64_t> fallback) {
    const std::string expected = high == std::numeric_limits<std::int64_t>::max()
                                     ? fmt::format("a whole number, {} or more", low)
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

int TomlTable::count(std::string_view key, int low, int high, std::optional<int> fallback) {
    return static_cast<int>(whole(key, low, high, fallback));
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

std::optional<std::size_t> TomlTable::choice(std::string_view key, Names names, bool required) {
    const std::string expected = names.size() == 1 ? fmt::format("\"{}\"", names.front())
                                                   : fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
    const toml::node* node = find(key, required, expected);
    if (node == nullptr) return {};
    const std::optional<std::string_view> found = node->value_exact<std::string_view>();
    const auto place = found ? std::find(names.begin(), names.end(), *found) : names.end();
    if (place == names.end()) {
        const std::string_view nearest = found ? nearestName(*found, names) : std::string_view{};
        problem(key, fmt::format("found {}, expected {}", describe(*node), expected),
                nearest.empty() ? "" : fmt::format("Did you mean {}?", nearest));
        return {};
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
            problemAt(key, i, fmt::format("entry {} is {}, expected {}", i + 1, describe(entry), expected));
        else
            values[i] = *value;
    }
    return {values[0], values[1]};
}

std::pair<double, double> TomlTable::range(std::string_view key, double low, double high) {
    const auto [a, b] = pair(key, low, high);
    if (a > b && sound(key))
        problem(key, fmt::format("found [{}, {}], expected the smaller number first", a, b));
    return {a, b};
}

}  // namespace deixis::studies
