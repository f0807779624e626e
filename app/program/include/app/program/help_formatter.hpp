// How `--help` reads.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace deixis::app {

/// Names values and limits in words, and breaks lines at 100 columns. Commands inherit it from the program.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> helpFormatter();

/// Gives the values of options that take text the names that help shows, such as FILE.
void nameValues(CLI::App& cli);

}  // namespace deixis::app
