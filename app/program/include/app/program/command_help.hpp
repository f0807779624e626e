// What `--help` says of a command: how it reads, and what every command must tell beside its options.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace deixis::app {

/// What stands below the options of a command.
struct CommandText {
    const char* writes;   ///< what is written, and where to
    const char* example;  ///< a line to be typed; several are divided by '\n'
    const char* page;     ///< the page that tells more, such as "docs/analysis.md"
};

void describe(CLI::App& command, const CommandText& text);

/// Names values and limits in words, and breaks lines at 100 columns. Commands inherit it from the program.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> helpFormatter();

/// Gives the values of options that take text the names that help shows, such as FILE.
void nameValues(CLI::App& cli);

}  // namespace deixis::app
