// What `--help` says about a command besides its options.
#pragma once

#include "app/program/parser.hpp"

namespace deixis::app {

/// What stands below the options of a command.
struct CommandText {
    const char* writes;   ///< what is written, and where to
    const char* example;  ///< a line to be typed; several are divided by '\n'
    const char* page;     ///< the page that tells more, such as "docs/analysis.md"
};

void describe(Parser command, const CommandText& text);

}  // namespace deixis::app
