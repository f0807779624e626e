// A TOML file read key by key, with every key checked and every problem collected; private to studies.
#pragma once

#include <toml++/toml.h>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/nearest_name.hpp"

namespace deixis::studies {

class TextBook;

/// The problems of one file. Readers continue after a problem with harmless values, so that all are found.
class Problems {
  public:
    explicit Problems(std::string file) : file_(std::move(file)) {}

    /// Notes a problem at a place (none: line 0) and a dotted key.
    void add(toml::source_position at, std::string_view key, std::string message, std::string hint = {});
    /// Notes the problems of another file, which is named here.
    void add(toml::source_position at, std::vector<Error> others);
    /// All, in the order of the file.
    [[nodiscard]] std::vector<Error> sorted() const;
    [[nodiscard]] bool none() const { return found_.empty(); }

  private:
    struct Found {
        toml::source_position at;
        Error error;
    };
    std::string file_;
    std::vector<Found> found_;
};

/// Parses; a syntax error names file and line.
[[nodiscard]] Result<toml::table> parseToml(const std::string& file, std::string_view bytes);

/// Reads the file and parses it.
[[nodiscard]] Result<toml::table> readToml(const std::filesystem::path& path);

/// The nearest name as a proposal ("Did you mean x?"), or the whole list where none is near.
[[nodiscard]] std::string proposeName(std::string_view found, std::span<const std::string_view> names);

/// A value as an error shows it.
[[nodiscard]] std::string describe(const toml::node& node);
/// Line ends inside a paragraph count as spaces; a blank line parts paragraphs. So a long text can be wrapped
/// in the file and again, to the panel's width, on the panel.
[[nodiscard]] std::string unwrapped(std::string_view text);
/// Names stand in file names, tables and command lines: 1 to 48 letters A-Z a-z, digits, '-' and '_'.
[[nodiscard]] bool isName(std::string_view text);

/// One table. Its keys are known beforehand; an unknown one is a problem at once, with a proposal.
///
/// A null table (a section that is missing) has all its keys missing, without a problem for each.
class TomlTable {
  public:
    using Names = std::span<const std::string_view>;

    /// `prefix` is the table's dotted key, empty for the whole file; `texts` gives the participant's texts.
    TomlTable(const toml::table* table, std::string prefix, Names known, Problems& problems, TextBook& texts);

    [[nodiscard]] bool has(std::string_view key) const;
    /// Whether it is there and nothing is wrong with it so far.
    [[nodiscard]] bool sound(std::string_view key) const { return has(key) && bad_.count(key) == 0; }
    [[nodiscard]] bool faulty(std::string_view key) const { return bad_.count(key) > 0; }
    /// The keys that are there, in the order of their names.
    [[nodiscard]] std::vector<std::string_view> keys() const;

    /// Getters: without a fallback the key must be there. Numbers must lie within the limits, ends included.
    /// note: a text as it stands; text: what the participant reads, see TextBook.
    [[nodiscard]] std::string note(std::string_view key, std::optional<std::string> fallback = {});
    [[nodiscard]] std::string text(std::string_view key, std::optional<std::string> fallback = {});
    [[nodiscard]] std::string name(std::string_view key, std::optional<std::string> fallback = {});
    [[nodiscard]] std::vector<std::string> texts(std::string_view key);  ///< empty if it is missing
    [[nodiscard]] std::int64_t whole(std::string_view key, std::int64_t low, std::int64_t high,
                                     std::optional<std::int64_t> fallback = {});
    [[nodiscard]] int count(std::string_view key, int low, int high, std::optional<int> fallback = {});
    [[nodiscard]] double number(std::string_view key, double low, double high,
                                std::optional<double> fallback = {});
    [[nodiscard]] bool flag(std::string_view key, bool fallback);
    /// The place in `names` of the text found.
    [[nodiscard]] std::optional<std::size_t> choice(std::string_view key, Names names, bool required);
    /// A list [a, b] of two numbers within the limits; `range`: the smaller first.
    [[nodiscard]] std::pair<double, double> pair(std::string_view key, double low, double high);
    [[nodiscard]] std::pair<double, double> range(std::string_view key, double low, double high);
    /// A list of names; none twice unless `repeats`.
    [[nodiscard]] std::vector<std::string> names(std::string_view key, std::size_t min, bool required,
                                                 bool repeats = false);
    /// The same, out of `known`, which stand in `section`. Where `known` is empty, which is told elsewhere,
    /// any name passes.
    [[nodiscard]] std::vector<std::string> namesOf(std::string_view key, Names known,
                                                   std::string_view section, bool required);
    void checkKnown(std::string_view key, std::string_view found, Names known, std::string_view section);
    /// {factor = "level"}: names to names.
    [[nodiscard]] std::map<std::string, std::string> levels(std::string_view key);

    /// [key]; null if it is missing (a problem if `required`).
    [[nodiscard]] const toml::table* section(std::string_view key, bool required);
    /// [[key]]; none if it is missing (a problem if `required`).
    [[nodiscard]] std::vector<const toml::table*> sections(std::string_view key, bool required);
    /// The table below [key] or one of [[key]], with the keys that it may have.
    [[nodiscard]] TomlTable below(std::string_view key, const toml::table* table, Names known) const;

    /// Notes a problem with the value of `key`, or with the table where the key is missing.
    void problem(std::string_view key, std::string message, std::string hint = {});
    /// The same with entry `index` of a list, or entry `name` of a table.
    void problemAt(std::string_view key, std::size_t index, std::string message, std::string hint = {});
    void problemAt(std::string_view key, std::string_view name, std::string message, std::string hint = {});
    /// Notes that `key`, where it is there, does not go with what else is written.
    void reject(std::string_view key, std::string_view why);
    [[nodiscard]] toml::source_position place(std::string_view key) const;
    [[nodiscard]] std::string dotted(std::string_view key) const;

  private:
    [[nodiscard]] const toml::node* find(std::string_view key, bool required, std::string_view expected);
    [[nodiscard]] std::string textOf(std::string_view key, const toml::node& node);
    void wrongType(std::string_view key, const toml::node& found, std::string_view expected);

    const toml::table* table_;
    std::string prefix_;
    std::vector<std::string_view> known_;
    std::set<std::string, std::less<>> meant_{};  ///< what an unknown key was probably to be
    std::set<std::string, std::less<>> bad_{};
    Problems* problems_;
    TextBook* texts_;
};

}  // namespace deixis::studies
