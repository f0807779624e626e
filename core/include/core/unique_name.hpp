// Unique names for files that are being written.
#pragma once

#include <string>

namespace deixis {

/// 16 hexadecimal digits by chance: others for every call, in every thread, process and machine.
[[nodiscard]] std::string uniqueName();

}  // namespace deixis
