// The font that boards are drawn with, for windows that draw text of their own.
#pragma once

#include <string>

namespace deixis::renderer {

/// Path of the regular face (TrueType), as found when the program was built.
[[nodiscard]] std::string regularFontFile();

}  // namespace deixis::renderer
