// deixis evaluate gestures.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addEvaluateGesturesCommand(Parser evaluate, Command& chosen);

}  // namespace deixis::app
