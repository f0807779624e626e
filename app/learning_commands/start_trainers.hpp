// The program that trains, deixis-train.
#pragma once

#include "app/learning_commands/trainers.hpp"

namespace deixis::app {

/// Those of this program; none in deixis.
[[nodiscard]] const Trainers* trainersHere();

/// Starts deixis-train in place of this program, with the same arguments. Returns only where it is not there.
[[nodiscard]] tl::unexpected<Error> startTrainers();

}  // namespace deixis::app
