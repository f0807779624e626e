// What every command needs: how it is declared, its progress, and what the program says about itself. Each
// `add...Command` of the command rooms declares a subcommand and its options; when the command line names
// it, `chosen` becomes what to run.
#pragma once

#include <functional>

#include "app/program/parser.hpp"
#include "core/error.hpp"

namespace deixis::app {

using Command = std::function<Result<void>()>;

void addDescribeCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
