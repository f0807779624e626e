#include "compression.hpp"

#include <brotli/encode.h>
#include <zlib.h>

#include <cstdint>
#include <sstream>
#include <stdexcept>

#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis::server {

namespace {

constexpr int gzip_window = 15 + 16;  // 16: with gzip's head
constexpr int gzip_memory = 8;
constexpr int quick_gzip = 1, thorough_gzip = 6;
constexpr int quick_brotli = 3, thorough_brotli = 6;

std::string gzipped(std::string_view bytes, int level) {
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, gzip_window, gzip_memory, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("zlib cannot begin");
    std::string out(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const int ended = deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    if (ended != Z_STREAM_END) throw std::runtime_error("zlib cannot end");
    return out;
}

std::string brotlied(std::string_view bytes, int quality) {
    std::size_t size = BrotliEncoderMaxCompressedSize(bytes.size());
    std::string out(size, '\0');
    const auto done = BrotliEncoderCompress(quality, BROTLI_DEFAULT_WINDOW, BROTLI_DEFAULT_MODE, bytes.size(),
                                            reinterpret_cast<const std::uint8_t*>(bytes.data()), &size,
                                            reinterpret_cast<std::uint8_t*>(out.data()));
    if (done == BROTLI_FALSE) throw std::runtime_error("Brotli cannot compress");
    out.resize(size);
    return out;
}

/// Whether "gzip;q=0.5" and the like allow what they name.
bool isAllowed(std::string_view coding) {
    const std::string text = lowerCase(coding);
    const std::size_t at = text.find("q=");
    if (at == std::string::npos) return true;
    const auto weight = finiteNumber(trimmed(std::string_view(text).substr(at + 2)));
    return weight && *weight > 0.0;
}

}  // namespace

const char* codingName(Coding coding) {
    switch (coding) {
        case Coding::gzip:
            return "gzip";
        case Coding::brotli:
            return "br";
        case Coding::none:
            break;
    }
    return "";
}

Coding AcceptedCodings::smallest() const {
    return brotli ? Coding::brotli : gzip ? Coding::gzip : Coding::none;
}

Coding AcceptedCodings::quickest() const {
    return gzip ? Coding::gzip : smallest();
}

AcceptedCodings acceptedCodings(std::string_view header) {
    AcceptedCodings out;
    std::istringstream list{std::string(header)};
    for (std::string one; std::getline(list, one, ',');) {
        const std::string name = lowerCase(trimmed(one.substr(0, one.find(';'))));
        out.gzip = out.gzip || (name == "gzip" && isAllowed(one));
        out.brotli = out.brotli || (name == "br" && isAllowed(one));
    }
    return out;
}

std::optional<std::string> compressed(std::string_view bytes, Coding coding, Effort effort) {
    constexpr std::size_t too_few = 512;
    if (coding == Coding::none || bytes.size() < too_few) return std::nullopt;
    const bool quick = effort == Effort::quick;
    std::string out = coding == Coding::gzip ? gzipped(bytes, quick ? quick_gzip : thorough_gzip)
                                             : brotlied(bytes, quick ? quick_brotli : thorough_brotli);
    if (out.size() >= bytes.size()) return std::nullopt;
    return out;
}

bool isCompressible(std::string_view content_type) {
    return content_type.starts_with("text/") || content_type.starts_with("application/json") ||
           content_type.starts_with("application/manifest+json") || content_type == "image/svg+xml" ||
           content_type == "model/gltf-binary" || content_type == "application/wasm";
}

}  // namespace deixis::server
