#include <png.h>

#include <string>

#include "core/files.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::renderer {

Result<void> writePng(const std::filesystem::path& path, const Image& image) {
    const std::size_t expected =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3U;
    if (image.width <= 0 || image.height <= 0 || image.rgb.size() != expected)
        return fail(path.string(), "the picture has " + std::to_string(image.rgb.size()) +
                                       " bytes, expected " + std::to_string(image.width) + " x " +
                                       std::to_string(image.height) + " x 3");
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t bytes = 0;
    std::string file;
    bool good = png_image_write_to_memory(&png, nullptr, &bytes, 0, image.rgb.data(), 0, nullptr) != 0;
    if (good) {
        file.resize(bytes);
        good = png_image_write_to_memory(&png, file.data(), &bytes, 0, image.rgb.data(), 0, nullptr) != 0;
    }
    const std::string message = png.message;
    png_image_free(&png);
    if (!good) return fail(path.string(), "libpng could not encode the picture: " + message);
    return writeFileUnsynced(path, file);
}

}  // namespace deixis::renderer
