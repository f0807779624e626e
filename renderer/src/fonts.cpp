#include "renderer/fonts.hpp"

namespace deixis::renderer {

std::string regularFontFile() {
    return DEIXIS_FONT_REGULAR;
}

std::string boldFontFile() {
    return DEIXIS_FONT_BOLD;
}

}  // namespace deixis::renderer
