// The fonts of the boards, for windows that draw their own text.
#pragma once

#include <string>

namespace deixis::renderer {

/// Paths of the faces (TrueType), which ship.
[[nodiscard]] std::string regularFontFile();
[[nodiscard]] std::string boldFontFile();
/// For the characters that those lack: Hangul.
[[nodiscard]] std::string regularHangulFontFile();
[[nodiscard]] std::string boldHangulFontFile();

/// Size at which a Hangul face goes with one of the others, as a part of that one's: their lines differ in
/// height for letters of the same size.
constexpr float hangul_size = 0.86F;

}  // namespace deixis::renderer
