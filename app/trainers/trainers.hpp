// The trainers of the program deixis-train.
#pragma once

#include "app/learning_commands/trainers.hpp"

namespace deixis::app {

[[nodiscard]] Trainers trainers();

}  // namespace deixis::app
