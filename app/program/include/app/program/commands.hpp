// What every command needs: how it is declared, its progress, and what the program says of itself. Each
// `add...Command` of the rooms of commands declares a subcommand and its options; when the command line names
// it, `chosen` becomes what is to be done.
#pragma once

#include <functional>

#include "app/program/parser.hpp"
#include "core/error.hpp"

namespace deixis::app {

using Command = std::function<Result<void>()>;

void addDescribeCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
