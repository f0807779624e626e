#include "renderer/fonts.hpp"

namespace deixis::renderer {

std::string regularFontFile() {
    return DEIXIS_FONT_REGULAR;
}

}  // namespace deixis::renderer
