#include "renderer/boards/fonts.hpp"

#include "assets/data/data_paths.hpp"

namespace deixis::renderer {

std::string regularFontFile() {
    return assets::dataFile("fonts/regular.ttf").string();
}

std::string boldFontFile() {
    return assets::dataFile("fonts/bold.ttf").string();
}

std::string regularHangulFontFile() {
    return assets::dataFile("fonts/hangul_regular.ttf").string();
}

std::string boldHangulFontFile() {
    return assets::dataFile("fonts/hangul_bold.ttf").string();
}

}  // namespace deixis::renderer
