// The fonts that boards are drawn with, for windows that draw text of their own.
#pragma once

#include <string>

namespace deixis::renderer {

/// Paths of the faces (TrueType), as found when the program was built.
[[nodiscard]] std::string regularFontFile();
[[nodiscard]] std::string boldFontFile();

}  // namespace deixis::renderer
