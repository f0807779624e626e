#include "renderer/fonts.hpp"

namespace deixis::renderer {

std::string regularFontFile() {
    return DEIXIS_FONT_REGULAR;
}

std::string boldFontFile() {
    return DEIXIS_FONT_BOLD;
}

std::string regularHangulFontFile() {
    return DEIXIS_FONT_HANGUL_REGULAR;
}

std::string boldHangulFontFile() {
    return DEIXIS_FONT_HANGUL_BOLD;
}

}  // namespace deixis::renderer
