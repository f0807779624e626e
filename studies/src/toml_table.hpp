// A TOML file read key by key, every key checked; private to studies.
#pragma once

#include <toml++/toml.h>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::studies {

/// What is being read and the first problem met. Getters go on after a problem and give harmless values, so
/// that a loader reads straight down and looks once, at the end.
struct TomlProblems {
    std::string file;
    std::optional<Error> first{};

    /// Notes a problem at a line (0: unknown) and a dotted key, unless there was one before.
    void add(std::uint32_t line, std::string_view key, std::string message, std::string mend = {});
};

/// Parses; a syntax error names file and line.
[[nodiscard]] Result<toml::table> parseToml(const std::string& file, std::string_view bytes);

/// The name nearest to `found` as a proposal ("Did you mean x?"), or the whole list where none is near.
[[nodiscard]] std::string proposeName(std::string_view found, std::span<const std::string_view> names);

/// One table. Its keys are known beforehand; an unknown one is a problem at once, with a proposal.
class TomlTable {
  public:
    /// `prefix` is the table's dotted key, empty for the whole file. A null table (a missing section) is read
    /// as an empty one.
    TomlTable(const toml::table* table, std::string prefix, std::span<const std::string_view> known,
              TomlProblems& problems);

    [[nodiscard]] bool has(std::string_view key) const;

    /// Getters: without a fallback the key must be there. Numbers must lie within the limits, ends included.
    [[nodiscard]] std::string text(std::string_view key, std::optional<std::string> fallback = {});
    [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::size_t least, std::size_t most);
    [[nodiscard]] std::int64_t whole(std::string_view key, std::int64_t low, std::int64_t high,
                                     std::optional<std::int64_t> fallback = {});
    [[nodiscard]] double number(std::string_view key, double low, double high,
                                std::optional<double> fallback = {});
    [[nodiscard]] bool flag(std::string_view key, bool fallback);
    /// The place in `names` of the text found.
    [[nodiscard]] std::size_t choice(std::string_view key, std::span<const std::string_view> names,
                                     std::size_t fallback);
    /// A list [a, b] of two numbers within the limits.
    [[nodiscard]] std::pair<double, double> pair(std::string_view key, double low, double high);

    /// [key]; null where it is missing (a problem if `required`).
    [[nodiscard]] const toml::table* section(std::string_view key, bool required);
    /// [[key]], at least one.
    [[nodiscard]] std::vector<const toml::table*> sections(std::string_view key);

    /// Notes a problem with the value of `key`, or with the table where the key is missing.
    void problem(std::string_view key, std::string message, std::string mend = {});

  private:
    [[nodiscard]] const toml::node* find(std::string_view key, bool required, std::string_view expected);
    [[nodiscard]] std::string dotted(std::string_view key) const;
    void wrongType(std::string_view key, const toml::node& found, std::string_view expected);

    const toml::table* table_;
    std::string prefix_;
    std::vector<std::string_view> known_;
    TomlProblems& problems_;
};

}  // namespace deixis::studies
