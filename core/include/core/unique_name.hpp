// Names that nobody else has: of what is being written and not yet there.
#pragma once

#include <string>

namespace deixis {

/// 16 hexadecimal digits by chance: others for every call, in every thread, process and machine.
[[nodiscard]] std::string uniqueName();

}  // namespace deixis
