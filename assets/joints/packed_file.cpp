#include "packed_file.hpp"

#include <zlib.h>

#include <memory>
#include <vector>

namespace deixis::assets {

namespace {

constexpr std::size_t largest = std::size_t{4} << 30U;

Result<std::string> unpack(const std::filesystem::path& path) {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), &gzclose);
    if (!file) return fail(path.string(), "cannot be opened");
    std::string text;
    std::vector<char> buffer(1 << 16);
    for (;;) {
        const int count = gzread(file.get(), buffer.data(), static_cast<unsigned>(buffer.size()));
        int code = Z_OK;
        const char* problem = gzerror(file.get(), &code);
        if (count < 0 || (code != Z_OK && code != Z_STREAM_END))
            return fail(path.string(),
                        std::string("found damaged gzip data (") + problem + "), expected a whole file");
        if (count == 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
        if (text.size() > largest) return fail(path.string(), "unpacks to more than 4 GiB, expected a clip");
    }
}

}  // namespace

Result<std::string> readUnpacked(const std::filesystem::path& path) {
    auto bytes = readFile(path);
    if (!bytes || !bytes->starts_with("\x1f\x8b")) return bytes;
    return unpack(path);
}

}  // namespace deixis::assets
