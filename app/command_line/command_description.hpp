// What the command line says of itself, as plain data: the manual page and the shell's completion are made of
// it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace deixis::app {

struct OptionDescription {
    std::vector<std::string> names;  ///< "-o", "--output"; none for what is told by its place
    std::string value;               ///< "TEXT", or "STUDY" of what is told by its place; none for a flag
    std::vector<std::string> choices;
    bool value_optional = false;
    bool repeated = false;
    bool required = false;
    std::string text;  ///< sentences, with limits and default
};

struct CommandDescription {
    std::string name;  ///< with those above it: "deixis clips info"
    std::string text;
    std::string footer;  ///< examples and more, as help prints them
    std::vector<OptionDescription> options;
    std::vector<CommandDescription> commands;
};

/// A command with all below it but those that help leaves out. Defaults that are files that ship are named
/// without their folder, which differs between installations.
[[nodiscard]] CommandDescription describe(const CLI::App& app, const std::string& above = "");

}  // namespace deixis::app
